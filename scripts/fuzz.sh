#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Fuzzes the readers of files and messages: scripts/fuzz.sh [SECONDS per target] [TARGET...]
# Requires clang-14 and libclang-rt-14-dev. Findings are written to build/fuzz/found; inputs of fixed defects belong in
# tests/fuzz/corpus/TARGET, which every test run replays. Longer inputs of the corpus are cut to 4,096 bytes here, since
# the slowest ones would leave little time for others.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-60}
shift || true

cmake --preset fuzz --log-level=WARNING
cmake --build --preset fuzz --target fuzz
mkdir -p build/fuzz/found
failed=0
total=0
for folder in tests/fuzz/corpus/*/; do
  target=$(basename "$folder")
  [ $# -eq 0 ] || [[ " $* " == *" $target "* ]] || continue
  mkdir -p "build/fuzz/found/$target"
  echo "== $target"
  "build/fuzz/bin/fuzz_$target" -max_total_time="$seconds" -max_len=4096 -rss_limit_mb=2048 -timeout=10 \
    -print_final_stats=1 -artifact_prefix="build/fuzz/found/$target-" "build/fuzz/found/$target" "$folder" \
    2>"build/fuzz/found/$target.log" || { failed=1; tail -n 40 "build/fuzz/found/$target.log"; }
  inputs=$(sed -n 's/^stat::number_of_executed_units: *//p' "build/fuzz/found/$target.log")
  echo "   ${inputs:-0} inputs"
  total=$((total + ${inputs:-0}))
done
echo "$total inputs in total"
exit $failed
