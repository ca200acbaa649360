#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Packs what scripts/archive.sh packs as a Python wheel: scripts/wheel.sh
# It is for any Python from 3.8 on. Writes build/release/slalom-VERSION-py3-none-manylinux_2_Z_x86_64.whl; glibc 2.Z is the oldest that its files need.
# Needs the packages patchelf and binutils.
set -euo pipefail
cd "$(dirname "$0")/.." && source scripts/bundle.sh
[ "${1:-}" != --help ] || { sed -n '3,/^set /{/^set /d; s/^# \{0,1\}//; p}' scripts/wheel.sh && exit 0; }
[ $# -eq 0 ] || bundle_refuse "$1: expected no argument"
bundle_require
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bundle"
bundle_stage "$work/bundle"
mv "$work/bundle/lib/python3/dist-packages/slalom" "$work/slalom"
rmdir "$work/bundle/lib/python3/dist-packages" "$work/bundle/lib/python3"
mv "$work/bundle" "$work/slalom/bundle"
/usr/bin/python3 scripts/wheel.py "$work" "$(bundle_version)" "$(bundle_glibc "$work/slalom")" \
  "$(bundle_time)" build/release
