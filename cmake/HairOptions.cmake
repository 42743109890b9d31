# Compile options of everything in this project; never passed on to whoever links the library.
add_library(hair_options INTERFACE)
target_compile_features(hair_options INTERFACE cxx_std_20)
target_compile_options(hair_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
  # Lanes (core/lanes.h) are passed by value; no such function crosses a library boundary.
  -Wno-psabi
  # a*b+c must round the same on every CPU and compiler: the state hash depends on it.
  -ffp-contract=off
  # Neither errno nor floating-point traps are read; lets square roots and selects vectorise.
  -fno-math-errno -fno-trapping-math
  # g++ is silent inside system headers; clang reports what libstdc++'s own stable_sort calls.
  $<$<CXX_COMPILER_ID:Clang>:-Wno-deprecated-declarations>
  $<$<BOOL:${HAIR_WERROR}>:-Werror>)
# Kernels (core/simd-inl.h) are compiled for any CPU, and for AVX2 and AVX3, or NEON: instruction
# sets between those are not worth their code, and vectors without a size are no members.
# Sanitizers look at the plain one: its look-ups are loads that they see into, at the same places, and
# the others take them minutes to compile.
set(hair_without_targets "HWY_SSSE3|HWY_SSE4|HWY_SVE|HWY_SVE2|HWY_SVE_256|HWY_SVE2_128|HWY_RVV")
if(HAIR_SANITIZE)
  string(APPEND hair_without_targets "|HWY_AVX2|HWY_AVX3")
endif()
target_compile_definitions(hair_options INTERFACE "HWY_DISABLED_TARGETS=(${hair_without_targets})")
if(HAIR_SANITIZE)
  target_compile_options(hair_options INTERFACE
    -fsanitize=${HAIR_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(hair_options INTERFACE -fsanitize=${HAIR_SANITIZE})
  # g++ says so by itself, and libstdc++ and tests listen.
  foreach(sanitizer address thread)
    if(HAIR_SANITIZE MATCHES ${sanitizer} AND CMAKE_CXX_COMPILER_ID MATCHES Clang)
      string(TOUPPER ${sanitizer} word)
      target_compile_definitions(hair_options INTERFACE __SANITIZE_${word}__)
    endif()
  endforeach()
endif()
