// What pictures must show, read back pixel by pixel.

#include <cmath>
#include <numbers>
#include <optional>

#include <apps/draw/gl_context.h>
#include <apps/draw/renderer.h>
#include <gtest/gtest.h>

#include <libhair/core/error.h>

using namespace hair;
using namespace hair::draw;

namespace {

TriangleMesh sphere(glm::vec3 centre, float radius) {
  constexpr unsigned kRound = 32, kDown = 16;
  TriangleMesh mesh;
  for (unsigned j = 0; j <= kDown; ++j) {
    for (unsigned i = 0; i <= kRound; ++i) {
      const float p = std::numbers::pi_v<float> * float(j) / kDown;
      const float q = 2 * std::numbers::pi_v<float> * float(i) / kRound;
      mesh.positions.push_back(centre + radius * glm::vec3(std::sin(p) * std::cos(q), std::cos(p),
                                                           std::sin(p) * std::sin(q)));
    }
  }
  for (unsigned j = 0; j < kDown; ++j) {
    for (unsigned i = 0; i < kRound; ++i) {
      const unsigned a = j * (kRound + 1) + i, b = a + kRound + 1;
      mesh.triangles.push_back({a, a + 1, b + 1});
      mesh.triangles.push_back({a, b + 1, b});
    }
  }
  computeNormals(mesh);
  return mesh;
}

/// Strands combed from the top of a sphere down its sides, standing off a little.
StrandSet combed(glm::vec3 centre, float radius, int count) {
  StrandSet strands;
  std::vector<glm::vec3> points(16);
  for (int s = 0; s < count; ++s) {
    const float q = 2 * std::numbers::pi_v<float> * float(s) / float(count);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const float p = 0.1f + 1.8f * float(i) / 15;
      points[i] = centre + (radius + 0.01f) * glm::vec3(std::sin(p) * std::cos(q), std::cos(p),
                                                        std::sin(p) * std::sin(q));
    }
    strands.append(points);
  }
  return strands;
}

class Drawing : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    try {
      context.emplace();
    } catch (const Error& error) {
      whyNot = error.what();
    }
  }
  static void TearDownTestSuite() { context.reset(); }

  void SetUp() override {
    if (!context) GTEST_SKIP() << whyNot;
    scene.camera.target = {0, 0.3f, 0};
    scene.camera.distance = 1.5f;
    scene.camera.pitch = 0.35f;
    scene.lights[0].direction = {0, -1, 0};
    head = sphere({0, 0.3f, 0}, 0.1f);
    hair = combed({0, 0.3f, 0}, 0.1f, 800);
    red.assign(hair.pointCount(), packColour({0.9f, 0.1f, 0.1f, 1}));
    dark.assign(hair.pointCount(), packColour({0.1f, 0.05f, 0.02f, 1}));
  }

  void addHead() {
    MeshLayer layer;
    layer.mesh = &head;
    scene.meshes.push_back(layer);
  }
  HairLayer& addHair() {
    HairLayer layer;
    layer.strands = hair;
    layer.colours = red;
    layer.width = 1e-3f;
    scene.hair.push_back(layer);
    return scene.hair.back();
  }
  Picture drawn(int width = 320, int height = 240) {
    Renderer renderer;
    renderer.draw(scene, width, height);
    return renderer.read();
  }

  static int brightness(const std::uint8_t* p) { return p[0] + p[1] + p[2]; }
  static int redPixels(const Picture& picture) {
    int count = 0;
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        const std::uint8_t* p = picture.pixel(x, y);
        count += p[0] > 120 && p[1] < p[0] / 2 && p[2] < p[0] / 2;
      }
    }
    return count;
  }
  /// Pixel under which a point of the world is drawn.
  glm::ivec2 place(glm::vec3 world, int width, int height) const {
    const Camera& c = scene.camera;
    const glm::vec4 clip =
        c.clipFromView(float(width) / float(height)) * c.viewFromWorld() * glm::vec4(world, 1);
    return {int((clip.x / clip.w + 1) / 2 * float(width)),
            int((1 - clip.y / clip.w) / 2 * float(height))};
  }

  static inline std::optional<OffscreenContext> context;
  static inline std::string whyNot;
  Scene scene;
  TriangleMesh head;
  StrandSet hair;
  std::vector<std::uint32_t> red, dark;
};

