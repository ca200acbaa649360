#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Configures and builds one preset: scripts/build.sh [release|dev|asan] [-DOPTION=VALUE...] [TARGET...]
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}
options=() targets=()
for argument in "${@:2}"; do
  if [[ $argument == -D* ]]; then options+=("$argument"); else targets+=("$argument"); fi
done

export NINJA_STATUS='[%f/%t, %e s] '
cmake --preset "$preset" --log-level=WARNING "${options[@]}"
cmake --build --preset "$preset" ${targets:+--target "${targets[@]}"}
