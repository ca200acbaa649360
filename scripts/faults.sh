#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Ends, interrupts and obstructs the programs of the release build at random moments and prints a table of the cases:
# what must hold, and what was seen. Exit status 1 if they differ.
#
#   scripts/faults.sh [SECONDS [GROUP...]]
#
# SECONDS (default 60) is the time of the repeated cases of each group; `scripts/faults.sh 600 resume` ends campaigns more
# than 1,000 times. A group is a script tests/faults/GROUP.sh: it
# runs in an empty folder with the programs on PATH, gets SECONDS as its argument and prints a line
# "case<TAB>expected<TAB>seen" for each case.
set -u
root=$(cd "$(dirname "$0")/.." && pwd)
export PATH="${SLALOM_BIN:-$root/build/release/bin}:$PATH"
export SLALOM_FAULTY="${SLALOM_FAULTY:-$root/build/release/tests/faults/libfaulty_method.so}"
seconds=${1:-60}
[ $# -gt 0 ] && shift
groups=("$@")
if [ ${#groups[@]} -eq 0 ]; then
  for script in "$root"/tests/faults/*.sh; do groups+=("$(basename "$script" .sh)"); done
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

failed=0
printf '%-60s %-40s %s\n' case expected seen
for group in "${groups[@]}"; do
  script="$root/tests/faults/$group.sh"
  [ -f "$script" ] || { echo "faults.sh: no group '$group' in tests/faults" >&2; exit 2; }
  mkdir "$folder/$group"
  cases=0
  while IFS=$'\t' read -r name expected seen; do
    cases=$((cases + 1))
    mark=
    [ "$expected" = "$seen" ] || { failed=1; mark='   <-- differs'; }
    printf '%-60s %-40s %s\n' "$group: $name" "$expected" "$seen$mark"
  done < <(cd "$folder/$group" && bash "$script" "$seconds")
  [ $cases -gt 0 ] || { failed=1; echo "$group: no case was run"; }
done
exit $failed
