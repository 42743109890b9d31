#pragma once

// Inside hair_draw only: what every shader knows of the picture being drawn.

#include <apps/draw/gl_objects.h>
#include <apps/draw/scene.h>

namespace hair::draw {

/// Mirrors `uniform Frame` of shaders.cpp (std140: matrices and vectors of four only).
struct FrameBlock {
  glm::mat4 clipFromWorld;
  /// Of each light: to [0, 1]^3 (after division by w), texture coordinates and depth from it.
  glm::mat4 shadowFromWorld[kMeshLights];
  glm::vec4 lightPlace[kMeshLights];   ///< xyz: unit towards it, w 0; or where it is, w 1
  glm::vec4 lightColour[kMeshLights];  ///< rgb linear, times intensity; at a point: at 1 m from it
  glm::vec4 lightTexel;                ///< metres of each light's shadow map texel (LightView)
  glm::vec4 eye;                       ///< xyz; w: pixels a metre covers at distance 1
  glm::vec4 allLights;         ///< rgb linear, times intensity, at the pivot; w: number of lights
  glm::vec4 sky;               ///< rgb linear, times intensity
  glm::vec4 backgroundMiddle;  ///< rgb linear
  glm::vec4 backgroundEdge;    ///< rgb linear
  glm::vec4 viewport;          ///< x, y, width, height in pixels
  glm::vec4 groundColour;      ///< rgb linear; w: height, metres
  glm::vec4 groundPlace;       ///< x, z of the middle; w: radius, metres
  glm::vec4 floorMap;          ///< x, z of the corner, 1 / metres on a side; w: 1 if there is one
  glm::vec4 shadowTexel;       ///< x: 1 / shadow map pixels
};

/// All but what the shadow maps fill in.
FrameBlock frameBlock(const Scene& scene, glm::vec4 viewport);

/// sRGB component in [0, 1] to linear.
glm::vec3 linearFromSrgb(glm::vec3 srgb);

}  // namespace hair::draw
