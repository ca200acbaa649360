#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Configures and builds one preset: scripts/build.sh [release|dev|asan] [-DOPTION=VALUE...] [TARGET...]
# With CI=true warnings are errors.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/progress.sh
preset=${1:-release}
options=() targets=()
[ "${CI:-}" != true ] || options+=(-DSLALOM_WARNINGS_AS_ERRORS=ON)
for argument in "${@:2}"; do
  if [[ $argument == -D* ]]; then options+=("$argument"); else targets+=("$argument"); fi
done

cmake --preset "$preset" --log-level=WARNING "${options[@]}" >/dev/null
export NINJA_STATUS='[%f/%t] '
cmake --build --preset "$preset" ${targets:+--target "${targets[@]}"} | show_build_progress
