#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the API reference with Doxygen, build/release/api/html/index.html; a warning is an error. Its first page is the
# table of modules of docs/architecture.md.
set -euo pipefail
cd "$(dirname "$0")/.."
output=${1:-build/release/api}
mkdir -p "$output"
{
  echo "# Slalom's modules {#mainpage}"
  sed -n '/^## Modules$/,/^## Design invariants$/p' docs/architecture.md | sed '1d;$d'
} >"$output/modules.md"
version=$(sed -n 's/^project(slalom VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
{
  cat docs/Doxyfile
  echo "PROJECT_NUMBER = $version"
  echo "OUTPUT_DIRECTORY = $output"
  echo "INPUT += $output/modules.md"
  echo "USE_MDFILE_AS_MAINPAGE = $output/modules.md"
} | doxygen -
rm "$output/modules.md"
echo "API reference: $output/html/index.html"
