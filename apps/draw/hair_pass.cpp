#include <apps/draw/hair_pass.h>

#include <glm/gtc/type_ptr.hpp>

#include <apps/draw/shaders.h>
#include <libhair/core/error.h>

namespace hair::draw {
namespace {

gl::Program linked(const char* name, const shaders::Source& s) {
  return gl::link(name, s.vertex, s.geometry, s.fragment);
}

void checkLayer(const HairLayer& layer, bool linear, bool sideBySide) {
  const auto& first = layer.strands.first;
  const std::size_t points = layer.strands.pointCount();
  require(first.empty() ? points == 0 : first.back() == points, "hair to draw has ", points,
          " points, but its strands end at ", first.empty() ? 0 : first.back());
  require(layer.colours.size() == points, "hair to draw has ", points, " points but ",
          layer.colours.size(), " colours");
  require(layer.leftColours.empty() || layer.leftColours.size() == points, "hair to draw has ",
          points, " points but ", layer.leftColours.size(), " colours for the left half");
  if (!linear) return;
  require(layer.radiance.size() == points, "hair to draw in a linear picture has ", points,
          " points but ", layer.radiance.size(), " radiances");
  require(!sideBySide || layer.leftRadiance.size() == layer.leftColours.size(),
          "hair to draw in a linear picture has ", layer.leftColours.size(), " colours but ",
          layer.leftRadiance.size(), " radiances for the left half");
}

}  // namespace

gl::Program HairPass::makeLines() {
  return linked("hair lines", shaders::hairLines());
}
gl::Program HairPass::makeRibbons() {
  return linked("hair ribbons", shaders::hairRibbons());
}
gl::Program HairPass::makeDepth() {
  return linked("hair shadow", shaders::hairDepth());
}

void HairPass::updateTopology(Layer& layer, StrandView strands, int shadowSegments) {
  alongScratch.resize(strands.pointCount());
  for (std::size_t s = 0; s < strands.strandCount(); ++s) {
    const std::uint32_t begin = strands.first[s], end = strands.first[s + 1];
    for (std::uint32_t i = begin; i < end; ++i) {
      alongScratch[i] = std::uint8_t(255 * (i - begin) / std::max(1u, end - begin - 1));
    }
  }
  gl::upload<std::uint8_t>(GL_ARRAY_BUFFER, layer.along, alongScratch, GL_STATIC_DRAW);
  glEnableVertexAttribArray(2);
  glVertexAttribPointer(2, 1, GL_UNSIGNED_BYTE, GL_TRUE, 1, nullptr);

  const std::size_t all = layer.sorted.segmentCount();
  const std::size_t every = 1 + all / std::size_t(std::max(1, shadowSegments));
  lineScratch.clear();
  for (std::size_t s = 0; s < strands.strandCount(); s += every) {
    for (std::uint32_t i = strands.first[s]; i + 1 < strands.first[s + 1]; ++i) {
      lineScratch.push_back({i, i + 1});
    }
  }
  gl::upload<glm::uvec2>(GL_ELEMENT_ARRAY_BUFFER, layer.casters, lineScratch, GL_STATIC_DRAW);
  layer.casterCount = GLsizei(2 * lineScratch.size());
  layer.casterWeight = lineScratch.empty() ? 0 : float(all) / float(lineScratch.size());
}

void HairPass::update(const Scene& scene, int shadowSegments, bool linear) {
  radiant = linear;
  layers.resize(scene.hair.size());
  box = {};
  const glm::vec3 viewDirection = glm::normalize(scene.camera.target - scene.camera.eye());
  for (std::size_t k = 0; k < layers.size(); ++k) {
    const HairLayer& hair = scene.hair[k];
    Layer& layer = layers[k];
    checkLayer(hair, linear, scene.sideBySide);
    const Bounds b = bounds(hair.strands.points);
    if (hair.strands.pointCount() > 0) box.extend(b.lower), box.extend(b.upper);

    glBindVertexArray(layer.array);
    const bool leftOwn = scene.sideBySide && !hair.leftColours.empty();
    gl::upload(GL_ARRAY_BUFFER, layer.colours, hair.colours, GL_STREAM_DRAW);
    if (leftOwn) gl::upload(GL_ARRAY_BUFFER, layer.leftColours, hair.leftColours, GL_STREAM_DRAW);
    if (linear) gl::upload(GL_ARRAY_BUFFER, layer.radiance, hair.radiance, GL_STREAM_DRAW);
    if (linear && leftOwn)
      gl::upload(GL_ARRAY_BUFFER, layer.leftRadiance, hair.leftRadiance, GL_STREAM_DRAW);
    gl::upload(GL_ARRAY_BUFFER, layer.points, hair.strands.points, GL_STREAM_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
    if (layer.sorted.setTopology(hair.strands.first)) {
      updateTopology(layer, hair.strands, shadowSegments);
    }

    layer.sorted.sort(hair.strands.points, viewDirection);
    if (hair.primitive == HairPrimitive::Lines) {
      layer.sorted.writeLines(lineScratch);
      gl::upload<glm::uvec2>(GL_ELEMENT_ARRAY_BUFFER, layer.order, lineScratch, GL_STREAM_DRAW);
      layer.indexCount = GLsizei(2 * lineScratch.size());
    } else {
      layer.sorted.writeRibbons(ribbonScratch);
      gl::upload<glm::uvec4>(GL_ELEMENT_ARRAY_BUFFER, layer.order, ribbonScratch, GL_STREAM_DRAW);
      layer.indexCount = GLsizei(4 * ribbonScratch.size());
    }
  }
}

void HairPass::draw(const Scene& scene, bool left) {
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(GL_FALSE);
  for (std::size_t k = 0; k < layers.size(); ++k) {
    const HairLayer& hair = scene.hair[k];
    Layer& layer = layers[k];
    if (layer.indexCount == 0) continue;
    const bool asLines = hair.primitive == HairPrimitive::Lines;
    const gl::Program& program = asLines ? lines : ribbons;
    glUseProgram(program);
    glUniform3f(gl::uniform(program, "strand"), hair.width, hair.opacity, hair.tipWidth);
    glUniform1i(gl::uniform(program, "radiant"), radiant ? 1 : 0);
    glBindVertexArray(layer.array);
    const bool leftOwn = left && !hair.leftColours.empty();
    glBindBuffer(GL_ARRAY_BUFFER, leftOwn ? layer.leftColours : layer.colours);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, 4, nullptr);
    if (radiant) {
      glBindBuffer(GL_ARRAY_BUFFER, leftOwn ? layer.leftRadiance : layer.radiance);
      glEnableVertexAttribArray(3);
      glVertexAttribPointer(3, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
    }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, layer.order);
    glDrawElements(asLines ? GL_LINES : GL_LINES_ADJACENCY, layer.indexCount, GL_UNSIGNED_INT,
                   nullptr);
  }
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

void HairPass::drawDepth(const Scene& scene, const glm::mat4& clipFromWorld, float texel) {
  glUseProgram(depth);
  glUniformMatrix4fv(gl::uniform(depth, "clipFromWorld"), 1, GL_FALSE,
                     glm::value_ptr(clipFromWorld));
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glDepthMask(GL_FALSE);
  for (std::size_t k = 0; k < layers.size(); ++k) {
    const HairLayer& hair = scene.hair[k];
    Layer& layer = layers[k];
    if (layer.casterCount == 0) continue;
    const float blocks = hair.shadowWidth > 0 ? hair.shadowWidth : hair.width * hair.opacity;
    glUniform1f(gl::uniform(depth, "rootDepth"), layer.casterWeight * blocks / texel);
    glUniform1f(gl::uniform(depth, "tipWidth"), hair.tipWidth);
    glBindVertexArray(layer.array);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, layer.casters);
    glDrawElements(GL_LINES, layer.casterCount, GL_UNSIGNED_INT, nullptr);
  }
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

}  // namespace hair::draw
