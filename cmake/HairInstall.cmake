# cmake --install: what belongs to no single library. Each library installs itself (HairLibrary.cmake).
include(CMakePackageConfigHelpers)

# Headers that say HAIR_API are public, all others stay here.
file(GLOB_RECURSE headers RELATIVE "${PROJECT_SOURCE_DIR}" CONFIGURE_DEPENDS
  "${PROJECT_SOURCE_DIR}/libhair/*.h")
if(NOT HAIR_WITH_HAIR_MESH)
  list(FILTER headers EXCLUDE REGEX "^libhair/hair_mesh/")
endif()
if(NOT HAIR_WITH_MODEL)
  list(FILTER headers EXCLUDE REGEX "^libhair/files/obj\\.h$")
endif()
if(NOT HAIR_WITH_EMBREE)
  list(FILTER headers EXCLUDE REGEX "^libhair/measure/embree/")
endif()
foreach(header IN LISTS headers)
  file(STRINGS "${PROJECT_SOURCE_DIR}/${header}" public LIMIT_COUNT 1 REGEX "HAIR_API")
  if(public)
    cmake_path(GET header PARENT_PATH folder)
    install(FILES "${header}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/${folder}"
      COMPONENT development)
  endif()
endforeach()

get_property(static_needs GLOBAL PROPERTY hair_static_needs)
configure_package_config_file(cmake/hairConfig.cmake.in "${PROJECT_BINARY_DIR}/hairConfig.cmake"
  INSTALL_DESTINATION "${hair_package_folder}"
  NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
# Before 1.0 a minor version may break its users.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/hairConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/hairConfig.cmake" "${PROJECT_BINARY_DIR}/hairConfigVersion.cmake"
  DESTINATION "${hair_package_folder}" COMPONENT development)

# Hairstyles to try the programs on.
if(HAIR_BUILD_APPS)
  install(DIRECTORY models DESTINATION "${CMAKE_INSTALL_DATADIR}/hair" COMPONENT programs)
  add_dependencies(installable hair_program dance)
endif()

add_custom_target(uninstall COMMENT "Removing what cmake --install copied"
  COMMAND "${CMAKE_COMMAND}" -P "${PROJECT_SOURCE_DIR}/cmake/uninstall.cmake")
include(cmake/HairPackages.cmake)
