# What the scripts of these tests share. Given: BUILD, the project's build folder; PROJECT, its source
# folder; WORK, a folder of these tests; COMPILER, NINJA.
cmake_policy(VERSION 3.25)
# A compiler cache may make paths relative, which this looks at.
unset(ENV{CCACHE_BASEDIR})

# run(COMMAND ...): what it printed is in `output`; the test fails where it fails.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

# configure(PROJECT OF THIS FOLDER, PREFIX, OPTION ...): in a folder of its own, `build`; of what libhair is
# built with and on, only the packages that an option USE_... names can be found.
function(configure project name prefix)
  set(build "${WORK}/${name}")
  set(options)
  foreach(package OpenMesh Eigen3 OpenGL CLI11 embree TBB hwy)
    if(NOT package IN_LIST ARGN)
      list(APPEND options -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
    endif()
  endforeach()
  list(FILTER ARGN INCLUDE REGEX "^-")
  file(REMOVE_RECURSE "${build}")
  run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/${project}" -B "${build}" -G Ninja
    "-DCMAKE_MAKE_PROGRAM=${NINJA}" "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_PREFIX_PATH=${prefix}"
    ${options} ${ARGN})
  set(build "${build}" PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()

# needed(FILE, ALLOWED ...): the test fails where it needs a library that no expression of ALLOWED
# names, beside those of the system.
function(needed file)
  run("${READELF}" --dynamic --wide "${file}")
  string(REGEX REPLACE "[][]" "|" output "${output}")  # brackets would glue a list's items together
  string(REGEX MATCHALL "NEEDED[^\n|]*\\|[^|\n]+" needed "${output}")
  list(TRANSFORM needed REPLACE ".*\\|" "")
  cmake_path(GET file FILENAME name)
  message("${name} links ${needed}")
  list(JOIN ARGN "|" allowed)
  set(foreign ${needed})
  list(FILTER foreign EXCLUDE REGEX
    "^(${allowed}|libstdc\\+\\+|libm|libgcc_s|libc|ld-linux[-a-z0-9_]*)\\.so\\.[0-9.]+$")
  if(foreign OR NOT needed)
    message(FATAL_ERROR "${file} links ${foreign}")
  endif()
endfunction()
