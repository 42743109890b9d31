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
if(HAIR_NATIVE)
  # Wider lanes, the same bits: no contraction (above), and lanes round as scalars do.
  target_compile_options(hair_options INTERFACE -march=native)
endif()
if(HAIR_SANITIZE)
  target_compile_options(hair_options INTERFACE
    -fsanitize=${HAIR_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(hair_options INTERFACE -fsanitize=${HAIR_SANITIZE})
endif()
