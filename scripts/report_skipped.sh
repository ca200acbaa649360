#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Prints the tests that a run of ctest skipped, with their reasons: scripts/report_skipped.sh BUILD_FOLDER. Fails when a
# reason is a package ("needs the package NAME") that the distribution has.
set -euo pipefail
source "$(dirname "$0")/apt.sh"
log=$1/Testing/Temporary/LastTest.log

# GoogleTest writes "FILE:LINE: Skipped", the reason, and "[  SKIPPED ] TEST"; other tests write "Skipped: REASON".
skipped=$(awk '
  /^[0-9]+\/[0-9]+ Test: / { name = $3 }
  /^Skipped: / { print name ": " substr($0, 10) }
  /: Skipped$/ { in_reason = 1; reason = ""; next }
  /^\[  SKIPPED \] .* \([0-9]+ ms\)$/ { if (in_reason) print $4 ": " reason; in_reason = 0; next }
  in_reason && NF { reason = reason (reason == "" ? "" : " ") $0 }
' "$log")
[ -n "$skipped" ] || exit 0
printf 'Skipped tests:\n%s\n' "$skipped"

status=0
for package in $(grep -oP 'needs the package \K[^ ,;]+' <<<"$skipped" | sort -u); do
  if is_available "$package"; then
    echo "Tests were skipped for want of $package, which this distribution has (scripts/packages_test.txt)." >&2
    status=1
  fi
done
exit "$status"
