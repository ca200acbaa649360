#!/usr/bin/env bash
# Installs Slalom into a fresh folder, builds examples/ against it as their authors would, and runs a
# campaign with the installed programs: out_of_tree_test.sh SOURCE_FOLDER BUILD_FOLDER
set -euo pipefail
source=$1 build=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

cmake --install "$build" --prefix "$folder/installed" >/dev/null
cp -r "$source/examples/library_method" "$folder/mine"
cd "$folder/mine"
cmake -S . -B build -DCMAKE_PREFIX_PATH="$folder/installed" -DCMAKE_C_FLAGS="-Wall -Wextra -Werror" >/dev/null
cmake --build build >/dev/null
"$folder/installed/bin/slalom-evaluate" campaign.ini -o out --quiet --set scenarios.count=6
runs=$("$folder/installed/bin/slalom-analyze" dump out/runs.results)
[ "$(wc -l <<<"$runs")" -eq 6 ] || { echo "expected 6 runs, got:"; echo "$runs"; exit 1; }
grep -q '"outcome":"success"' <<<"$runs" || { echo "no run succeeded:"; echo "$runs"; exit 1; }
! grep -q '"outcome":"method_' <<<"$runs" || { echo "the method failed:"; echo "$runs"; exit 1; }
