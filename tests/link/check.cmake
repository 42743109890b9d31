# Installs the library into an empty folder, builds the project beside this file against it, runs
# its program, and looks at what it linked and included.
#
# cmake -D BUILD=... -D SOURCE=... -D WORK=... -D COMPILER=... -D NINJA=... -D READELF=...
#       -P check.cmake
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE "${WORK}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/prefix" --component library)
# OpenMesh and all that the programs need are made unfindable.
run("${CMAKE_COMMAND}" -S "${SOURCE}" -B "${WORK}/build" -G Ninja "-DCMAKE_MAKE_PROGRAM=${NINJA}"
  "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_PREFIX_PATH=${WORK}/prefix"
  -DCMAKE_DISABLE_FIND_PACKAGE_OpenMesh=ON -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON
  -DCMAKE_DISABLE_FIND_PACKAGE_OpenGL=ON -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON
  -DCMAKE_DISABLE_FIND_PACKAGE_embree=ON)
run("${CMAKE_COMMAND}" --build "${WORK}/build")
run("${WORK}/build/only_shadows")
message("${output}")

run("${READELF}" --dynamic --wide "${WORK}/build/only_shadows")
string(REGEX REPLACE "[][]" "|" output "${output}")  # brackets would glue a list's items together
string(REGEX MATCHALL "NEEDED[^\n|]*\\|[^|\n]+" needed "${output}")
list(TRANSFORM needed REPLACE ".*\\|" "")
message("links ${needed}")
set(allowed "^(libtbb|libhwy|libstdc\\+\\+|libm|libgcc_s|libc|ld-linux[-a-z0-9_]*)\\.so\\.[0-9]+$")
set(foreign ${needed})
list(FILTER foreign EXCLUDE REGEX "${allowed}")
if(foreign OR NOT needed)
  message(FATAL_ERROR "a program that only wants shadows links ${foreign}")
endif()

# Files of the library itself, of GLM, of the C++ library and of the C library; nothing else.
run("${NINJA}" -C "${WORK}/build" -t deps CMakeFiles/all_headers.dir/all_headers.cpp.o)
string(REGEX MATCHALL "\n +[^\n]+" included "${output}")
list(TRANSFORM included STRIP)
list(LENGTH included count)
set(foreign ${included})
foreach(known
    "^${WORK}/" "/glm/" "/lib/gcc/" "/include/c\\+\\+/" "/lib/clang/"
    "^/usr/include/([^/]+-linux-gnu/)?(asm|asm-generic|bits|c\\+\\+|gnu|linux|sys)/"
    "^/usr/include/[^/]+$")
  list(FILTER foreign EXCLUDE REGEX "${known}")
endforeach()
if(foreign OR count LESS 100)
  message(FATAL_ERROR "the public headers include, among ${count} files, ${foreign}")
endif()
message("the public headers include ${count} files: of the library, of GLM and of the system")
