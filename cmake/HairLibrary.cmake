# hair_library(TARGET [NEEDS PACKAGE ...] [LIBS FLAG ...]): all that one library of the project is to
# its users. Called where TARGET, a static library, is made.
#
# - TARGET_shared, made from the same objects (HAIR_SHARED);
# - both installed, each with its file of targets, so that find_package(hair) loads only the kind and
#   the libraries that are asked for;
# - TARGET.pc for pkg-config;
# - a package of Debian (HairPackages.cmake).
#
# NEEDS (arguments of find_package) and LIBS (flags) are what the static library is linked with; the
# shared one finds that by itself. hair::hair is the core; others are components, by the names that
# they are exported as. A TARGET that is shared itself is one that holds the core in it: it is the same
# whichever kind is asked for.
#
# Installed as: library (the core's shared library) or TARGET (another's), development, static.
include(GNUInstallDirs)
set(hair_package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/hair")

# What a user who does not want tests builds.
add_custom_target(installable COMMENT "All that cmake --install copies")

function(hair_library target)
  cmake_parse_arguments(arg "" "" "NEEDS;LIBS" ${ARGN})
  get_target_property(name ${target} EXPORT_NAME)
  if(NOT name)
    set(name ${target})
  endif()
  set(component ${target})
  if(target STREQUAL hair)
    set(component library)
  endif()
  add_dependencies(installable ${target})

  set(archive ${target})
  set(shared "")
  get_target_property(type ${target} TYPE)
  if(type STREQUAL SHARED_LIBRARY)
    set(archive "")
    set(shared ${target})
  elseif(HAIR_SHARED)
    set(shared ${target}_shared)
    set(exports "${PROJECT_SOURCE_DIR}/cmake/exports.map")
    add_library(${shared} SHARED "${exports}")  # no source: all comes from the archive
    add_dependencies(installable ${shared})
    set_target_properties(${shared} PROPERTIES
      LINKER_LANGUAGE CXX OUTPUT_NAME ${target} EXPORT_NAME ${name}
      # Before 1.0 a minor version may break its users.
      VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
      # Libraries of the project are installed side by side.
      INSTALL_RPATH "$ORIGIN")
    target_link_libraries(${shared} PRIVATE $<LINK_LIBRARY:WHOLE_ARCHIVE,${target}>)
    if(target STREQUAL hair)
      target_link_libraries(${shared} PUBLIC glm::glm)
      target_compile_features(${shared} PUBLIC cxx_std_20)
      target_include_directories(${shared} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    else()
      # After it, as a dependency of TARGET, comes the core's archive: the few functions that libraries
      # of the project share and that libhair.so hides are taken from there, as hidden copies.
      target_link_libraries(${shared} PUBLIC hair_shared)
    endif()
    if(NOT APPLE)
      target_link_options(${shared} PRIVATE
        "LINKER:--version-script=${exports}" LINKER:--as-needed LINKER:--no-undefined
        LINKER:-Bsymbolic-functions)
      set_target_properties(${shared} PROPERTIES LINK_DEPENDS "${exports}")
    endif()
  endif()

  if(NOT HAIR_INSTALL)
    return()
  endif()
  set_property(GLOBAL APPEND PROPERTY hair_libraries ${target})
  if(shared)
    install(TARGETS ${shared} EXPORT ${target}-shared
      LIBRARY COMPONENT ${component} NAMELINK_COMPONENT development)
    install(EXPORT ${target}-shared FILE ${name}-shared.cmake NAMESPACE hair::
      DESTINATION "${hair_package_folder}" COMPONENT development)
  endif()
  if(archive)
    install(TARGETS ${archive} EXPORT ${target}-static ARCHIVE COMPONENT static)
    install(EXPORT ${target}-static FILE ${name}-static.cmake NAMESPACE hair::
      DESTINATION "${hair_package_folder}" COMPONENT static)
  else()
    install(EXPORT ${target}-shared FILE ${name}-static.cmake NAMESPACE hair::
      DESTINATION "${hair_package_folder}" COMPONENT development)
  endif()
  list(JOIN arg_NEEDS "\" \"" needs)
  set_property(GLOBAL APPEND_STRING PROPERTY hair_static_needs "set(hair_${name}_needs \"${needs}\")\n")

  set(folder "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
  cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX
    BASE_DIRECTORY "${CMAKE_INSTALL_PREFIX}/${folder}" OUTPUT_VARIABLE prefix_from_here)
  set(requires hair)
  if(target STREQUAL hair)
    set(requires glm)
  elseif(NOT archive)
    set(requires "")
  endif()
  list(JOIN arg_LIBS " " libs)
  configure_file("${PROJECT_SOURCE_DIR}/cmake/library.pc.in" "${PROJECT_BINARY_DIR}/${target}.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/${target}.pc" DESTINATION "${folder}" COMPONENT development)
endfunction()
