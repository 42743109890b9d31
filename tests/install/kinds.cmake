# Which kind of library find_package(hair) takes; kinds/CMakeLists.txt lists the laws.
include("${CMAKE_CURRENT_LIST_DIR}/run.cmake")
configure(kinds kinds_build "" TBB hwy OpenMesh embree "-DPREFIXES=${WORK}")
message("${output}")
