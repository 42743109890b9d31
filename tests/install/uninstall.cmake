# What cmake --install has copied, cmake --build --target uninstall removes, and folders of its own;
# files of others stay. The target runs this script, in the build folder.
include("${CMAKE_CURRENT_LIST_DIR}/run.cmake")
file(WRITE "${WORK}/both/include/libhair/shadow/mine.h" "")
file(STRINGS "${WORK}/install_manifest.txt" installed)
run("${CMAKE_COMMAND}" -E chdir "${WORK}" "${CMAKE_COMMAND}" -P "${PROJECT}/cmake/uninstall.cmake")
message("${output}")
list(LENGTH installed count)
file(GLOB_RECURSE left LIST_DIRECTORIES true RELATIVE "${WORK}/both" "${WORK}/both/*")
list(FILTER left INCLUDE REGEX "hair")
if(count LESS 100 OR NOT left STREQUAL
    "include/libhair;include/libhair/shadow;include/libhair/shadow/mine.h")
  message(FATAL_ERROR "of ${count} files, these are left: ${left}")
endif()
