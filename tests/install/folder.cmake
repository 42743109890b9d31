# As a folder of another project, libhair is hair::hair and nothing else: nothing is built or installed
# that nobody asked for, and no package is needed but what hair::hair is made of.
include("${CMAKE_CURRENT_LIST_DIR}/run.cmake")
configure(folder folder_build "" TBB hwy "-DPROJECT=${PROJECT}")
run("${NINJA}" -C "${build}" -t targets all)
if(output MATCHES "\\.so" OR NOT output MATCHES "libhair\\.a")
  message(FATAL_ERROR "${output}")
endif()
run("${CMAKE_COMMAND}" --install "${build}" --prefix "${WORK}/folder_prefix")
file(GLOB installed "${WORK}/folder_prefix/*")
if(installed)
  message(FATAL_ERROR "installs ${installed}")
endif()
