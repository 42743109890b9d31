#include <apps/draw/shaders.h>

namespace hair::draw::shaders {
namespace {

const std::string kVersion = "#version 330 core\n";

// FrameBlock, and what several shaders compute from it.
const std::string kFrame = kVersion + R"(
layout(std140) uniform Frame {
  mat4 clipFromWorld;
  mat4 shadowFromWorld[4];
  vec4 lightPlace[4];
  vec4 lightColour[4];
  vec4 lightTexel;
  vec4 eye;
  vec4 allLights;
  vec4 sky;
  vec4 backgroundMiddle;
  vec4 backgroundEdge;
  vec4 viewport;
  vec4 groundColour;
  vec4 groundPlace;
  vec4 floorMap;
  vec4 shadowTexel;
};
uniform sampler2DArrayShadow meshShadow;
uniform sampler2DArray hairShadow;
uniform sampler2D floorOcclusion;

vec3 linearFromSrgb(vec3 c) { return pow((c + 0.055) / 1.055, vec3(2.4)); }

int lightCount() { return int(allLights.w); }

// What arrives of a light at a point, were nothing in between.
struct Ray {
  vec3 towards;  // the light, unit
  vec3 colour;
  float texel;   // metres of a texel of its shadow map here
};
Ray rayOf(int light, vec3 world) {
  vec3 way = lightPlace[light].xyz, colour = lightColour[light].rgb;
  if (lightPlace[light].w == 0.0) return Ray(way, colour, lightTexel[light]);
  way -= world;
  float far = max(length(way), 0.01);
  return Ray(way / far, colour / (far * far), lightTexel[light] * far);
}

// Share of a light that meshes let through to a point; four filtered look-ups. All of it behind a
// light at a point and outside of its map.
float pastMeshes(int light, vec3 world) {
  vec4 h = shadowFromWorld[light] * vec4(world, 1);
  if (h.w <= 0.0) return 1.0;
  vec3 p = h.xyz / h.w;
  // Beyond all casters: whatever is there is in between.
  vec4 q = vec4(p.xy, light, min(p.z, 0.99999));
  float s = 0.0, o = 0.8 * shadowTexel.x;
  s += texture(meshShadow, q + vec4(-o, -o, 0, 0));
  s += texture(meshShadow, q + vec4(o, -o, 0, 0));
  s += texture(meshShadow, q + vec4(-o, o, 0, 0));
  s += texture(meshShadow, q + vec4(o, o, 0, 0));
  return 0.25 * s;
}

// Share of a light that hair lets through to a surface the light sees: the map holds the optical
// depth of all hair in front of the first mesh, which is just such a surface.
float pastHair(int light, vec3 world) {
  vec4 h = shadowFromWorld[light] * vec4(world, 1);
  if (h.w <= 0.0) return 1.0;
  vec3 p = vec3(h.xy / h.w, light);
  float d = 0.0, o = 1.5 * shadowTexel.x;
  d += texture(hairShadow, p + vec3(-o, -o, 0)).r;
  d += texture(hairShadow, p + vec3(o, -o, 0)).r;
  d += texture(hairShadow, p + vec3(-o, o, 0)).r;
  d += texture(hairShadow, p + vec3(o, o, 0)).r;
  return exp(-0.25 * d);
}

// The studio's wall; dithered, or eight bits would show as rings.
vec3 backdrop(vec2 pixel) {
  vec2 p = (pixel - viewport.xy) / viewport.zw - vec2(0.5, 0.55);
  vec2 q = pixel - viewport.xy;
  float noise = fract(52.9829189 * fract(dot(q, vec2(0.06711056, 0.00583715)))) - 0.5;
  vec3 c = mix(backgroundMiddle.rgb, backgroundEdge.rgb, smoothstep(0.0, 0.62, dot(p, p)));
  return c * (1.0 + 0.008 * noise);
}

// Linear light to what a display shows, still linear: rolls off like film (Narkowicz 2016).
vec3 film(vec3 c) {
  c *= 0.62;
  return clamp(c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14), 0.0, 1.0);
}
)";

const std::string kWholeViewport = R"(
void main() {
  gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 1, 1);
}
)";

}  // namespace

Source background() {
  return {kVersion + kWholeViewport, "", kFrame + R"(
out vec4 pixel;
void main() { pixel = vec4(backdrop(gl_FragCoord.xy), 1); }
)"};
}

Source ground() {
  return {kFrame + R"(
out vec3 world;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  world = vec3(groundPlace.xy + groundPlace.w * corner, groundColour.w).xzy;
  gl_Position = clipFromWorld * vec4(world, 1);
}
)",
          "", kFrame + R"(
