#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# The cost of isolating methods: processor time of campaigns of one light method under four names,
# each with its own worker process, compared with the same runs as four repetitions under one name
# in a single worker (there is no noise: repetitions are equal). The sum over four light methods of
# the least of some rounds, since other programs on the machine only add to the times.
# usage: benchmarks/isolation_benchmark.sh BIN_FOLDER [ROUNDS [SCENARIOS]]
set -euo pipefail

bin=$(realpath "$1")
rounds=${2:-5}
count=${3:-80}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

declare -A methods=(
  [nd]="adapter=mrpt_holonomic class=CHolonomicND"
  [smooth_nd]="adapter=mrpt_holonomic plugin=libslalom_smooth_nd.so class=slalom::CHolonomicSmoothND"
  [vfh_plus]="adapter=mrpt_holonomic plugin=libslalom_vfh_plus.so class=slalom::CHolonomicVFHPlus"
  [gap]="adapter=library plugin=libslalom_follow_the_gap.so"
)

# write_campaign FILE REPETITIONS METHOD NAME...
write_campaign() {
  local file=$1 repetitions=$2 method=$3 name
  shift 3
  {
    printf '[campaign]\nrepetitions = %s\nmethods = %s\n' "$repetitions" "$(IFS=,; echo "$*")"
    printf '[scenarios]\ngenerator = random\ncount = %s\n' "$count"
    printf '[reference]\nplanner = exact\n'
    for name in "$@"; do
      printf '[method.%s]\n' "$name"
      tr ' ' '\n' <<< "${methods[$method]}"
    done
  } > "$file"
}

# Processor seconds of a campaign, of all its processes.
seconds_of() {
  local TIMEFORMAT='%U %S'
  { time "$bin/slalom-simulate" run "$1" -o runs.results --overwrite --quiet -j 1 2>&3; } 3>&2 2>&1 |
    awk '{ print $1 + $2 }'
}

for method in "${!methods[@]}"; do
  write_campaign "$method.isolated.ini" 1 "$method" a b c d
  write_campaign "$method.shared.ini" 4 "$method" a
done
for ((round = 1; round <= rounds; ++round)); do
  for method in "${!methods[@]}"; do
    echo "$method $(seconds_of "$method.isolated.ini") $(seconds_of "$method.shared.ini")"
  done
done | awk '
  { print; fflush()
    if (!($1 in isolated) || $2 < isolated[$1]) isolated[$1] = $2
    if (!($1 in shared) || $3 < shared[$1]) shared[$1] = $3 }
  END { for (method in isolated) { a += isolated[method]; b += shared[method] }
        printf "isolated %.3f s, one worker %.3f s, ratio %.3f\n", a, b, a / b }'
