#!/usr/bin/env bash
# Fuzzes the readers of files: scripts/fuzz.sh [SECONDS for each target] [TARGET...]
# Needs clang-14 and libclang-rt-14-dev. What is found lies in build/fuzz/found; a crasher that was mended goes into
# tests/fuzz/corpus/TARGET, where every test run replays it.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-60}
shift || true

cmake --preset fuzz --log-level=WARNING
cmake --build --preset fuzz --target fuzz
mkdir -p build/fuzz/found
failed=0
for folder in tests/fuzz/corpus/*/; do
  target=$(basename "$folder")
  [ $# -eq 0 ] || [[ " $* " == *" $target "* ]] || continue
  mkdir -p "build/fuzz/found/$target"
  echo "== $target"
  "build/fuzz/bin/fuzz_$target" -max_total_time="$seconds" -rss_limit_mb=2048 -timeout=10 -print_final_stats=1 \
    -artifact_prefix="build/fuzz/found/$target-" "build/fuzz/found/$target" "$folder" \
    2>"build/fuzz/found/$target.log" || { failed=1; tail -n 40 "build/fuzz/found/$target.log"; }
  grep -E "number_of_executed_units|DONE" "build/fuzz/found/$target.log" || true
done
exit $failed