in vec3 world;
out vec4 pixel;
void main() {
  vec3 wall = backdrop(gl_FragCoord.xy);
  float far = smoothstep(0.15, 1.0, distance(world.xz, groundPlace.xy) / groundPlace.w);
  // The floor is the wall's own paper, rolled out: where nothing stands in the light it looks so.
  vec2 q = (world.xz - floorMap.xy) * floorMap.z;
  float open = 1.0;
  if (floorMap.w > 0.0 && clamp(q, 0.0, 1.0) == q) open = texture(floorOcclusion, q).r;
  // Lights' colours go into the shadows they leave, not into the paper, which stays the wall's.
  vec3 full = sky.rgb, here = sky.rgb * open;
  for (int i = 0; i < lightCount(); ++i) {
    Ray ray = rayOf(i, world);
    if (ray.towards.y <= 0.0) continue;
    float lit = pastMeshes(i, world + vec3(0, 2.0 * ray.texel, 0));
    if (lit > 0.0) lit *= pastHair(i, world);
    full += ray.colour * ray.towards.y;
    here += ray.colour * ray.towards.y * lit;
  }
  vec3 paper = film(groundColour.rgb * here);
  vec3 unshadowed = film(groundColour.rgb * full);
  vec3 c = mix(paper, wall * paper / max(unshadowed, 1e-3), 0.65);
  pixel = vec4(mix(c, wall, far), 1);
}
)"};
}

Source mesh() {
  return {kFrame + R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 tint;
uniform mat4 worldFromMesh;
uniform mat3 worldFromNormal;
out vec3 world;
out vec3 worldNormal;
out vec3 vertexTint;
void main() {
  vertexTint = tint;
  world = (worldFromMesh * vec4(position, 1)).xyz;
  worldNormal = worldFromNormal * normal;
  gl_Position = clipFromWorld * vec4(world, 1);
}
)",
          "", kFrame + R"(
in vec3 world;
in vec3 worldNormal;
in vec3 vertexTint;
uniform vec3 albedo;
uniform float roughness;
out vec4 pixel;

// Microfacets (GGX) with Schlick's Fresnel and a cheap visibility term.
float gloss(vec3 n, vec3 v, vec3 l) {
  vec3 h = normalize(v + l);
  float a = roughness * roughness, nh = max(dot(n, h), 0.0), lh = max(dot(l, h), 0.0);
  float d = nh * nh * (a * a - 1.0) + 1.0;
  float fresnel = 0.04 + 0.96 * pow(1.0 - lh, 5.0);
  return fresnel * a * a / (4.0 * d * d * max(lh * lh * (roughness + 0.5), 0.05));
}

void main() {
  vec3 v = normalize(eye.xyz - world);
  vec3 n = normalize(worldNormal);
  if (dot(n, v) < 0.0 && !gl_FrontFacing) n = -n;
  // Light wanders a little under the surface: past the terminator, and redder there.
  vec3 wrap = vec3(0.11, 0.07, 0.055);
  vec3 bounce = groundColour.rgb * (0.35 * sky.rgb + 0.05 * allLights.rgb);
  vec3 around = mix(bounce, sky.rgb, 0.5 + 0.5 * n.y);
  float rim = pow(1.0 - max(dot(n, v), 0.0), 4.0);
  vec3 own = around, shine = vec3(0);
  for (int i = 0; i < lightCount(); ++i) {
    Ray ray = rayOf(i, world);
    float nl = dot(n, ray.towards);
    if (nl <= -0.2) continue;
    // Off the surface by more than a shadow texel sees of its slope.
    float lit = pastMeshes(i, world + n * (2.5 * ray.texel));
    if (lit > 0.0) lit *= pastHair(i, world);
    vec3 diffuse = clamp((vec3(nl) + wrap) / ((1.0 + wrap) * (1.0 + wrap)), 0.0, 1.0);
    own += ray.colour * diffuse * lit;
    shine += ray.colour * gloss(n, v, ray.towards) * max(nl, 0.0) * lit;
  }
  vec3 c = albedo * vertexTint * own + shine + 0.25 * around * rim;
  pixel = vec4(film(c), 1);
}
)"};
}

Source depthOnly() {
  return {kVersion + R"(
layout(location = 0) in vec3 position;
uniform mat4 clipFromMesh;
void main() { gl_Position = clipFromMesh * vec4(position, 1); }
)",
          "", kVersion + "void main() {}\n"};
}

Source hairDepth() {
  return {kVersion + R"(
layout(location = 0) in vec3 position;
layout(location = 2) in float along;
uniform mat4 clipFromWorld;
uniform float rootDepth, tipWidth;
out float depth;
void main() {
  gl_Position = clipFromWorld * vec4(position, 1);
  depth = rootDepth * mix(1.0, tipWidth, along * along) / max(gl_Position.w, 1e-3);
}
)",
          "", kVersion + R"(
in float depth;
out float sum;
void main() { sum = depth; }
)"};
}

Source floorOcclusion() {
  return {kVersion + R"(
out vec2 place;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  place = corner;
  gl_Position = vec4(corner * 2.0 - 1.0, 0, 1);
}
)",
          "", kVersion + R"(
