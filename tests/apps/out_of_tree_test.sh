#!/usr/bin/env bash
# Installs Slalom into a fresh folder, builds the example methods against it as their authors would,
# and runs a campaign with the installed programs: out_of_tree_test.sh SOURCE_FOLDER BUILD_FOLDER
set -euo pipefail
source=$1 build=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
warnings="-Wall -Wextra -Werror"

cmake --install "$build" --prefix "$folder/installed" >/dev/null
for example in library_method library_method_cpp; do
  cp -r "$source/examples/$example" "$folder/$example"
  cd "$folder/$example"
  cmake --no-warn-unused-cli -S . -B build -DCMAKE_PREFIX_PATH="$folder/installed" \
        -DCMAKE_C_FLAGS="$warnings" -DCMAKE_CXX_FLAGS="$warnings" >/dev/null
  cmake --build build >/dev/null
  "$folder/installed/bin/slalom-evaluate" campaign.ini -o out --quiet --set scenarios.count=6 >/dev/null
  runs=$("$folder/installed/bin/slalom-analyze" dump out/runs.results)
  fail() { echo "$example: $1:" && echo "$runs" && exit 1; }
  [ "$(wc -l <<<"$runs")" -eq 6 ] || fail "expected 6 runs, got"
  grep -q '"outcome":"success"' <<<"$runs" || fail "no run succeeded"
  ! grep -q '"outcome":"method_' <<<"$runs" || fail "the method failed"
done