TEST_F(Drawing, ShowsHairInItsOwnColourWhereItIs) {
  addHead();
  EXPECT_EQ(redPixels(drawn()), 0);
  addHair();
  const Picture lines = drawn();
  EXPECT_GT(redPixels(lines), 500);
  scene.hair[0].primitive = HairPrimitive::Ribbons;
  const Picture ribbons = drawn();
  EXPECT_NEAR(redPixels(ribbons), redPixels(lines), 0.25 * redPixels(lines));

  scene.hair[0].width = 6e-3f, scene.hair[0].opacity = 1;
  const Picture thick = drawn();
  const glm::ivec2 top = place({0, 0.38f, 0.08f}, 320, 240);
  const std::uint8_t* p = thick.pixel(top.x, top.y);
  EXPECT_NEAR(p[0], 230, 1) << "opaque hair shows its sRGB bytes";
  EXPECT_NEAR(p[1], 26, 1);
}

TEST_F(Drawing, ThinnerHairIsFainterNotGone) {
  scene.ground.visible = false;
  HairLayer& layer = addHair();
  double before = 0;
  const Picture empty = [&] {
    Scene without = scene;
    without.hair.clear();
    Renderer renderer;
    renderer.draw(without, 320, 240);
    return renderer.read();
  }();
  for (float width : {2e-5f, 1e-4f, 4e-4f}) {
    layer.width = width;
    const Picture picture = drawn();
    double change = 0;
    for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
      change += std::abs(int(picture.rgb[i]) - int(empty.rgb[i]));
    }
    EXPECT_GT(change, 1.5 * before) << "width " << width;
    before = change;
  }
}

TEST_F(Drawing, MeshesHideTheHairBehindThem) {
  addHair();
  addHead();
  scene.meshes[0].worldFromMesh[3] = glm::vec4(0, 0.05f, 0.3f, 1);
  scene.meshes[0].worldFromMesh[0][0] = scene.meshes[0].worldFromMesh[1][1] = 1.5f;
  EXPECT_LT(redPixels(drawn()), 60);
}

TEST_F(Drawing, HeadAndHairDarkenTheFloorUnderThem) {
  const glm::ivec2 under = place({0.05f, 0, 0}, 320, 240), beside = place({0.35f, 0, 0}, 320, 240);
  const Picture bare = drawn();
  const int lit = brightness(bare.pixel(under.x, under.y));
  const int litBeside = brightness(bare.pixel(beside.x, beside.y));

  addHair().shadowWidth = 2e-3f;
  const Picture byHair = drawn();
  EXPECT_LT(brightness(byHair.pixel(under.x, under.y)), 0.93 * lit);

  scene.hair.clear();
  addHead();
  const Picture byHead = drawn();
  EXPECT_LT(brightness(byHead.pixel(under.x, under.y)), 0.8 * lit);
  EXPECT_NEAR(brightness(byHead.pixel(beside.x, beside.y)), litBeside, 12);
}

TEST_F(Drawing, HairBehindAMeshDoesNotShadowItsFront) {
  addHead();
  const glm::ivec2 top = place({0, 0.395f, 0.03f}, 320, 240);
  const Picture bare = drawn();
  StrandSet below = combed({0, 0.1f, 0}, 0.1f, 800);
  std::swap(hair, below);
  addHair();
  scene.hair[0].width = 1e-5f;
  scene.hair[0].shadowWidth = 1e-2f;
  const Picture picture = drawn();
  EXPECT_NEAR(brightness(picture.pixel(top.x, top.y)), brightness(bare.pixel(top.x, top.y)), 6);
}

TEST_F(Drawing, HalvesAreEqualWhereTheirColoursAre) {
  addHead();
  HairLayer& layer = addHair();
  scene.sideBySide = true;
  const auto difference = [](const Picture& p) {
    const int half = p.width / 2;
    int different = 0;
    for (int y = 0; y < p.height; ++y) {
      for (int x = 0; x < 3 * half; ++x) {
        different += std::abs(p.pixel(0, y)[x] - p.pixel(p.width - half, y)[x]) > 2;
      }
    }
    return different;
  };
  // Half a picture further right, a line may touch another sample here and there.
  EXPECT_LE(difference(drawn()), 3 * 160 * 240 / 500);
  layer.leftColours = dark;
  const Picture picture = drawn();
  EXPECT_GT(difference(picture), 3 * 160 * 240 / 50);
  EXPECT_GT(redPixels(picture), 200) << "the right half keeps the colours";
}

