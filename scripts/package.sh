#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the Debian packages slalom, libslalom-dev, python3-slalom and slalom-doc in build/release, and checks them with
# lintian: scripts/package.sh
set -euo pipefail
cd "$(dirname "$0")/.."
for tool in doxygen lintian mkdocs; do
  command -v $tool >/dev/null || { echo "needs the package $tool" >&2; exit 1; }
done
scripts/build.sh release packaged
scripts/docs.sh build/release/site
(cd build/release && rm -f ./*.deb && cpack -G DEB)
lintian --fail-on error build/release/*.deb
ls -l build/release/*.deb
