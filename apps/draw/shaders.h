#pragma once

// Inside hair_draw only: GLSL 3.30, one string a stage.

#include <string>

namespace hair::draw::shaders {

struct Source {
  std::string vertex, geometry, fragment;
};

Source background();      ///< the whole viewport, far away
Source ground();          ///< the floor, fading into the background
Source mesh();            ///< lit and shadowed surface
Source depthOnly();       ///< surface into a depth map
Source hairDepth();       ///< lines into a map of optical depth
Source floorOcclusion();  ///< how much of the sky the meshes hide from the floor
Source hairLines();
Source hairRibbons();
Source debug();

}  // namespace hair::draw::shaders
