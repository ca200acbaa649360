#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Fails if a source, in the repository or new, does not name its license (examples, which are to be copied, need not), or if
# a C or C++ file is not formatted according to .clang-format; --fix reformats it.
# Where clang-format-14 is missing, as on Debian 13, nothing is checked, since other versions format differently; with
# CI=true that is a failure.
set -euo pipefail
cd "$(dirname "$0")/.."
license="SPDX-License-Identifier: BSD-3-Clause"
unnamed=$(git grep --untracked -L "$license" -- '*.h' '*.cpp' '*.c' '*.cpp.in' '*.py' '*.pyi' '*.sh' '*.js' '*.css' '*.lcm' \
  '*.java' '*.lua' '*.cmake' '*CMakeLists.txt' .ci/run ':!examples' || true)
[ -z "$unnamed" ] || { printf '%s: no license; expected the comment "'"$license"'"\n' $unnamed >&2; exit 1; }
if ! command -v clang-format-14 >/dev/null; then
  echo "Format not checked: needs the package clang-format-14" >&2
  [ "${1:-}" != "--fix" ] && [ "${CI:-}" != true ]
  exit
fi
mode=(--dry-run --Werror)
[ "${1:-}" = "--fix" ] && mode=(-i)
git ls-files -z --cached --others --exclude-standard '*.h' '*.cpp' '*.c' |
  while IFS= read -r -d '' file; do [ ! -f "$file" ] || printf '%s\0' "$file"; done |
  xargs -0 clang-format-14 "${mode[@]}"
