# Installs the library into an empty folder, copies the examples elsewhere, builds them there against
# it, and runs one in C++ and one in C.
#
# cmake -D BUILD=... -D EXAMPLES=... -D WORK=... -D NINJA=... -D C=... -D CXX=... -P own_project.cmake
include("${CMAKE_CURRENT_LIST_DIR}/../install/run.cmake")

file(REMOVE_RECURSE "${WORK}")
foreach(component library development static hair_mesh hair_c)
  run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/prefix" --component ${component})
endforeach()
file(COPY "${EXAMPLES}/" DESTINATION "${WORK}/examples")
run("${CMAKE_COMMAND}" -S "${WORK}/examples" -B "${WORK}/build" -G Ninja
  "-DCMAKE_MAKE_PROGRAM=${NINJA}" "-DCMAKE_C_COMPILER=${C}" "-DCMAKE_CXX_COMPILER=${CXX}"
  "-DCMAKE_PREFIX_PATH=${WORK}/prefix")
run("${CMAKE_COMMAND}" --build "${WORK}/build")
run("${CMAKE_CTEST_COMMAND}" --test-dir "${WORK}/build" --no-tests=error --output-on-failure
  -R "examples/(shadow_my_strands|hair_in_c)")
