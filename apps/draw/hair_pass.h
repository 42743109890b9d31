#pragma once

// Inside hair_draw only: strands on the graphics card.

#include <deque>

#include <apps/draw/frame_block.h>
#include <apps/draw/gl_objects.h>
#include <apps/draw/hair_order.h>
#include <apps/draw/scene.h>

namespace hair::draw {

class HairPass {
 public:
  /// Sends points and colours, and what depends on the topology where it has changed; sorts for the
  /// camera. All of a picture is sent here, once.
  /// `shadowSegments`: at most about so many cast the shadow (every k-th strand, k times as dense).
  /// `linear`: radiance is sent too, and drawn.
  void update(const Scene& scene, int shadowSegments, bool linear);

  /// Box around all hair, world space.
  Bounds worldBounds() const { return box; }

  /// Draws all layers, blended; with their left colours where `left` is set and they have some.
  void draw(const Scene& scene, bool left);

  /// Adds the strands' optical depth through `clipFromWorld` to the bound framebuffer, whose pixels
  /// measure `texel` metres, times w of the clip space.
  void drawDepth(const Scene& scene, const glm::mat4& clipFromWorld, float texel);

 private:
  struct Layer {
    gl::VertexArray array;
    gl::Buffer points, colours, leftColours, radiance, leftRadiance, along, order, casters;
    HairOrder sorted;
    GLsizei indexCount = 0, casterCount = 0;
    float casterWeight = 1;
  };
  std::deque<Layer> layers;
  Bounds box;
  bool radiant = false;  // what update was told
  std::vector<glm::uvec2> lineScratch;
  std::vector<glm::uvec4> ribbonScratch;
  std::vector<std::uint8_t> alongScratch;
  gl::Program lines = makeLines(), ribbons = makeRibbons(), depth = makeDepth();

  void updateTopology(Layer& layer, StrandView strands, int shadowSegments);
  static gl::Program makeLines();
  static gl::Program makeRibbons();
  static gl::Program makeDepth();
};

}  // namespace hair::draw
