#!/usr/bin/env bash
# The scripts `run`, on a machine that is made up: what they build follows what is asked for and what is
# installed now, whatever was built before. Packages, and the project that is configured, are stand-ins;
# the scripts, presets, CMake and Ninja are the real ones.
#
#   scripts.sh PROJECT WORK
set -euo pipefail
project=$1 machine=$2/scripts
unset HAIR_CMAKE_OPTIONS HAIR_DATA_DIR HAIR_INSTALL
rm -rf "$machine"
mkdir -p "$machine/bin" "$machine/tree"
export INSTALLED=$machine/installed
: >"$INSTALLED"

# A Debian whose packages are lines of a file.
program() { cat >"$machine/bin/$1" && chmod +x "$machine/bin/$1"; }
program dpkg-query <<'END'
#!/bin/sh
for package; do :; done
grep -qx "$package" "$INSTALLED" && printf installed
END
program apt-get <<'END'
#!/bin/sh
case " $* " in *" --simulate "*) exit ;; esac
for word; do case $word in -* | install | update | Dpkg::*) ;; *) echo "$word" >>"$INSTALLED" ;; esac; done
END
program sudo <<'END'
#!/bin/sh
exec "$@"
END
export PATH=$machine/bin:$PATH

cd "$machine/tree"
for file in CMakePresets.json cmake/setup.sh cmake/packages apps/dance/run tests/run benchmarks/run python/run; do
  mkdir -p "$(dirname "$file")"
  cp -R "$project/$file" "$file"
done
# The options of the real one, and what they need; its programs say their name and their words.
cat >CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.25)
project(stand_in NONE)
file(STRINGS "$ENV{INSTALLED}" installed)
set(part_of_APPS libcli11-dev dance hair_program)
set(part_of_TESTS libgtest-dev)
set(part_of_BENCHMARKS libbenchmark-dev hair_bench paper_tables)
set(part_of_PYTHON pybind11-dev hair_python)
set(default_PYTHON OFF)
if(pybind11-dev IN_LIST installed)
  set(default_PYTHON ON)
endif()
foreach(part APPS TESTS BENCHMARKS)
  set(default_${part} ON)
endforeach()
foreach(part APPS TESTS BENCHMARKS PYTHON)
  option(HAIR_BUILD_${part} "" ${default_${part}})
  if(HAIR_BUILD_${part})
    list(POP_FRONT part_of_${part} package)
    if(NOT package IN_LIST installed)
      message(FATAL_ERROR "HAIR_BUILD_${part} without ${package}")
    endif()
    foreach(program IN LISTS part_of_${part})
      add_custom_target(${program} ALL)
      string(REPLACE "_" "-" name ${program})
      file(CONFIGURE OUTPUT bin/${name} CONTENT "#!/bin/sh\necho ${name} \"$@\"\n" @ONLY NEWLINE_STYLE UNIX)
      file(CHMOD ${CMAKE_BINARY_DIR}/bin/${name} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
    endforeach()
  endif()
endforeach()
set(with_embree OFF)
if(libembree-dev IN_LIST installed)
  set(with_embree ON)
endif()
option(HAIR_WITH_EMBREE "" ${with_embree})
set(HAIR_DATA_DIR default CACHE STRING "")
set(HAIR_SANITIZE "" CACHE STRING "")
set(Python_EXECUTABLE /bin/echo CACHE FILEPATH "")
enable_testing()
add_test(NAME passes COMMAND ${CMAKE_COMMAND} -E true)
END

failures=0
fail() { printf '%s\n' "$*" "$(cat log)" && failures=$((failures + 1)); }
# calls WORDS COMMAND ...: the command ends well, and the last line of what it prints is WORDS.
calls() {
  "${@:2}" >log 2>&1 || fail "$* failed"
  [ -z "$1" ] || [ "$(tail -n 1 log)" = "$1" ] || fail "${*:2} did not call: $1"
}
# built PRESET NAME=VALUE ...: what the build folder has been told.
built() {
  local option
  for option in "${@:2}"; do
    grep -q "^HAIR_${option%%=*}:[A-Z]*=${option#*=}\$" "build/$1/CMakeCache.txt" ||
      fail "after line ${BASH_LINENO[0]}: no $option, but" $(grep ^HAIR_ "build/$1/CMakeCache.txt")
  done
}
options() { grep ^HAIR_ build/release/CMakeCache.txt; }

# On a bare machine each installs and builds what it needs.
calls "dance --help" apps/dance/run --help
built release BUILD_APPS=ON BUILD_TESTS=OFF BUILD_BENCHMARKS=OFF BUILD_PYTHON=OFF WITH_EMBREE=OFF
calls "hair-bench --targets" benchmarks/run
built release BUILD_APPS=ON BUILD_TESTS=OFF BUILD_BENCHMARKS=ON WITH_EMBREE=ON
calls "hair-bench --help" benchmarks/run --help
calls "" tests/run
built release BUILD_APPS=ON BUILD_TESTS=ON BUILD_BENCHMARKS=ON BUILD_PYTHON=ON

# Where all is installed they agree, and nothing is built anew when they take turns.
all=$(options)
for script in "apps/dance/run --help" "benchmarks/run --help" "python/run script.py" tests/run; do
  calls "" $script
  [ "$(options)" = "$all" ] || fail "$script changed options:" $(options)
done

# What is gone is not built, and what comes back is.
cp "$INSTALLED" everything
grep -vx -e libgtest-dev -e libbenchmark-dev -e libembree-dev -e pybind11-dev everything >"$INSTALLED"
calls "dance --help" apps/dance/run --help
built release BUILD_APPS=ON BUILD_TESTS=OFF BUILD_BENCHMARKS=OFF BUILD_PYTHON=OFF WITH_EMBREE=OFF
cp everything "$INSTALLED"
calls "dance --help" apps/dance/run --help
[ "$(options)" = "$all" ] || fail "what came back is not built:" $(options)

# The user's own options win, this time.
HAIR_CMAKE_OPTIONS="-DHAIR_WITH_EMBREE=OFF -DHAIR_BUILD_TESTS=OFF" calls "dance --help" apps/dance/run --help
built release BUILD_TESTS=OFF WITH_EMBREE=OFF
HAIR_DATA_DIR=$machine calls "" tests/run
built release BUILD_TESTS=ON WITH_EMBREE=ON "DATA_DIR=$machine"
calls "" tests/run
[ "$(options)" = "$all" ] || fail "an earlier call is not forgotten:" $(options)

# Sanitizers' builds stay what their presets say.
calls "" tests/run asan-ubsan
built asan-ubsan BUILD_TESTS=ON BUILD_APPS=OFF BUILD_BENCHMARKS=OFF SANITIZE=address,undefined

exit $failures
