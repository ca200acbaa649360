#!/usr/bin/env bash
# Fails if a C or C++ file, in the repository or new, is not formatted according to .clang-format; --fix reformats it.
set -euo pipefail
cd "$(dirname "$0")/.."
mode=(--dry-run --Werror)
[ "${1:-}" = "--fix" ] && mode=(-i)
git ls-files -z --cached --others --exclude-standard '*.h' '*.cpp' '*.c' |
  while IFS= read -r -d '' file; do [ ! -f "$file" ] || printf '%s\0' "$file"; done |
  xargs -0 clang-format-14 "${mode[@]}"
