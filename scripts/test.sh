#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs missing packages, builds everything in the build folder of the demo, and runs all tests: scripts/test.sh.
# With --all also what takes longer: the checks of format, documents, comments, includes and size; tests that build the project
# again; the benchmarks are built; clang-tidy on what changed; all tests again under the address and undefined-behavior
# sanitizers. Prints the time of each step, and the number of tests.
set -euo pipefail
cd "$(dirname "$0")/.."
all=${1:-}
[[ $# -le 1 && ( -z $all || $all == --all ) ]] || { echo "usage: scripts/test.sh [--all]" >&2; exit 2; }

steps=() since=$SECONDS passed=0 failed=0
finish_step() {
  steps+=("$(printf '%5d s  %s' $((SECONDS - since)) "$1")")
  since=$SECONDS
}
# Runs the tests of a preset, and counts them.
run_tests() {
  local preset=$1 log=build/$1/ctest.log counts
  shift
  ctest --preset "$preset" -j "$(nproc)" "$@" 2>&1 | tee "$log" || failed=1
  counts=$(sed -nE 's/^[0-9]+% tests passed, ([0-9]+) tests failed out of ([0-9]+)$/\1 \2/p' "$log")
  passed=$((passed + ${counts#* } - ${counts% *})) failed=$((failed > ${counts% *} ? failed : ${counts% *}))
  [ "$failed" -eq 0 ] || { printf '%d passed, %d failed\n' "$passed" "$failed"; exit 1; }
  scripts/report_skipped.sh "build/$preset"
}

scripts/install_packages.sh --tests
finish_step "install packages"
if [ "$all" ]; then
  scripts/check_format.sh
  scripts/check_documents.py
  scripts/check_comments.py
  scripts/check_includes.py
fi
# All parts: one that is not found would leave out its tests.
mapfile -t parts < <(sed -n 's/^slalom_part(\([A-Z0-9]*\) .*/-DSLALOM_WITH_\1=ON/p' cmake/SlalomParts.cmake)
targets=()
[ -z "$all" ] || targets=(all slalom_benchmarks)
scripts/build.sh release "${parts[@]}" "${targets[@]}"
[ -z "$all" ] || scripts/check_budget.py . build/release/bin
finish_step "build, release"
if [ "$all" ]; then
  run_tests release
else
  run_tests release -LE builds
fi
finish_step "test, release"
if [ "$all" ]; then
  scripts/check_tidy.sh
  finish_step "clang-tidy of what changed"
  # Clang compiles instrumented code in about two thirds of GCC's time.
  compiler=()
  command -v clang++-14 >/dev/null && compiler=(-DCMAKE_C_COMPILER=clang-14 -DCMAKE_CXX_COMPILER=clang++-14)
  scripts/build.sh asan "${compiler[@]}" "${parts[@]}"
  finish_step "build, sanitizers"
  run_tests asan -LE slow
  finish_step "test, sanitizers"
fi
printf '%s\n' "${steps[@]}"
printf '%d passed, %d failed\n' "$passed" "$failed"
