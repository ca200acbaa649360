#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds Slalom and runs its tests in another release of Debian, in a chroot; prints what failed. Requires root, and
# debootstrap:
#   scripts/check_platform.sh [--folder DIR] [--mirror URL] [--jobs N] [--required-only] SUITE [CTEST_OPTION...]
#   scripts/check_platform.sh --packages [--folder DIR] [--mirror URL] [--jobs N] SUITE
#   scripts/check_platform.sh [--folder DIR] [--mirror URL] [--jobs N] arm64
# SUITE is a code name, for example trixie (Debian 13). DIR (default: ${TMPDIR:-/tmp}/slalom-SUITE) holds the chroot, the
# build and the compiler cache, about 8 GB; a second call continues there, so `rm -r DIR` starts afresh. N is the number
# of processes, default 2. With --required-only the packages of scripts/packages_test.txt are left out, and the tests that
# need them are skipped. Tests: those that are not slow, or those that the options of ctest select (`-R Golden`). With
# --packages the packages of that release are made instead of running tests, for scripts/check_packages.sh. With arm64 the
# programs are cross-compiled and emulated, without a chroot and without root, by scripts/check_arm64.sh.
set -euo pipefail
script=$(realpath "$0")
source_folder=$(dirname "$(dirname "$script")")

usage() {
  sed -n '3,/^set /{/^set /d; s/^# \{0,1\}//; p}' "$script"
}

refuse() {
  echo "check_platform.sh: $1" >&2
  exit 2
}

folder= mirror=http://deb.debian.org/debian jobs=2 test_packages=--tests packages=
arguments=("$@")
while [[ ${1:-} == -* ]]; do
  case $1 in
    --help) usage && exit 0 ;;
    --required-only) test_packages= && shift && continue ;;
    --packages) packages=1 test_packages= && shift && continue ;;
    --folder | --mirror | --jobs) [ $# -ge 2 ] || refuse "$1: expected a value" ;;
    *) refuse "unknown option $1; expected --folder, --mirror, --jobs, --required-only, --packages or --help" ;;
  esac
  declare "${1#--}=$2"
  shift 2
done
[ $# -ge 1 ] || refuse "expected the code name of a release of Debian, for example trixie"
suite=$1
shift
[[ $suite =~ ^([a-z]+|arm64)$ ]] || refuse "$suite: expected the code name of a release of Debian, for example trixie"
[[ $jobs =~ ^[1-9][0-9]*$ ]] || refuse "--jobs $jobs: expected a number of processes from 1"
selection=("$@")
[ -z "$packages" ] || [ $# -eq 0 ] || refuse "$1: --packages runs no tests, so it takes no options of ctest"
[ $# -gt 0 ] || selection=(-LE slow)
folder=${folder:-${TMPDIR:-/tmp}/slalom-$suite}

if [ "$suite" = arm64 ]; then
  [ -z "$packages" ] || refuse "--packages: arm64 has emulated programs only, no packages"
  [ $# -eq 0 ] || refuse "$1: arm64 runs no tests of ctest, so it takes no options of it"
  exec "$source_folder/scripts/check_arm64.sh" "$folder" "$mirror" "$jobs"
fi

[ "$(id -u)" -eq 0 ] || refuse "a chroot is made by root only; use sudo"
command -v debootstrap >/dev/null || refuse "needs the package debootstrap"

# In namespaces of its own: the mounts and processes inside end with this script, also after Ctrl-C or kill -9.
if [ -z "${SLALOM_CHECK_PLATFORM_INSIDE:-}" ]; then
  SLALOM_CHECK_PLATFORM_INSIDE=1 exec unshare --mount --propagation private --pid --fork --kill-child \
    "$script" "${arguments[@]}"
fi
unset SLALOM_CHECK_PLATFORM_INSIDE
trap 'exit 130' INT TERM  # the first process of a namespace ignores signals that it does not handle

mkdir -p "$folder/ccache"
folder=$(realpath "$folder")
root=$folder/root
log=$folder/log
build=build/release

step() { echo "== $suite: $1" >&2; }

inside() {
  chroot "$root" /usr/bin/env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root \
    LC_ALL=C.UTF-8 CCACHE_DIR=/ccache \
    bash -c 'cd /slalom && exec "$@"' bash "$@"
}

make_root() {
  # debootstrap removes its own folder at the end; while it exists the chroot is incomplete.
  if [ -d "$root/debootstrap" ]; then rm -rf --one-file-system "$root"; fi
  [ -e "$root/etc/debian_version" ] || debootstrap --variant=minbase "$suite" "$root" "$mirror" >"$log.debootstrap"
  # Installs in a fraction of the time; a chroot that a power failure damages is made anew.
  echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/unsafe-io"
}

mount_folders() {
  mount -t proc proc "$root/proc"
  mount --rbind /dev "$root/dev"
  mount --rbind /sys "$root/sys"
  mkdir -p "$root/ccache" "$root/slalom"
  mount --bind "$folder/ccache" "$root/ccache"
}

# The files of the repository and new ones, with their times: unchanged ones are not compiled again.
copy_sources() {
  find "$root/slalom" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} +
  (cd "$source_folder" && git ls-files -z --cached --others --exclude-standard |
    while IFS= read -r -d '' file; do [ ! -e "$file" ] || printf '%s\0' "$file"; done |
    tar --null --files-from=- -cf -) | tar -C "$root/slalom" -xf - --no-same-owner
}

step "make the chroot in $root"
make_root
mount_folders
copy_sources

step "install packages"
inside scripts/install_packages.sh ${test_packages:+"$test_packages"}

if [ "$packages" ]; then
  step "make packages"
  inside apt-get install -y --no-install-recommends -qq doxygen lintian >/dev/null
  inside env CMAKE_BUILD_PARALLEL_LEVEL="$jobs" scripts/package.sh
  echo "Check them: scripts/check_packages.sh $suite $root/slalom/$build"
  exit 0
fi

step "build"
inside cmake --preset release --log-level=WARNING
if ! inside cmake --build "$build" -j "$jobs" -- -k 0 >"$log.build" 2>&1; then
  grep -E '^FAILED|error:|undefined reference' "$log.build" >&2 || tail -n 40 "$log.build" >&2
  echo "The build failed; its messages: $log.build" >&2
  exit 1
fi

step "test"
status=0
inside ctest --preset release -j "$jobs" "${selection[@]}" >"$log.test" 2>&1 || status=$?
inside scripts/report_skipped.sh "$build" || [ -z "$test_packages" ] || status=1
sed -n '/tests passed/,$p' "$log.test"
[ "$status" -eq 0 ] || echo "Tests failed; their messages: $log.test" >&2
exit "$status"