TEST_F(Drawing, TheSameSceneGivesTheSameBytes) {
  addHead();
  addHair();
  const Picture first = drawn();
  EXPECT_EQ(first, drawn());
  Renderer renderer;
  renderer.draw(scene, 100, 60);
  Scene empty;
  renderer.draw(empty, 320, 240);
  renderer.draw(scene, 320, 240);
  EXPECT_EQ(first, renderer.read()) << "what was drawn before shows";
}

TEST_F(Drawing, TakesAnySizeAndReportsImpossibleOnes) {
  addHead();
  addHair();
  Renderer renderer;
  for (const glm::ivec2 size : {glm::ivec2(1, 1), {7, 300}, {641, 3}, {64, 64}}) {
    for (bool sideBySide : {false, true}) {
      scene.sideBySide = sideBySide;
      renderer.draw(scene, size.x, size.y);
      const Picture picture = renderer.read();
      EXPECT_EQ(picture.width, size.x);
      EXPECT_EQ(picture.height, size.y);
      EXPECT_GT(brightness(picture.pixel(size.x / 2, size.y / 2)), 0);
    }
  }
  EXPECT_THROW(renderer.draw(scene, 0, 10), Error);
  EXPECT_THROW(renderer.draw(scene, 10, 100000), Error);
}

TEST_F(Drawing, ScenesThatCannotBeDrawnAreReported) {
  addHair().colours = std::span(red).first(3);
  EXPECT_THROW(drawn(), Error);
  scene.hair.clear();
  scene.lights[0].direction = {0, 0, 0};
  EXPECT_THROW(drawn(), Error);
  scene.lights[0].direction = {0, -1, 0};
  addHead();
  head.normals.pop_back();
  EXPECT_THROW(drawn(), Error);
}

TEST_F(Drawing, MeshesStandInTheLightOfPointsBehindThem) {
  addHead();
  Renderer renderer;
  const std::vector<glm::vec3> points = {{0, 0.6f, 0},    {0, 0.05f, 0},     {0.3f, 0.05f, 0},
                                         {0, 0.4f, 0},    {0.05f, 0.25f, 0}, {0, 0.399f, 0},
                                         {0.1f, 0.05f, 0}};
  std::vector<float> lit(points.size(), -1.0f);
  renderer.meshVisibility(scene, points, lit);
  EXPECT_EQ(lit[0], 1) << "above the head";
  EXPECT_EQ(lit[1], 0) << "under it";
  EXPECT_EQ(lit[2], 1) << "beside its shadow";
  EXPECT_EQ(lit[3], 1) << "a root on its top";
  EXPECT_EQ(lit[4], 0) << "inside";
  EXPECT_EQ(lit[5], 1) << "a root just under its top";
  EXPECT_GT(lit[6], 0) << "at the shadow's edge";
  EXPECT_LT(lit[6], 1) << "at the shadow's edge";
  scene.meshes.clear();
  renderer.meshVisibility(scene, points, lit);
  for (float v : lit) EXPECT_EQ(v, 1);
}

TEST_F(Drawing, EveryLightHasShadowsOfItsOwnOnPoints) {
  addHead();
  Renderer renderer;
  const std::vector<glm::vec3> points = {{0, 0.05f, 0},    {0, 0.55f, 0},    {0.35f, 0.3f, 0},
                                         {0.2f, 0.42f, 0}, {-0.3f, 0.3f, 0}, {0, 0.3f, 0.5f}};
  const auto lit = [&](const std::vector<Light>& lights) {
    scene.lights = lights;
    std::vector<float> visibility(lights.size() * points.size(), -1.0f);
    renderer.meshVisibility(scene, points, visibility);
    return visibility;
  };
  const Light above = Light::parallel({0, -1, 0}), aside = Light::parallel({1, 0, 0});
  // Near by at the left: its shadow is wider than the ball, and holds (0.2, 0.42, 0) too.
  const Light lamp = Light::point({-0.2f, 0.3f, 0});
  const std::vector<float> all = lit({above, lamp, aside});
  const std::vector<float> expected = {0, 1, 1, 1, 1, 1, 1, 1, 0, 0, 1, 1, 1, 1, 0, 1, 1, 1};
  EXPECT_EQ(all, expected);
  std::vector<float> one;
  for (const Light& light : {above, lamp, aside}) {
    const std::vector<float> alone = lit({light});
    one.insert(one.end(), alone.begin(), alone.end());
  }
  EXPECT_EQ(all, one);
  // Far away at a point is parallel.
  EXPECT_EQ(lit({Light::point({0, 100, 0})}), lit({above}));
  std::vector<float> tooFew(points.size());
  scene.lights = {above, lamp};
  EXPECT_THROW(renderer.meshVisibility(scene, points, tooFew), Error);
}

