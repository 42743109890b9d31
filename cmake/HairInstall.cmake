# cmake --install: headers, libraries, and what find_package(hair) reads. hair::model,
# hair::hair_mesh and hair::embree have files of targets of their own, so that whoever does not ask
# for them needs neither OpenMesh nor Embree.
include(CMakePackageConfigHelpers)
set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/hair")

# Headers that say HAIR_API are public, all others stay here.
file(GLOB_RECURSE headers RELATIVE "${PROJECT_SOURCE_DIR}" CONFIGURE_DEPENDS
  "${PROJECT_SOURCE_DIR}/libhair/*.h")
if(NOT HAIR_WITH_HAIR_MESH)
  list(FILTER headers EXCLUDE REGEX "^libhair/hair_mesh/")
endif()
foreach(header IN LISTS headers)
  file(STRINGS "${PROJECT_SOURCE_DIR}/${header}" public LIMIT_COUNT 1 REGEX "HAIR_API")
  if(public)
    cmake_path(GET header PARENT_PATH folder)
    install(FILES "${header}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/${folder}" COMPONENT library)
  endif()
endforeach()
install(TARGETS hair EXPORT hairTargets COMPONENT library)
install(EXPORT hairTargets NAMESPACE hair:: DESTINATION "${package_folder}" COMPONENT library)
if(HAIR_WITH_MODEL)
  install(TARGETS hair_model EXPORT hairModelTargets COMPONENT library)
  install(EXPORT hairModelTargets NAMESPACE hair:: DESTINATION "${package_folder}"
    COMPONENT library)
endif()
if(HAIR_WITH_HAIR_MESH)
  install(TARGETS hair_mesh EXPORT hairMeshTargets COMPONENT library)
  install(EXPORT hairMeshTargets NAMESPACE hair:: DESTINATION "${package_folder}" COMPONENT library)
endif()
if(HAIR_WITH_EMBREE)
  install(TARGETS hair_embree EXPORT hairEmbreeTargets COMPONENT library)
  install(EXPORT hairEmbreeTargets NAMESPACE hair:: DESTINATION "${package_folder}"
    COMPONENT library)
endif()

configure_package_config_file(cmake/hairConfig.cmake.in "${PROJECT_BINARY_DIR}/hairConfig.cmake"
  INSTALL_DESTINATION "${package_folder}")
# Before 1.0 a minor version may break its users.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/hairConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/hairConfig.cmake" "${PROJECT_BINARY_DIR}/hairConfigVersion.cmake"
  DESTINATION "${package_folder}" COMPONENT library)
