#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Packs the finished release build with all libraries that it needs, for any Linux: scripts/archive.sh
# Libraries for programs of the system, such as libslalom.so, need the glibc that it prints or a newer one.
# Writes build/release/slalom-VERSION-x86_64.tar.zst: one folder with the programs, the shipped methods, the Python package,
# a Python with NumPy for methods in Python, and the licenses of all of them. Needs the packages binutils, patchelf and zstd.
set -euo pipefail
cd "$(dirname "$0")/.." && source scripts/bundle.sh
[ "${1:-}" != --help ] || { sed -n '3,/^set /{/^set /d; s/^# \{0,1\}//; p}' scripts/archive.sh && exit 0; }
[ $# -eq 0 ] || bundle_refuse "$1: expected no argument"
bundle_require zstd
name=slalom-$(bundle_version)-x86_64
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/$name"
bundle_stage "$work/$name"
bundle_launchers "$work/$name"
tar -C "$work" --sort=name --mtime="@$(bundle_time)" --owner=0 --group=0 --numeric-owner -c "$name" |
  zstd -19 --long=27 -T2 -q -f -o "build/release/$name.tar.zst"
echo "$(du -sm "$work/$name" | cut -f1) MB unpacked, glibc 2.$(bundle_glibc "$work/$name")"
ls -l "build/release/$name.tar.zst"
