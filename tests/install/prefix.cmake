# Installs everything into WORK/both; what of it is the shared kind alone and what the static kind
# alone, into WORK/shared and WORK/static. The list of files goes to WORK: the build folder's own is
# of what its user has installed.
include("${CMAKE_CURRENT_LIST_DIR}/run.cmake")
set(manifest "${BUILD}/install_manifest.txt")
file(REMOVE_RECURSE "${WORK}/both" "${WORK}/shared" "${WORK}/static")
if(EXISTS "${manifest}")
  file(RENAME "${manifest}" "${manifest}.user")
endif()
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/both")
file(RENAME "${manifest}" "${WORK}/install_manifest.txt")
if(EXISTS "${manifest}.user")
  file(RENAME "${manifest}.user" "${manifest}")
endif()

file(COPY "${WORK}/both/" DESTINATION "${WORK}/shared" REGEX "\\.a$|-static[-a-z]*\\.cmake$" EXCLUDE)
file(COPY "${WORK}/both/" DESTINATION "${WORK}/static" REGEX "\\.so[.0-9]*$|-shared[-a-z]*\\.cmake$" EXCLUDE)
