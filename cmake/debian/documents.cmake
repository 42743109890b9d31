# cpack runs this before it closes the packages: licence and changes, which Debian wants of each.
file(GLOB parts RELATIVE "${CPACK_TEMPORARY_DIRECTORY}" "${CPACK_TEMPORARY_DIRECTORY}/*")
foreach(part IN LISTS parts)
  string(TOUPPER "${part}" upper)
  set(folder
    "${CPACK_TEMPORARY_DIRECTORY}/${part}/usr/share/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME}")
  file(MAKE_DIRECTORY "${folder}")
  configure_file("${CPACK_HAIR_SOURCE}/LICENSE" "${folder}/copyright" COPYONLY)
  execute_process(COMMAND gzip -9nc "${CPACK_HAIR_SOURCE}/cmake/debian/changelog"
    OUTPUT_FILE "${folder}/changelog.Debian.gz" COMMAND_ERROR_IS_FATAL ANY)
endforeach()
