#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs missing packages, builds the programs that the demo needs, and evaluates four methods in two real
# laser-scanned buildings and 60 generated scenarios. Prints the tables and the path of the report.
set -euo pipefail
cd "$(dirname "$0")/.."

echo "1/3 Packages" >&2
scripts/install_packages.sh
echo "2/3 Build (two cores: about 4 minutes the first time)" >&2
scripts/build.sh release slalom-evaluate slalom_follow_the_gap
echo "3/3 Campaign: 280 runs (some seconds)" >&2
build/release/bin/slalom-evaluate configs/demo.ini -o out/demo -j "$(nproc)" --overwrite