in vec2 place;
uniform sampler2D lowest;   // height of the lowest mesh over the floor, as depth
uniform vec2 side;          // x: metres of the map, y: metres of depth 1
out float open;
// A horizontal element dA at height h and distance r hides h^2 / (pi (h^2 + r^2)^2) dA of the sky's
// light. The spiral is denser near the middle: r = R u^2, so dA = 4 pi R^2 u^3 / N.
void main() {
  const int N = 40;
  const float R = 0.5;
  float hidden = 0.0;
  for (int i = 0; i < N; ++i) {
    float u = (float(i) + 0.5) / float(N), r = R * u * u, a = 2.3999632 * float(i);
    float z = texture(lowest, place + r / side.x * vec2(cos(a), sin(a))).r;
    float h = max(z * side.y, 0.008), s = h * h + r * r;
    if (z < 1.0) hidden += 4.0 * R * R * u * u * u * h * h / (s * s * float(N));
  }
  open = clamp(1.0 - hidden, 0.0, 1.0);
}
)"};
}

Source debug() {
  return {kFrame + R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 colour;
out vec4 shade;
void main() {
  gl_Position = clipFromWorld * vec4(position, 1);
  shade = vec4(linearFromSrgb(colour.rgb), colour.a);
}
)",
          "", kVersion + R"(
in vec4 shade;
out vec4 pixel;
void main() { pixel = shade; }
)"};
}

Source hairLines() {
  return {kFrame + R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 colour;
layout(location = 2) in float along;
layout(location = 3) in vec3 radiance;
uniform bool radiant;  // into a linear picture: of radiance, not of the bytes made of it
uniform vec3 strand;  // width, opacity, tip width
out vec4 shade;
void main() {
  gl_Position = clipFromWorld * vec4(position, 1);
  float width = strand.x * mix(1.0, strand.z, along * along);
  float pixels = width * eye.w / max(gl_Position.w, 1e-4);
  // A line is a pixel wide: what is thinner covers its share of it.
  vec3 light = radiant ? radiance : linearFromSrgb(colour.rgb);
  shade = vec4(light, strand.y * colour.a * min(pixels, 1.0));
}
)",
          "", kVersion + R"(
in vec4 shade;
out vec4 pixel;
void main() { pixel = shade; }
)"};
}

Source hairRibbons() {
  return {kFrame + R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 colour;
layout(location = 2) in float along;
layout(location = 3) in vec3 radiance;
uniform bool radiant;  // into a linear picture: of radiance, not of the bytes made of it
uniform vec3 strand;
out Point { vec4 shade; float pixels; } point;
void main() {
  gl_Position = clipFromWorld * vec4(position, 1);
  float width = strand.x * mix(1.0, strand.z, along * along);
  point.pixels = width * eye.w / max(gl_Position.w, 1e-4);
  vec3 light = radiant ? radiance : linearFromSrgb(colour.rgb);
  point.shade = vec4(light, strand.y * colour.a);
}
)",
          kFrame + R"(
layout(lines_adjacency) in;
layout(triangle_strip, max_vertices = 4) out;
in Point { vec4 shade; float pixels; } point[4];
out vec4 shade;
noperspective out float across;   // pixels from the middle line
noperspective out float halfWidth;

vec2 onScreen(vec4 clip) { return 0.5 * viewport.zw * clip.xy / clip.w; }

vec2 direction(vec2 from, vec2 to, vec2 otherwise) {
  vec2 d = to - from;
  float l = length(d);
  return l > 1e-3 ? d / l : otherwise;
}

// Both ribbons that meet at a point lean on the same cross-section there, so no gap opens.
void side(int i, vec2 along) {
  float w = max(point[i].pixels, 1.0), reach = 0.5 * w + 0.5;
  vec2 offset = vec2(-along.y, along.x) * reach * 2.0 / viewport.zw;
  vec4 clip = gl_in[i].gl_Position;
  shade = vec4(point[i].shade.rgb, point[i].shade.a * min(point[i].pixels, 1.0));
  halfWidth = 0.5 * w;
  across = reach;
  gl_Position = clip + vec4(offset * clip.w, 0, 0);
  EmitVertex();
  across = -reach;
  gl_Position = clip - vec4(offset * clip.w, 0, 0);
  EmitVertex();
}

void main() {
  for (int i = 0; i < 4; ++i) {
    if (gl_in[i].gl_Position.w < 1e-4) return;
  }
  vec2 s0 = onScreen(gl_in[0].gl_Position), s1 = onScreen(gl_in[1].gl_Position);
  vec2 s2 = onScreen(gl_in[2].gl_Position), s3 = onScreen(gl_in[3].gl_Position);
  vec2 own = direction(s1, s2, vec2(0, 1));
  side(1, direction(s0, s2, own));
  side(2, direction(s1, s3, own));
  EndPrimitive();
}
)",
          kVersion + R"(
in vec4 shade;
noperspective in float across;
noperspective in float halfWidth;
out vec4 pixel;
// How much of a pixel, one wide, the ribbon covers at this distance from its middle.
void main() {
  float covered = clamp(halfWidth + 0.5 - abs(across), 0.0, 1.0);
  pixel = vec4(shade.rgb, shade.a * covered);
}
)"};
}

}  // namespace hair::draw::shaders
