#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs missing packages, checks format, documents and comments, builds with warnings as errors, and runs all tests: in
# release mode, and again under the address and undefined-behavior sanitizers; runs clang-tidy on changes. Prints the time of each step.
set -euo pipefail
cd "$(dirname "$0")/.."

steps=() since=$SECONDS
finish_step() {
  steps+=("$(printf '%5d s  %s' $((SECONDS - since)) "$1")")
  since=$SECONDS
}

scripts/install_packages.sh --tests
finish_step "install packages"
scripts/check_format.sh
scripts/check_documents.py
scripts/check_comments.py
scripts/check_includes.py
# All parts: one that is not found would leave out its tests.
mapfile -t parts < <(sed -n 's/^slalom_part(\([A-Z0-9]*\) .*/-DSLALOM_WITH_\1=ON/p' cmake/SlalomParts.cmake)
scripts/build.sh release -DSLALOM_WARNINGS_AS_ERRORS=ON "${parts[@]}"
finish_step "build, release"
ctest --preset release -j 2
scripts/report_skipped.sh build/release
finish_step "test, release"
scripts/check_tidy.sh
finish_step "clang-tidy of what changed"
# Clang compiles instrumented code in about two thirds of GCC's time.
compiler=()
command -v clang++-14 >/dev/null && compiler=(-DCMAKE_C_COMPILER=clang-14 -DCMAKE_CXX_COMPILER=clang++-14)
scripts/build.sh asan "${compiler[@]}" "${parts[@]}"
finish_step "build, sanitizers"
ctest --preset asan -j 2 -LE slow
scripts/report_skipped.sh build/asan
finish_step "test, sanitizers"
printf '%s\n' "${steps[@]}"
