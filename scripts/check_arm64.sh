#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The part of scripts/check_platform.sh for arm64: cross-compiles the programs with unpacked packages of the release of
# Debian that runs here, emulates them and compares their results with those documented and those of build/release:
#   scripts/check_arm64.sh FOLDER MIRROR JOBS
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/apt.sh
mkdir -p "$1"
folder=$(realpath "$1") mirror=$2 jobs=$3
suite=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
sysroot=$folder/sysroot build=$folder/build log=$folder/log
libraries=usr/lib/aarch64-linux-gnu

step() { echo "== arm64: $1" >&2; }

require() {
  local package program
  for package in g++-12-aarch64-linux-gnu qemu-user-static; do
    is_installed "$package" || { echo "check_platform.sh: needs the package $package" >&2 && exit 2; }
  done
  for program in slalom-evaluate slalom-analyze; do
    [ -x "build/release/bin/$program" ] || { echo "check_platform.sh: needs scripts/build.sh release" >&2 && exit 2; }
  done
}

# apt with lists, caches and installed packages of its own.
apt() {
  apt-get -qq -o Dir::State="$folder/apt" -o Dir::State::status="$folder/apt/status" -o Dir::Cache="$folder/apt" \
    -o Dir::Etc::sourcelist="$folder/apt/sources.list" -o Dir::Etc::sourceparts="$folder/apt/none" \
    -o Dir::Etc::preferencesparts="$folder/apt/none" -o APT::Architecture=arm64 -o APT::Architectures=arm64 \
    -o APT::Keep-Downloaded-Packages=true -o APT::Sandbox::User= -o Acquire::Languages=none "$@"
}

# Programs that run while building are the host's.
packages() {
  packages_of scripts/packages.txt |
    grep -vxE 'build-essential|ccache|cmake|liblcm-bin|mold|mrpt-apps|ninja-build|pkg-config'
  echo libc6-dev
}

make_sysroot() {
  local names
  names=$(packages)
  if [ -e "$sysroot.packages" ] && [ "$names" = "$(cat "$sysroot.packages")" ]; then return; fi
  mkdir -p "$folder"/apt/{lists,archives}/partial "$folder/apt/none"
  : >"$folder/apt/status"
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $suite main" >"$folder/apt/sources.list"
  apt update
  # shellcheck disable=SC2086
  apt install -y --download-only --no-install-recommends $names >"$log.packages"
  rm -rf "$sysroot" && mkdir "$sysroot"
  for package in "$folder"/apt/archives/*.deb; do dpkg-deb -x "$package" "$sysroot"; done
  # Made by update-alternatives on installation.
  for library in blas lapack; do ln -sf "$library/lib$library.so.3" "$sysroot/$libraries/lib$library.so.3"; done
  # Absolute paths of the host's headers and libraries.
  sed -i -E ":a; s#([; \"])/usr/(include|lib)#\1$sysroot/usr/\2#; ta" \
    "$sysroot/usr/share/ompl/cmake/omplConfig.cmake" "$sysroot/$libraries/cmake/mrpt-math/mrpt-math-targets.cmake"
  echo "$names" >"$sysroot.packages"
}

write_toolchain() {
  cat >"$folder/toolchain.cmake" <<END
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_SYSROOT $sysroot)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc-12)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++-12)
set(CMAKE_CXX_FLAGS_INIT -Wno-psabi)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
foreach(kind LIBRARY INCLUDE PACKAGE)
  set(CMAKE_FIND_ROOT_PATH_MODE_\${kind} ONLY)
endforeach()
END
}

compile() {
  export PKG_CONFIG_SYSROOT_DIR=$sysroot PKG_CONFIG_LIBDIR=$sysroot/$libraries/pkgconfig:$sysroot/usr/share/pkgconfig
  write_toolchain
  if ! { cmake -S . -B "$build" -G Ninja -DCMAKE_TOOLCHAIN_FILE="$folder/toolchain.cmake" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_UNITY_BUILD=ON -DSLALOM_BUILD_TESTS=OFF -DSLALOM_BUILD_BENCHMARKS=OFF &&
    cmake --build "$build" -j "$jobs" -t slalom-scenarios slalom-evaluate slalom-analyze slalom_reactive_methods; } \
    >"$log.build" 2>&1; then
    grep -E '^FAILED|error:|undefined reference' "$log.build" >&2 || tail -n 40 "$log.build" >&2
    echo "The build failed; its messages: $log.build" >&2
    exit 1
  fi
}

native() { "build/release/bin/$1" "${@:2}"; }
emulated() { qemu-aarch64-static -L "$sysroot" "$build/bin/$1" "${@:2}"; }

status=0
compare() {  # NAME FOUND EXPECTED
  if [ "$2" = "$3" ]; then
    echo "equal      $1  $2"
  else
    echo "different  $1  $2 instead of $3"
    status=1
  fi
}

check_test_bed() {
  local list=$folder/$1.scenarios
  emulated slalom-scenarios generate -c "configs/testbeds/$1.ini" -o "$list" -j "$jobs" --quiet --overwrite \
    >>"$log.test"
  compare "$1" "$(emulated slalom-scenarios list "$list" --hash)" \
    "$(sed -n "s/^| \`$1\`.*\`\([0-9a-f]\{32\}\)\` |.*/\1/p" docs/reference/testbeds.md)"
}

# Omits MRPT's method, in whose package for arm64 products and sums are rounded at once.
check_golden_campaign() {
  local run
  sed -n '/kSmallCampaign = R"(/,/^)";/{s/.*R"(//; /^)";/d; p}' tests/apps/program_run.h >"$folder/golden.ini"
  for run in native emulated; do
    rm -rf "${folder:?}/$run"
    "$run" slalom-evaluate "$folder/golden.ini" -o "$folder/$run" -j "$jobs" --quiet --set campaign.repetitions=2 \
      --set campaign.methods=gap --set limits.run_wall_time=3600 >>"$log.test"
    "$run" slalom-analyze dump "$folder/$run/runs.results" | sha256sum >"$folder/$run.hash"
  done
  compare "golden campaign, follow_the_gap" "$(cut -c1-32 "$folder/emulated.hash")" \
    "$(cut -c1-32 "$folder/native.hash")"
}

require
step "unpack packages in $sysroot"
make_sysroot
step "build"
compile
step "test"
: >"$log.test"
for set in slalom-dynamic-small slalom-small; do check_test_bed "$set"; done
check_golden_campaign
exit "$status"
