#!/usr/bin/env bash
# Installs what is missing, checks the format, builds, and runs every test: as release, and the unit
# tests once more under the address and undefined-behaviour sanitizers.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_packages.sh --tests
scripts/check_format.sh
scripts/build.sh release
ctest --preset release -j 2
scripts/build.sh asan
ctest --preset asan -j 2 -LE slow
