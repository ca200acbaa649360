#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs Slalom into a temporary folder, builds the examples against it, and runs a campaign with the installed
# programs and an evaluation with the installed libraries: out_of_tree_test.sh SOURCE_FOLDER BUILD_FOLDER
set -Eeuo pipefail
trap 'echo "line $LINENO: $BASH_COMMAND: failed"' ERR
source=$1 build=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
warnings="-Wall -Wextra -Werror"

build_example() {
  cp -r "$source/examples/$1" "$folder/$1"
  cd "$folder/$1"
  cmake --no-warn-unused-cli -S . -B build -DCMAKE_PREFIX_PATH="$folder/installed" "${@:2}" \
        -DCMAKE_C_FLAGS="$warnings" -DCMAKE_CXX_FLAGS="$warnings" >/dev/null
  cmake --build build >/dev/null
}

cmake --install "$build" --prefix "$folder/installed" >/dev/null
for example in library_method library_method_cpp; do
  build_example $example
  "$folder/installed/bin/slalom-evaluate" campaign.ini -o out --quiet --set scenarios.count=6 >/dev/null
  runs=$("$folder/installed/bin/slalom-analyze" dump out/runs.results)
  fail() { echo "$example: $1:" && echo "$runs" && exit 1; }
  [ "$(wc -l <<<"$runs")" -eq 6 ] || fail "expected 6 runs, got"
  grep -q '"outcome":"success"' <<<"$runs" || fail "no run succeeded"
  ! grep -q '"outcome":"method_' <<<"$runs" || fail "the method failed"
done

# The installed demo has its own maps.
sed -i 's,/usr/share/mrpt,/nonexistent,' "$folder/installed/share/slalom/configs/demo.ini"
(cd "$folder" && "$folder/installed/bin/slalom-evaluate" --demo --quiet --set campaign.methods=follow_the_gap >/dev/null && test -s slalom-demo/report/index.html)

# docs/develop/library.md shows the program and its output.
block() { sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/p" "$source/docs/develop/library.md" | sed '1d;$d'; }
# Its components need no packages of others.
build_example library_cpp $(printf -- '-DCMAKE_DISABLE_FIND_PACKAGE_%s=ON ' ompl pybind11 Python OpenCV mrpt-gui)
diff <(block cpp) main.cpp
./build/my_evaluation >output
diff <(block text) output

build_example c_interface
./build/my_evaluation >output
diff <(block plain) output

build_example ompl_benchmark
"$source/tests/adapters/planners/ompl/ompl_benchmark_test.sh" ./build/ompl_benchmark

mkdir "$folder/absent" && cd "$folder/absent"
printf '%s\n' 'cmake_minimum_required(VERSION 3.20)' 'project(absent)' 'find_package(slalom REQUIRED COMPONENTS evaluate nothing)' \
  >CMakeLists.txt
! cmake -S . -B build -DCMAKE_PREFIX_PATH="$folder/installed" >log 2>&1
grep -q 'this Slalom was built without: nothing' log || { cat log; exit 1; }
