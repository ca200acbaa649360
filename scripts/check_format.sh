#!/usr/bin/env bash
# Fails when a C or C++ file differs from what .clang-format says; --fix rewrites it.
set -euo pipefail
cd "$(dirname "$0")/.."
mode=(--dry-run --Werror)
[ "${1:-}" = "--fix" ] && mode=(-i)
git ls-files -z '*.h' '*.cpp' '*.c' | xargs -0 clang-format-14 "${mode[@]}"
