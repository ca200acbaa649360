#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Verifies the bundles of a folder that the registry has not verified yet, and writes the site:
# verify.sh [ENTRIES [SITE [VERIFICATIONS]]], default entries, site and verifications. VERIFICATIONS is a folder that
# authors of entries cannot write: it has a file for each bundle, by its hash. Environment variables: FRACTION, the part
# of the scenarios that is run again (0.02); TRUST=1 to run the methods that bundles contain, in a container that may be
# lost; JOBS (0: all cores); REPORTS=0 for a site without a report of each bundle. Exit status 1 if an entry is different.
set -euo pipefail
entries=${1:-entries} site=${2:-site} verifications=${3:-verifications} status=0 options=()
[ "${TRUST:-0}" = 0 ] || options+=(--trust)
while IFS= read -r -d '' bundle; do
  echo "$bundle"
  slalom-simulate verify "$bundle" --fraction "${FRACTION:-0.02}" -j "${JOBS:-0}" --badge-folder "$verifications" --new \
    --quiet "${options[@]}" || status=1
done < <(find "$entries" -name '*.slalom' -print0 | sort -z)
site_options=()
[ "${REPORTS:-1}" = 1 ] || site_options+=(--no-reports)
slalom-analyze registry "$entries" -o "$site" --verifications "$verifications" "${site_options[@]}" || status=1
exit "$status"
