#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs clang-tidy (.clang-tidy; every finding is an error) on sources: scripts/check_tidy.sh [--all | FILE...]. Without
# arguments on those that changed since SLALOM_TIDY_BASE (origin/main, or where that is HEAD itself 20 commits before it),
# the latest change first: 16 in any case, more until SLALOM_TIDY_SECONDS (150) have passed; it names the others. Larger
# changes need --all. Checks nothing with another version than Debian 12's, which finds other things; with CI=true that
# is a failure.
set -euo pipefail
cd "$(dirname "$0")/.."
if ! clang-tidy --version 2>/dev/null | grep 'version 14\.' >/dev/null; then
  echo "clang-tidy: sources not checked, needs version 14" >&2
  [ "${CI:-}" != true ]
  exit
fi
at_least=16
seconds=${SLALOM_TIDY_SECONDS:-150}

base() {
  local main
  main=$(git merge-base HEAD "${SLALOM_TIDY_BASE:-origin/main}" 2>/dev/null || true)
  if [ -n "$main" ] && [ "$main" != "$(git rev-parse HEAD)" ]; then
    echo "$main"
  else
    git rev-list -n 21 --first-parent HEAD | tail -n 1
  fi
}

changed_files() {
  { git diff --name-only --diff-filter=d HEAD
    git log --format= --name-only --diff-filter=d "$(base)"..HEAD; } | awk '!seen[$0]++' |
    while read -r file; do [ ! -f "$file" ] || echo "$file"; done
}

case ${1:-} in
  --all) seconds=86400; files=$(git ls-files) ;;
  "") files=$(changed_files) ;;
  *) seconds=86400; files=$(printf '%s\n' "$@") ;;
esac
mapfile -t sources < <(grep -E '^(modules|adapters|reactive_algos|apps|tests|benchmarks)/.*\.cpp$' <<<"$files" || true)
[ ${#sources[@]} -gt 0 ] || exit 0

# One command for each source, without precompiled headers, which are GCC's. A source without one is of another system.
cmake --preset tidy --log-level=WARNING >/dev/null
cmake --build --preset tidy --target slalom_build_id_header slalom_lcm_headers slalom_ros2_messages >/dev/null
mapfile -t sources < <(printf '%s\n' "${sources[@]}" |
  grep -Fxf <(sed -n "s|^ *\"file\": \"$PWD/\(.*\)\".*|\1|p" build/tidy/compile_commands.json) || true)
end=$((SECONDS + seconds)) checked=0 status=0
log=$(mktemp) && trap 'rm -f "$log"' EXIT
for ((i = 0; i < ${#sources[@]} && (i < at_least || SECONDS < end); i += 8)); do
  batch=("${sources[@]:i:8}")
  printf '%s\0' "${batch[@]}" |
    xargs -0 -n 1 -P "$(nproc)" clang-tidy -p build/tidy --quiet --warnings-as-errors='*' >>"$log" 2>/dev/null || status=1
  checked=$((checked + ${#batch[@]}))
done
grep -E '(warning|error):' "$log" | sort -u || true
[ "$checked" -eq ${#sources[@]} ] || printf 'clang-tidy: not checked: %s\n' "${sources[@]:checked}"
echo "clang-tidy: $checked of ${#sources[@]} sources checked"
exit "$status"
