# cpack: packages of Debian, one for each component of installation; development and static make one.
#
#   library      libhair0.1         the shared library of the core; named after its soname
#   hair_mesh    libhair-mesh0.1    and likewise each other library
#   development  libhair-dev        headers, archives, links, packages of CMake and pkg-config
#   programs     hair-tools         the programs, models to try them on
#   python       python3-libhair
#   blender      libhair-blender    the add-on, as a file that Blender installs
set(changelog "${PROJECT_SOURCE_DIR}/cmake/debian/changelog")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${changelog}")
file(STRINGS "${changelog}" latest LIMIT_COUNT 1)
if(NOT latest MATCHES "^libhair \\(${PROJECT_VERSION}-([0-9]+)\\) ")
  message(FATAL_ERROR "${changelog} says nothing of version ${PROJECT_VERSION}, but: ${latest}")
endif()
set(CPACK_DEBIAN_PACKAGE_RELEASE ${CMAKE_MATCH_1})
set(version "${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}")
set(same "(= ${version})")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME libhair)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGE_CONTACT "The libhair developers <libhair@libhair.invalid>")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_HAIR_SOURCE "${PROJECT_SOURCE_DIR}")
set(CPACK_PRE_BUILD_SCRIPTS "${PROJECT_SOURCE_DIR}/cmake/debian/documents.cmake")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SOURCE libhair)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# What libraries of others a package needs, dpkg-shlibdeps finds; the project's own are told below.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${PROJECT_BINARY_DIR}/libhair")

# debian_package(PART NAME SECTION SUMMARY TEXT [DEPENDS ...] [RECOMMENDS ...])
macro(debian_package part name section summary text)
  cmake_parse_arguments(arg "" "" "DEPENDS;RECOMMENDS" ${ARGN})
  string(TOUPPER ${part} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}\n${text}")
  list(JOIN arg_DEPENDS ", " CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS)
  list(JOIN arg_RECOMMENDS ", " CPACK_DEBIAN_${upper}_PACKAGE_RECOMMENDS)
endmacro()

set(about "libhair simulates hair and shadows it, on the CPU: guide strands of rigid
links, drawn strands that follow them in wisps, and the light that hair takes
from hair, by a light-oriented density map.")
set(libraries)
get_property(targets GLOBAL PROPERTY hair_libraries)
foreach(target IN LISTS targets)
  if(TARGET ${target}_shared)
    get_target_property(soversion ${target}_shared SOVERSION)
  else()
    get_target_property(soversion ${target} SOVERSION)
  endif()
  if(NOT soversion)
    continue()  # static alone
  endif()
  string(REPLACE "_" "-" name "lib${target}${soversion}")
  list(APPEND libraries "${name} ${same}")
  if(target STREQUAL hair)
    set(core "${name} ${same}")
    debian_package(library ${name} libs "hair simulated and shadowed on the CPU" "${about}")
  else()
    debian_package(${target} ${name} libs "hair simulated and shadowed on the CPU: ${target}"
      "${about}\n.\nThis package has the part ${target}." DEPENDS "${core}")
  endif()
  # What dpkg-shlibdeps tells to those who link it, and the cache of the loader.
  set(folder "${PROJECT_BINARY_DIR}/debian/${name}")
  file(WRITE "${folder}/shlibs" "lib${target} ${soversion} ${name} (>= ${version})\n")
  file(WRITE "${folder}/triggers" "activate-noawait ldconfig\n")
  set(CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_EXTRA "${folder}/shlibs;${folder}/triggers")
endforeach()
debian_package(development libhair-dev libdevel
  "hair simulated and shadowed on the CPU: development"
  "${about}\n.\nThis package has headers, static libraries, and what CMake and pkg-config read."
  # Packages of others are what the static libraries are linked with.
  DEPENDS ${libraries} libglm-dev libhwy-dev libtbb-dev RECOMMENDS libopenmesh-dev libembree-dev)
debian_package(programs hair-tools graphics "hair simulated and shadowed on the CPU: programs"
  "${about}\n.\nhair converts, simulates, measures and renders; dance shows hair that dances."
  RECOMMENDS ffmpeg)
# An extension is of one minor version of Python.
set(python_needs python3-numpy)
if(HAIR_BUILD_PYTHON)
  math(EXPR python_next "${Python_VERSION_MINOR} + 1")
  list(APPEND python_needs "python3 (>= 3.${Python_VERSION_MINOR})" "python3 (<< 3.${python_next})")
endif()
debian_package(python python3-libhair python "hair simulated and shadowed on the CPU: Python"
  "${about}\n.\nThis package has the module of Python." DEPENDS ${python_needs})
debian_package(blender libhair-blender graphics "hair simulated and shadowed on the CPU: Blender"
  "${about}\n.\nThis package has an add-on for Blender 3.4, to be installed in its preferences."
  DEPENDS "python3-libhair ${same}" RECOMMENDS blender)

include(CPack)
cpack_add_component(development GROUP development)
cpack_add_component(static GROUP development)
