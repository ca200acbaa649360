#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs the example and checks what it prints and writes: ompl_benchmark_test.sh PROGRAM
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$1" "$folder/benchmark.log" >"$folder/out" 2>/dev/null
fail() { echo "$1:" && cat "$folder/out" && exit 1; }
awk '
  $1 == "geometric_ExactDiscPlanner:" { exact = $2; for (i = 3; i <= NF; ++i) if ($i != exact) bad = 1; next }
  { ++others; for (i = 2; i <= NF; ++i) if ($i ~ /^[0-9]/ && $i < exact) bad = 1 }
  END { exit !(exact > 0 && others == 2 && !bad) }' "$folder/out" \
  || fail "expected one length of the exact planner, and no shorter one of the two others"
grep -q '^Experiment slalom$' "$folder/benchmark.log" || fail "no log of OMPL's benchmark"
grep -q '^3 planners$' "$folder/benchmark.log" || fail "not three planners in the log"
