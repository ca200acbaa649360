#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Measures the two commands of README from nothing: scripts/check_cold.sh [--tests] [COMMIT...]
# Runs scripts/demo.sh, with --tests then scripts/test.sh, in a new clone of each commit (by default HEAD) with an empty
# compiler cache, one after another, and prints their times and, of several commits, the ratios to the first. Packages
# that are already installed are not installed again: their time is measured on a new machine only. Not part of
# scripts/test.sh.
set -euo pipefail
cd "$(dirname "$0")/.."
commands=(scripts/demo.sh)
if [ "${1:-}" = --tests ]; then
  commands+=(scripts/test.sh)
  shift
fi
[ $# -gt 0 ] || set -- HEAD

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
TIMEFORMAT='%R %U %S'
rows=() first=
for commit in "$@"; do
  revision=$(git rev-parse --short "$commit^{commit}")
  git clone --quiet . "$work/$revision"
  git -C "$work/$revision" checkout --quiet --detach "$revision"
  for command in "${commands[@]}"; do
    [ -x "$work/$revision/$command" ]
    echo "$command of $revision ..." >&2
    { time CCACHE_DIR=$work/$revision.ccache "$work/$revision/$command" >"$work/log" 2>&1; } 2>"$work/times" ||
      { tail -n 30 "$work/log" >&2; echo "$command of $revision failed" >&2; exit 1; }
    row=$(awk -v commit="$revision" -v command="$command" -v first="${first:-0}" '{
      printf "%-10s %-16s %8.0f %11.0f", commit, command, $1, $2 + $3
      if (first > 0) printf " %6.2f", ($2 + $3) / first
    }' <(tail -n 1 "$work/times"))
    rows+=("$row")
    [ -n "$first" ] || [ "$command" != scripts/demo.sh ] || first=$(awk '{ print $2 + $3 }' <(tail -n 1 "$work/times"))
  done
  rm -rf "${work:?}/$revision" "$work/$revision.ccache"
done
grep -m 1 'model name' /proc/cpuinfo | sed 's/.*: //'
echo "$(nproc) processors"
printf '%-10s %-16s %8s %11s %6s\n' commit command "wall, s" "compute, s" ratio
printf '%s\n' "${rows[@]}"
