#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the C++ example method against an installed Slalom, generates the messages of the Lua and the Java example, and
# runs each in a campaign: lcm_examples_test.sh SOURCE_FOLDER BUILD_FOLDER
set -euo pipefail
source=$1 build=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

check() {
  # A slow machine is no failure of the example.
  "$folder/installed/bin/slalom-evaluate" campaign.ini -o out --quiet --set scenarios.count=4 \
    --set method.mine.deadline=100 --set method.mine.startup_time=100 >/dev/null
  local runs
  runs=$("$folder/installed/bin/slalom-analyze" dump out/runs.results)
  [ "$(grep -c '"outcome":"success"' <<<"$runs")" -ge 3 ] || { echo "$1: too few successes:"; echo "$runs"; exit 1; }
  ! grep -q '"outcome":"method_' <<<"$runs" || { echo "$1: the method failed:"; echo "$runs"; exit 1; }
}

cmake --install "$build" --prefix "$folder/installed" >/dev/null
cp -r "$source"/examples/lcm_method_{cpp,java,lua} "$folder"
cd "$folder/lcm_method_cpp"
cmake -S . -B build -DCMAKE_PREFIX_PATH="$folder/installed" >/dev/null
cmake --build build >/dev/null
check "C++"
lua5.2 -e 'require("lcm")' 2>/dev/null || { echo "Skipped: the example in Lua needs the package liblcm-lua"; exit 77; }
cd "$folder/lcm_method_lua"
lcm-gen --lua --lpath types "$folder"/installed/share/slalom/lcm_types/*.lcm
check "Lua"

cd "$folder/lcm_method_java"
skip() {
  echo "Skipped: $1"
  exit 77
}
command -v javac >/dev/null || skip "needs the package default-jdk-headless"
[ -e /usr/share/java/lcm.jar ] || skip "needs the package liblcm-java"
lcm-gen --java --jpath types "$folder"/installed/share/slalom/lcm_types/*.lcm
javac -cp /usr/share/java/lcm.jar -d classes MyMethod.java types/slalom/*.java
check "Java"
