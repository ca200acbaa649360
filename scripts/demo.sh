#!/usr/bin/env bash
# From nothing to tables: installs what is missing, builds, and evaluates four methods in two real
# laser-scanned buildings and 60 generated places. Ends with the tables and the path of the report.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_packages.sh
scripts/build.sh release
build/release/bin/slalom-evaluate configs/demo.ini -o out/demo -j 2