TEST_F(Drawing, EveryLightOfTheFirstFourShinesOnTheMeshes) {
  addHead();
  scene.camera.pitch = 0;
  const glm::ivec2 left = place({-0.07f, 0.3f, 0.07f}, 320, 240),
                   right = place({0.07f, 0.3f, 0.07f}, 320, 240);
  const Light redLight = Light::parallel({1, 0, -0.2f}, {1, 0, 0});
  const Light blueLight = Light::point({0.6f, 0.3f, 0.1f}, {0, 0, 1});
  scene.pivot = {0, 0.3f, 0};
  scene.lights = {};
  const Picture unlit = drawn();
  EXPECT_GT(brightness(unlit.pixel(left.x, left.y)), 0) << "the sky shines";
  const Light black = Light::parallel({0, -1, 0}, {0, 0, 0});
  scene.lights = {black, redLight, black, blueLight};
  const Picture lit = drawn();
  const std::uint8_t *l = lit.pixel(left.x, left.y), *r = lit.pixel(right.x, right.y);
  const std::uint8_t *l0 = unlit.pixel(left.x, left.y), *r0 = unlit.pixel(right.x, right.y);
  EXPECT_GT(l[0], l0[0] + 40) << "red from the left";
  EXPECT_NEAR(l[2], l0[2], 8);
  EXPECT_GT(r[2], r0[2] + 40) << "blue from the right";
  EXPECT_NEAR(r[0], r0[0], 8);
  scene.lights = {black, black, black, black, redLight};
  EXPECT_EQ(drawn(), unlit) << "the fifth does not";
  // Memory of the maps grows and shrinks with the lights.
  Renderer renderer;
  for (const std::vector<Light>& lights : {std::vector<Light>{redLight},
                                           {redLight, blueLight, redLight},
                                           {},
                                           {black, redLight, black, blueLight}}) {
    scene.lights = lights;
    renderer.draw(scene, 320, 240);
  }
  EXPECT_EQ(renderer.read(), lit);
}

TEST_F(Drawing, AHeadShadowsTheFloorFromALampWhereItStandsBetween) {
  scene.camera.pitch = 0.6f;
  scene.pivot = {0, 0.3f, 0};
  scene.lights = {Light::point({0, 0.6f, 0})};
  // Twice as far from the lamp as the ball's rim: its shadow is twice as wide as the ball.
  const glm::ivec2 inside = place({0.15f, 0, 0.05f}, 320, 240),
                   outside = place({0.45f, 0, 0.05f}, 320, 240);
  const Picture empty = drawn();
  addHead();
  const Picture shadowed = drawn();
  EXPECT_LT(brightness(shadowed.pixel(inside.x, inside.y)),
            0.8 * brightness(empty.pixel(inside.x, inside.y)));
  EXPECT_NEAR(brightness(shadowed.pixel(outside.x, outside.y)),
              brightness(empty.pixel(outside.x, outside.y)), 12);
}

// All of one light: what bytes of red are, or brighter.
std::vector<glm::vec3> lightOf(std::size_t points, glm::vec3 linear) {
  return std::vector<glm::vec3>(points, linear);
}

