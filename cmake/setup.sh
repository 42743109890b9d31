# What apps/dance/run, tests/run and .ci/run share: packages, then configuration and build.
# Sourced by bash from the project's top folder; changes nothing until a function is called.

say() { printf '\n==> %s\n' "$*" >&2; }
die() { printf 'error: %s\n' "$*" >&2; exit 1; }

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

# configure PRESET [CMAKE OPTION ...]
configure() {
  say "Configuring $1"
  cmake --preset "$@" ${HAIR_CMAKE_OPTIONS:-} >&2
}

# build PRESET [CMAKE --build OPTION ...]
build() {
  say "Building $1 in build/$1"
  cmake --build --preset "$1" -j "$(jobs)" "${@:2}" >&2
}
