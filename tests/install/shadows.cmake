# A program that only wants shadows links TBB and Highway with the static library, and with the shared
# one that alone, without any package of what it is made of.
include("${CMAKE_CURRENT_LIST_DIR}/run.cmake")
configure(shadows shadows_static "${WORK}/static" TBB hwy)
run("${CMAKE_COMMAND}" --build "${build}")
run("${build}/only_shadows")
message("${output}")
needed("${build}/only_shadows" libtbb libhwy)

configure(shadows shadows_shared "${WORK}/shared")
run("${CMAKE_COMMAND}" --build "${build}")
run("${build}/only_shadows")
needed("${build}/only_shadows" libhair)
file(GLOB library "${WORK}/shared/lib*/libhair.so" "${WORK}/shared/lib*/*/libhair.so")
needed("${library}" libtbb libhwy)
