#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes the README's picture of the report of the demo campaign, after scripts/demo.sh: report_picture.sh
# [REPORT_FOLDER [PICTURE]]. To be run again whenever the report or what the demo computes has changed.
set -euo pipefail
root=$(dirname "$0")/..
report=$(realpath -m "${1:-$root/out/demo/report}")
picture=$(realpath -m "${2:-$root/docs/images/report.png}")
[ -f "$report/index.html" ] || { echo "$report: no report; expected that of scripts/demo.sh" >&2; exit 1; }
command -v chromium >/dev/null || { echo "needs the package chromium" >&2; exit 1; }
profile=$(mktemp -d)
trap 'rm -rf "$profile"' EXIT
# Waits for all stages: otherwise the picture can show a page that is drawn in part.
chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size=1280,760 --virtual-time-budget=3000 \
  --run-all-compositor-stages-before-draw \
  --user-data-dir="$profile" --screenshot="$picture" "file://$report/index.html" 2>"$profile/log" ||
  { cat "$profile/log" >&2; exit 1; }
