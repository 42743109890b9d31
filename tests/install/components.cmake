# A program that uses every component, with either kind.
include("${CMAKE_CURRENT_LIST_DIR}/run.cmake")
configure(components components_static "${WORK}/both" TBB hwy OpenMesh embree "-DCOMPONENTS=${COMPONENTS}")
run("${CMAKE_COMMAND}" --build "${build}")
run("${build}/components")
message("static:\n${output}")

configure(components components_shared "${WORK}/both" "-DCOMPONENTS=${COMPONENTS}" -Dhair_SHARED_LIBS=ON)
run("${CMAKE_COMMAND}" --build "${build}")
run("${build}/components")
message("shared:\n${output}")
needed("${build}/components" libhair libhair_[a-z]+)
