# Every public header compiles alone, and includes files of the library itself, of GLM, of the C++
# library and of the C library; nothing else.
include("${CMAKE_CURRENT_LIST_DIR}/run.cmake")
configure(headers headers_build "${WORK}/shared")
run("${CMAKE_COMMAND}" --build "${build}")

run("${NINJA}" -C "${build}" -t deps)
string(REGEX MATCHALL "\n +[^\n]+" included "${output}")
list(TRANSFORM included STRIP)
list(REMOVE_DUPLICATES included)
list(LENGTH included count)
set(foreign ${included})
foreach(known
    "^${WORK}/" "^/[^ ]*\\.cpp$" "/glm/" "/lib/gcc/" "/include/c\\+\\+/" "/lib/clang/" "^headers_[^/]+$"
    "^/usr/include/([^/]+-linux-gnu/)?(asm|asm-generic|bits|c\\+\\+|gnu|linux|sys)/"
    "^/usr/include/[^/]+$")
  list(FILTER foreign EXCLUDE REGEX "${known}")
endforeach()
if(foreign OR count LESS 100)
  message(FATAL_ERROR "the public headers include, among ${count} files, ${foreign}")
endif()
file(GLOB sources "${build}/*.cpp")
list(LENGTH sources headers)
if(headers GREATER 61)
  message(FATAL_ERROR "${headers} public headers: what only the library needs does not say HAIR_API")
endif()
message("${headers} public headers include ${count} files: of the library, of GLM and of the system")
