# What the scripts `run` of apps/dance, tests, benchmarks, python and .ci share: packages, then
# configuration and build.
# Sourced by bash from the project's top folder; changes nothing until a function is called.

say() { printf '\n==> %s\n' "$*" >&2; }
die() { printf 'error: %s\n' "$*" >&2; exit 1; }

# help_if_asked SCRIPT WORD: where WORD asks for help, tells what SCRIPT says of itself in its first lines.
help_if_asked() {
  case $2 in
    -h | --help) sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$1" && exit 0 ;;
  esac
}

# As many compilers as there are processors, but no more than one a gigabyte of free memory.
jobs() {
  local processors gigabytes
  processors=$(nproc)
  gigabytes=$(awk '/^MemAvailable/ {print int($2 / 1048576)}' /proc/meminfo)
  echo $((gigabytes < 1 ? 1 : gigabytes < processors ? gigabytes : processors))
}

# packages LIST ...: the names in cmake/packages/LIST.txt.
packages() {
  local list
  for list in "$@"; do sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "cmake/packages/$list.txt"; done
}

# missing LIST ...: those of them that are not installed.
missing() {
  local package
  for package in $(packages "$@"); do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] ||
      echo "$package"
  done
}

as_root() {
  if [ "$(id -u)" = 0 ]; then
    env DEBIAN_FRONTEND=noninteractive "$@"
  elif command -v sudo >/dev/null; then
    sudo env DEBIAN_FRONTEND=noninteractive "$@"
  else
    die "packages are missing and there is no sudo; as root: $*"
  fi
}

# install_packages LIST ...: installs what is missing, and does nothing where nothing is.
# HAIR_INSTALL=no leaves that to the user.
install_packages() {
  [ "${HAIR_INSTALL:-yes}" != no ] || return 0
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    die "this is no Debian: install what these packages of Debian 12 hold:" $(packages "$@") \
      "-- then run this again with HAIR_INSTALL=no"
  fi
  local wanted install
  wanted=$(missing "$@")
  if [ -z "$wanted" ]; then return 0; fi
  say "Installing" $wanted
  install="apt-get install --yes --no-install-recommends -o Dpkg::Use-Pty=0"
  # The lists of packages may be absent (no such package) or old (no such file): fetch them then.
  if ! apt-get install --simulate --no-install-recommends $wanted >/dev/null 2>&1 ||
    ! as_root $install $wanted; then
    as_root apt-get update
    as_root $install $wanted ||
      die "cannot install" $wanted "-- these are packages of Debian 12 (bookworm)"
  fi
}

# parts PART ...: what a configuration has to be told so that it has these parts (apps, tests,
# benchmarks, python), which the user asks for, and of the others those whose packages are there.
# Scripts that share a build folder thus say the same: none undoes what another has built.
parts() {
  local part
  for part in apps tests benchmarks; do
    if [[ " $* " == *" $part "* || -z $(missing "$part") ]]; then
      echo "-DHAIR_BUILD_${part^^}=ON"
    else
      echo "-DHAIR_BUILD_${part^^}=OFF"
    fi
  done
  # The rest of the others CMake finds by itself.
  [[ " $* " != *" python "* ]] || echo "-DHAIR_BUILD_PYTHON=ON"
}

# configure PRESET [CMAKE OPTION ...]: by what is asked for and installed now. What an earlier call
# was asked for, or has found or missed, is forgotten first.
configure() {
  say "Configuring $1"
  cmake --preset "$1" -U 'HAIR_WITH_*' -U HAIR_BUILD_PYTHON -U HAIR_DATA_DIR -U HAIR_FUZZ_SECONDS \
    "${@:2}" ${HAIR_CMAKE_OPTIONS:-} >&2
}

# build PRESET [CMAKE --build OPTION ...]
build() {
  say "Building $1 in build/$1"
  cmake --build --preset "$1" -j "$(jobs)" "${@:2}" >&2
}