float linearFromSrgb(float c) {
  return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

TEST_F(Drawing, ALinearPictureIsWhatItsBytesAreOf) {
  addHead();
  const std::vector<glm::vec3> light = lightOf(
      hair.pointCount(),
      {linearFromSrgb(230 / 255.0f), linearFromSrgb(26 / 255.0f), linearFromSrgb(26 / 255.0f)});
  for (const HairPrimitive primitive : {HairPrimitive::Lines, HairPrimitive::Ribbons})
    for (const bool sideBySide : {false, true}) {
      scene.hair.clear();
      HairLayer& layer = addHair();
      layer.primitive = primitive;
      layer.radiance = light;
      scene.sideBySide = sideBySide;
      if (sideBySide) layer.leftColours = dark;
      const std::vector<glm::vec3> darkLight = lightOf(
          hair.pointCount(),
          {linearFromSrgb(26 / 255.0f), linearFromSrgb(13 / 255.0f), linearFromSrgb(5 / 255.0f)});
      if (sideBySide) layer.leftRadiance = darkLight;
      const Picture bytes = drawn();
      Renderer renderer({.linear = true});
      renderer.draw(scene, 320, 240);
      const LinearPicture linear = renderer.readLinear();
      double sum = 0;
      for (std::size_t i = 0; i < bytes.rgb.size(); ++i) {
        const float x = linear.rgb[i];
        ASSERT_GE(x, 0);
        ASSERT_LE(x, 1.0001f);
        const float shown = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
        sum += std::abs(255 * double(shown) - bytes.rgb[i]);
      }
      // Bytes are rounded after each strand that is blended.
      EXPECT_LT(sum / double(bytes.rgb.size()), 0.7) << sideBySide;
    }
}

TEST_F(Drawing, ALinearPictureKeepsWhatIsBrighterThanADisplay) {
  scene.ground.visible = false;
  HairLayer& layer = addHair();
  layer.primitive = HairPrimitive::Ribbons;
  layer.width = 6e-3f, layer.opacity = 1, layer.tipWidth = 1;
  const glm::vec3 bright(3.7182f, 0.3141f, 0.0012f);
  const std::vector<glm::vec3> light = lightOf(hair.pointCount(), bright);
  layer.radiance = light;
  Renderer renderer({.linear = true});
  ASSERT_TRUE(renderer.linear());
  renderer.draw(scene, 320, 240);
  const LinearPicture picture = renderer.readLinear();
  int inside = 0;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3)
    if (std::abs(picture.rgb[i] - bright.x) < 1e-4f) {
      ++inside;
      EXPECT_NEAR(picture.rgb[i + 1], bright.y, 1e-4f);
      EXPECT_NEAR(picture.rgb[i + 2], bright.z, 1e-5f);
    }
  EXPECT_GT(inside, 500) << "pixels that are nothing but hair";
}

TEST_F(Drawing, LinearPicturesAndBytesAreNotMixedUp) {
  HairLayer& layer = addHair();
  Renderer linear({.linear = true}), bytes;
  EXPECT_THROW(linear.draw(scene, 32, 24), Error) << "no radiance";
  const std::vector<glm::vec3> light = lightOf(hair.pointCount(), glm::vec3(1));
  layer.radiance = light;
  linear.draw(scene, 32, 24);
  EXPECT_THROW(linear.read(), Error);
  EXPECT_THROW(linear.present(0, 32, 24), Error);
  scene.sideBySide = true;
  layer.leftColours = dark;
  EXPECT_THROW(linear.draw(scene, 32, 24), Error) << "no radiance of the left half";
  bytes.draw(scene, 32, 24);
  EXPECT_FALSE(bytes.linear());
  EXPECT_THROW(bytes.readLinear(), Error);
}

TEST_F(Drawing, MeshesMayChangeBetweenPictures) {
  addHead();
  Renderer renderer;
  renderer.draw(scene, 160, 120);
  const Picture before = renderer.read();
  for (glm::vec3& p : head.positions) p.x += 0.2f;
  renderer.draw(scene, 160, 120);
  EXPECT_FALSE(before == renderer.read());
  for (glm::vec3& p : head.positions) p.x -= 0.2f;
  head = sphere({0, 0.3f, 0}, 0.1f);
  renderer.draw(scene, 160, 120);
  EXPECT_EQ(before, renderer.read());
}

TEST_F(Drawing, AnyPartOfAMeshMayChangeAlone) {
  addHead();
  Renderer renderer;
  const auto drawnNow = [&] {
    renderer.draw(scene, 160, 120);
    return renderer.read();
  };
  const Picture before = drawnNow();
  const std::vector<glm::vec3> black(head.positions.size(), glm::vec3(0));
  scene.meshes[0].vertexColours = black;
  EXPECT_FALSE(before == drawnNow()) << "colours";
  scene.meshes[0].vertexColours = {};
  EXPECT_EQ(before, drawnNow()) << "no colours again";
  const TriangleMesh whole = head;
  head.triangles.resize(head.triangles.size() / 2);
  EXPECT_FALSE(before == drawnNow()) << "triangles";
  head = whole;
  for (glm::vec3& n : head.normals) n = {0, -1, 0};
  EXPECT_FALSE(before == drawnNow()) << "normals";
  head = whole;
  EXPECT_EQ(before, drawnNow());
}

TEST_F(Drawing, DebugLinesShowThroughTheHead) {
  addHead();
  for (int i = -5; i <= 5; ++i) {
    const float x = 0.01f * static_cast<float>(i);
    scene.debug.line({x, 0.25f, 0}, {x, 0.35f, 0}, packColour({1, 0, 0, 1}));
  }
  EXPECT_GT(redPixels(drawn()), 50);
  scene.debug.onTop = false;
  EXPECT_EQ(redPixels(drawn()), 0);
}

}  // namespace
