# shellcheck shell=bash
# What app/run, app/package, tests/run, the other commands in tests and .ci/run share; they source it.
# Sets `project` (the project's folder) and defines install_packages and build_release.

project=$(CDPATH='' cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# To build and to run, fonts and OpenGL for a system without a desktop included.
# Recommended packages do not come along, so what is needed of them has a name here.
# shellcheck disable=SC2034  # for the scripts that source this one
build_packages=(
  g++ cmake ninja-build libeigen3-dev
  qt6-base-dev libqt6opengl6-dev qt6-charts-dev qt6-svg-dev qt6-tools-dev qt6-l10n-tools
  libgl1-mesa-dri fonts-dejavu-core qt6-translations-l10n
)

# To make a package besides: it finds out which libraries the program needs.
# shellcheck disable=SC2034
package_packages=(dpkg-dev file)

# To test besides: a virtual screen, a message bus, what checks the files a desktop reads, shells,
# and what watches system calls.
# shellcheck disable=SC2034
test_packages=(
  xvfb xauth dbus-daemon desktop-file-utils appstream shared-mime-info groff-base zsh fish strace
  "${package_packages[@]}"
)

# For tests/fuzz/campaign: a compiler with libFuzzer.
# shellcheck disable=SC2034
fuzz_packages=(clang libclang-rt-14-dev)

# To standard error: standard output is the program's.
say() { echo "angrycuts: $*" >&2; }

fail() {
  echo "angrycuts: $*" >&2
  exit 1
}

is_installed() {
  dpkg-query --show --showformat '${db:Status-Status}\n' "$1" 2>/dev/null | grep -qx installed
}

# Runs a command as root; shows what it wrote only if it fails.
as_root() {
  local output
  local -a sudo=()
  if [ "$(id -u)" != 0 ]; then sudo=(sudo); fi
  output=$("${sudo[@]}" env DEBIAN_FRONTEND=noninteractive "$@" 2>&1 </dev/null) || {
    tail -n 10 <<<"$output" >&2
    fail "this failed (is there a network?): $*"
  }
}

# Installs those of the named packages that are not there yet. Where all are there it
# needs neither root nor network.
install_packages() {
  local package
  local -a missing=()
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    fail "this script installs packages with apt, which is not here." \
      "README.md says what to install on other systems and how to build there."
  fi
  for package in "$@"; do
    is_installed "$package" || missing+=("$package")
  done
  if [ ${#missing[@]} = 0 ]; then return; fi

  if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null ||
      fail "packages are missing, and there is no sudo to install them with. As root, run:" \
        "apt-get install --no-install-recommends ${missing[*]}"
    sudo true || fail "packages are missing, and sudo does not let us install them: ${missing[*]}"
  fi
  say "installing ${missing[*]}"
  as_root apt-get update -qq
  # The system's own updates may hold the lock.
  as_root apt-get install -y -qq --no-install-recommends -o DPkg::Lock::Timeout=300 "${missing[@]}"
}

# Configures, and builds targets in Release in build/release.
build_release() {
  local -a options=() ninja=()
  # Nobody reads the warnings of a build without a person in front of it, so they stop it.
  if [ -n "${CI:-}" ]; then options=(-DCMAKE_COMPILE_WARNING_AS_ERROR=ON); fi
  # A terminal shows the progress in one line; elsewhere every file would be one.
  if [ ! -t 2 ]; then ninja=(-- --quiet); fi
  [ -e "$project/build/release/build.ninja" ] ||
    say "building in $project/build/release, which takes minutes the first time"
  cmake -S "$project" --preset release "${options[@]}" >/dev/null
  cmake --build "$project/build/release" --target "$@" "${ninja[@]}" >&2
}
