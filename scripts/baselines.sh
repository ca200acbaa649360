#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes the tables of docs/baselines-*.md again, as Markdown: scripts/baselines.sh FOLDER [PAGE...]
# PAGE is barn, slalom-small, slalom-standard, slalom-rectangle, slalom-dynamic-small or slalom-dynamic-standard; all
# by default. The tables are written to FOLDER/PAGE.md. Environment variables: BARN, the folder of that data set;
# METHODS, a list with commas (those of configs/baselines.ini by default); JOBS, the number of workers (2).
# Each method has its own result file in FOLDER/PAGE, which is used again if it is complete: a new method costs its own
# runs only. Delete the files of methods that have changed. Beside each is its bundle, an entry of a registry.
set -euo pipefail
[ $# -ge 1 ] || { sed -n '3,8s/^# //p' "$0" >&2; exit 2; }
cd "$(dirname "$0")/.."
folder=$1 pages=("${@:2}")
[ ${#pages[@]} -gt 0 ] ||
  pages=(barn slalom-small slalom-standard slalom-rectangle slalom-dynamic-small slalom-dynamic-standard)
bin=${SLALOM_BIN:-build/release/bin}
all_methods=$(sed -n 's/^methods *= *//p' configs/baselines.ini)
tracked=rollout_tracks # only for scenarios with movers

# The scenario list $2 of page $1; one that is there must be that of the documents.
make_list() {
  if [ "$1" = barn ]; then
    [ -e "$2" ] || "$bin/slalom-scenarios" import "${BARN:?the folder of the data set}" -o "$2"
    return
  fi
  [ -e "$2" ] || "$bin/slalom-scenarios" generate -c "configs/testbeds/$1.ini" -o "$2" -j "${JOBS:-2}" --quiet
  local expected hash
  expected=$(sed -n "s/^| \`$1\` .*\`\([0-9a-f]\{32\}\)\`.*/\1/p" docs/reference/testbeds.md)
  hash=$("$bin/slalom-scenarios" list "$2" --hash)
  [ "$hash" = "$expected" ] || { echo "$2: hash $hash; expected $expected of docs/reference/testbeds.md" >&2; exit 1; }
}

# The rows of page $1 as CSV, by the bins $2, with the columns $3.
table() {
  local method
  for method in $methods; do
    "$bin/slalom-analyze" table "$folder/$1/$method.results" --rows "$2" --columns "$3" --csv | tail -n +2
  done
}

# A Markdown table of CSV rows on standard input: a row per method of $order, a column per value of field $1 (2: bins,
# 5: metrics), of the metric $2 and descriptor $3 if given.
markdown() {
  awk -F, -v by="$1" -v metric="${2:-}" -v descriptor="${3:-}" -v order="$order" '
    function digits(id) { return id ~ /^(success|mover_|arrival)|safety/ || metric != "" ? 2 : id ~ /time$/ ? 1 : 3 }
    function number(x, id) { return sprintf("%." digits(id) "f", x) }
    NF < 10 || (metric != "" && $5 != metric) || (descriptor != "" && $2 != descriptor) { next }
    {
      column = by == 5 ? $5 : sprintf("%.3g to %.3g", $3, $4)
      if (!(column in known)) { known[column]; columns[++count] = column; runs[count] = $7 }
      cell[$1, column] = $10 == "" ? "–" : number($10, $5) ($12 == "" || $5 ~ /^cycle_time/ ? "" : " [" number($12, $5) ", " number($13, $5) "]")
    }
    END {
      if (by != 5) {
        for (i = 1; i <= count; ++i) total = total (i > 1 ? ", " : "") runs[i]
        print "By " descriptor " (" total " scenarios):\n"
      }
      head = "| method |"; line = "|---|"
      for (i = 1; i <= count; ++i) { head = head " " columns[i] " |"; line = line "---|" }
      sub("cycle_time_p50", "median cycle, ms", head)
      print head "\n" line
      n = split(order, methods, " ")
      for (k = 1; k <= n; ++k) {
        row = "| " methods[k] " |"
        for (i = 1; i <= count; ++i) row = row " " cell[methods[k], columns[i]] " |"
        print row
      }
      print ""
    }'
}

for page in "${pages[@]}"; do
  mkdir -p "$folder/$page"
  list=$folder/$page.scenarios
  make_list "$page" "$list"
  methods=${METHODS:-$all_methods} options=()
  bins="density:0,0.1,0.2,0.4,0.8; clearness:0,0.1,0.2,0.3,0.5; confinement:0.4,0.6,0.75,0.9,1"
  columns=success,optimality,safety,cycle_time_p50 metrics="success optimality safety"
  case $page in
    barn)
      options=(--set robot.radius=0.21 --set robot.max_v=0.5 --set robot.max_w=1.57)
      options+=(--set simulation.goal_tolerance=1 --set method.dwa_ros.inflation_radius=0.3)
      bins="density:4; confinement:4" metrics=success
      ;;
    slalom-rectangle)
      options=(--set "robot.footprint=$(sed -n 's/^footprint = *\([^#]*[^# ]\) *#.*/\1/p' "configs/testbeds/$page.ini")")
      bins="bottleneck_width:0.42,0.51,0.6,0.69,0.78,0.87; confinement:0.7,0.8,0.9,1; detour_ratio:1,1.3,3"
      ;;
    slalom-dynamic-*)
      [ -n "${METHODS:-}" ] || methods="$tracked, $methods"
      bins=dynamic_density:0,0.01,0.02,0.2 metrics=success
      columns=success,mover_collision,mover_contact_speed,personal_space_time,arrival_ratio
      ;;
  esac
  methods=${methods//,/ }
  for method in $methods; do
    "$bin/slalom-simulate" run -c configs/baselines.ini --scenarios "$list" -o "$folder/$page/$method.results" \
      -j "${JOBS:-2}" --quiet --set limits.run_wall_time=3600 --set "campaign.methods=$method" "${options[@]}"
    "$bin/slalom-simulate" bundle "$folder/$page/$method.results" -o "$folder/$page/$method.slalom" --with-sources
  done
  table "$page" all "$columns" >"$folder/$page/all.csv"
  table "$page" "$bins" "${metrics// /,}" >"$folder/$page/bins.csv"
  order=$(awk -F, '$5 == "success" {print $10, $1}' "$folder/$page/all.csv" | sort -sgr -k1,1 | cut -d' ' -f2 | xargs)
  {
    markdown 5 <"$folder/$page/all.csv"
    for metric in $metrics; do
      printf '## %s\n\n' "${metric^}"
      for descriptor in $(awk -F, 'NF >= 10 && !seen[$2]++ {print $2}' "$folder/$page/bins.csv"); do
        markdown 3 "$metric" "$descriptor" <"$folder/$page/bins.csv"
      done
    done
  } | python3 scripts/baseline_tables.py >"$folder/$page.md"
  echo "$folder/$page.md"
done
