#pragma once

#include <pybind11/pybind11.h>

// What module.cpp puts together: one file a topic, each compiled alone.
namespace hair::python {

void bindGeometry(pybind11::module_& m);    ///< Transform, Mesh, DistanceField
void bindStrands(pybind11::module_& m);     ///< Strands, files
void bindSettings(pybind11::module_& m);    ///< what frames and shadows are told
void bindGrooms(pybind11::module_& m);      ///< styles, bound strands, hair meshes
void bindLevels(pybind11::module_& m);      ///< GroomDetail, LevelOfDetail
void bindMotion(pybind11::module_& m);      ///< Motion, Pose
void bindSimulation(pybind11::module_& m);  ///< Simulation
void bindDensity(pybind11::module_& m);     ///< DensityGrid
void bindShadows(pybind11::module_& m);     ///< shadow, DensityMap, ShadowMethod, shade
void bindMeasure(pybind11::module_& m);     ///< truth, trials, the choice
void bindThreads(pybind11::module_& m);     ///< thread_count, thread_limit

}  // namespace hair::python
