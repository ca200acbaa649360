#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Methods that harm their process, and the innocent method beside them: see scripts/faults.sh.
set -u
source "$(dirname "$0")/common/campaign.sh"
plugin=${SLALOM_FAULTY:?the library of tests/faults/plugins}
export TMPDIR=$PWD/temporary
mkdir "$TMPDIR"

cat >base.ini <<INI
[campaign]
seed = 5
repetitions = 2
[scenarios]
generator = random
count = 2
[generator.random]
width = 6
height = 6
min_distance = 4
min_obstacles = 1
max_obstacles = 2
max_size = 0.2
[metrics]
descriptors = density
[limits]
run_wall_time = 300
memory_mb = 500
[method.faulty]
adapter = library
plugin = $plugin
$(method_section gap)
INI

# The lines of one method in a dump.
lines_of() { slalom-analyze dump "$2" | grep "\"method\":\"$1\""; }
outcomes() { lines_of faulty "$1" | grep -o '"outcome":"[a-z_]*"' | sort -u | cut -d'"' -f4 | paste -sd' '; }
# Starts a campaign of the faulty method before the innocent one, on one worker or $jobs.
run() {
  slalom-simulate run base.ini --set campaign.methods=faulty,gap "--set=method.faulty.fault=$1" "${@:2}" -j "${jobs:-1}" \
    --quiet --overwrite -o run.results 2>run.log
}

slalom-simulate run base.ini --set campaign.methods=faulty,gap --quiet -o alone.results || exit 1
lines_of gap alone.results >gap.lines
[ "$(wc -l <gap.lines)" = 4 ] || exit 1
good=$(outcomes alone.results)

# The first column: what the method does; then its outcomes and the exit status. "any": whether a thread crashes before
# its run has ended depends on the speed of the machine.
while IFS='|' read -r fault outcome status; do
  run "$fault"
  seen="status $?, $(outcomes run.results)"
  [ "$outcome" = any ] && seen="status any, any"
  cmp -s gap.lines <(lines_of gap run.results) || seen="$seen, gap differs"
  report "a method's $fault" "status $status, ${outcome:-$good}" "$seen"
done <<'CASES'
rounding||0
signals||0
limits||0
thread||0
late_crash|any|any
daemon||0
clone||0
returns_twice||0
nonblocking||0
shut||0
close|method_crash|1
garbage|method_crash|1
forge|method_crash|1
crash|method_crash|1
exit|method_crash|1
memory|method_crash|1
kill|method_crash|1
kill_group|method_crash|1
kill_keeper|method_crash|1
CASES
# A method kills what all workers depend on and goes on: is the failure attributed to its run?
confused=0
for _ in 1 2 3 4 5 6 7 8 9 10; do
  jobs=2 run kill_keeper_and_go_on
  cmp -s gap.lines <(lines_of gap run.results) || confused=$((confused + 1))
  [ "$(outcomes run.results)" = method_crash ] || confused=$((confused + 1))
done
report "campaigns that confuse a killer of the keeper with others" 0 "$confused"
report "processes left over" 0 "$(pgrep -cf "[r]un base.ini")"

# A method may destroy files as the same user, but not in a sandbox.
echo content >innocent
run destroy "--set=method.faulty.file=$PWD/innocent" --set limits.sandbox=true
status=$?
if grep -q "cannot confine" run.log; then
  report "sandbox refused" "status 2, nothing run" "status $status, $([ -s innocent ] && echo nothing run)"
else
  report "a method that destroys a file, in a sandbox" "status 0, content, $good" \
    "status $status, $(cat innocent), $(outcomes run.results)"
  report "folders of sandboxes left over" "" "$(ls "$TMPDIR")"
fi
