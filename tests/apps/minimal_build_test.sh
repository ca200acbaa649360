#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds Slalom without its optional parts, beside the full build, and compares a campaign of both:
#   minimal_build_test.sh SOURCE_FOLDER BUILD_FOLDER
set -euo pipefail
source=$1 build=$2
minimal=$build-minimal # as deep as the full build: the compiler cache knows its objects
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "$1:" && cat "$2" && exit 1; }

parts=$(sed -n 's/^slalom_part(\([A-Z0-9]*\) .*/\1/p' "$source/cmake/SlalomParts.cmake")
[ "$(wc -w <<<"$parts")" -ge 6 ] || { echo "expected at least 6 optional parts, got: $parts"; exit 1; }
settings=$(sed -nE 's/^((CMAKE_(BUILD_TYPE|UNITY_BUILD|UNITY_BUILD_BATCH_SIZE|CXX_COMPILER)|SLALOM_WARNINGS_AS_ERRORS):[A-Z]+=.*)/-D\1/p' \
  "$build/CMakeCache.txt")
# The cache would take an old precompiled header for an input of the new one.
[ ! -d "$minimal" ] || find "$minimal" -name "*.gch" -delete
cmake -S "$source" -B "$minimal" -G Ninja $settings -DSLALOM_BUILD_TESTS=OFF -DSLALOM_BUILD_BENCHMARKS=OFF \
  $(printf -- '-DSLALOM_WITH_%s=OFF ' $parts) >"$work/log" 2>&1 || fail "CMake failed" "$work/log"
cmake --build "$minimal" --target slalom-evaluate slalom-analyze slalom_follow_the_gap >"$work/log" 2>&1 ||
  fail "the build failed" "$work/log"
ldd "$minimal/bin/slalom-evaluate" "$minimal/bin/slalom-analyze" >"$work/libraries"
! grep -E 'lib(ompl|lcm|python[0-9.]*|opencv_dnn|ddsc|xlsxwriter|mrpt-gui)\.so' "$work/libraries" ||
  fail "libraries of optional parts" "$work/libraries"

cat >"$work/my.ini" <<'END'
[campaign]
methods = gap
[scenarios]
generator = random
count     = 6
[method.gap]
adapter = library
plugin  = libslalom_follow_the_gap.so
END
run() { "$1/bin/slalom-evaluate" "$work/my.ini" -o "$2" --quiet "${@:3}" >/dev/null; }
run "$build" "$work/full"
run "$minimal" "$work/minimal"
for name in full minimal; do "$build/bin/slalom-analyze" dump "$work/$name/runs.results" >"$work/$name.dump"; done
[ "$(wc -l <"$work/full.dump")" = 6 ] || fail "expected 6 runs" "$work/full.dump"
diff "$work/full.dump" "$work/minimal.dump"

# Parts that were not built are named.
refused() {
  if run "$minimal" "$work/out" "${@:2}" 2>"$work/error"; then fail "expected an error of $1" "$work/error"; fi
  grep -q "built without this part; expected all targets of a build by CMake with -DSLALOM_WITH_$1=ON" "$work/error" ||
    fail "expected $1 in the error" "$work/error"
}
for adapter in lcm onnx python ros2; do refused "${adapter^^}" --set "method.gap.adapter=$adapter"; done
refused OMPL --set robot.min_turning_radius=0.3 --set robot.forward_only=true
if "$minimal/bin/slalom-analyze" export "$work/full/runs.results" -o "$work/t.xlsx" 2>"$work/error"; then
  fail "expected an error of XLSX" "$work/error"
fi
grep -q SLALOM_WITH_XLSX "$work/error" || fail "expected XLSX in the error" "$work/error"
