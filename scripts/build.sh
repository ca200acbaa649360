#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Configures and builds one preset: scripts/build.sh [release|dev|asan] [-DOPTION=VALUE...] [TARGET...]
# With CI=true a warning of the release build is an error, and so is an object that reads a generated file and may be
# compiled before it; the command lines, and so the objects in a compiler cache, are the same.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/progress.sh
preset=${1:-release}
options=() targets=()
for argument in "${@:2}"; do
  if [[ $argument == -D* ]]; then options+=("$argument"); else targets+=("$argument"); fi
done

cmake --preset "$preset" --log-level=WARNING "${options[@]}" >/dev/null
export NINJA_STATUS='[%f/%t] '
log=$(mktemp)
trap 'rm -f "$log"' EXIT
cmake --build --preset "$preset" ${targets:+--target "${targets[@]}"} 2>&1 | tee "$log" | show_build_progress
if [ "${CI:-}" = true ] && [ "$preset" = release ]; then
  ! grep ' warning: ' "$log" >&2 || { echo "The build has warnings." >&2; exit 1; }
  ninja -C "build/$preset" -t missingdeps >"$log" || { cat "$log" >&2; exit 1; }
fi
