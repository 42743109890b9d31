#pragma once

// Inside hair_draw only: what the light sees.

#include <apps/draw/frame_block.h>
#include <apps/draw/gl_objects.h>
#include <apps/draw/hair_pass.h>
#include <apps/draw/mesh_store.h>

namespace hair::draw {

/// Two maps for each of the first kMeshLights lights (layers of two textures) and one for the
/// floor, made anew for every picture.
///
///   meshes     depth of the first mesh along the light: shadows meshes, hair and floor
///   hair       optical depth (strands' width times opacity a pixel) of the hair in front of that
///              first mesh: hair thins the light on meshes instead of cutting it off
///   occlusion  share of the sky that the floor sees: the soft dark spot where feet touch it
///
/// The strands' own shadow on strands is none of this: it comes with their colours.
class LightMaps {
 public:
  explicit LightMaps(int size);

  /// Draws the maps, notes where they lie in `frame`, and binds them to texture units 0, 1, 2.
  /// Leaves another framebuffer and viewport bound.
  void update(const Scene& scene, const MeshStore& meshes, HairPass& hair, FrameBlock& frame);

 private:
  int size;
  int layers = 0;
  gl::Texture meshDepth, hairDepth, lowest, occlusion;
  gl::Framebuffer meshTarget, hairTarget, lowestTarget, occlusionTarget;
  gl::VertexArray empty;
  gl::Program occlude;

  void allocateLayers(int count);
  void updateFloor(const Scene& scene, const MeshStore& meshes, FrameBlock& frame);
};

}  // namespace hair::draw
