#!/bin/bash
# Campaigns that are ended in the middle and continued: see scripts/faults.sh.
set -u
seconds=$1
RANDOM=7

repetitions=$((15 + seconds))  # the more time, the longer the campaigns
cat >campaign.ini <<INI
[campaign]
methods = nd, gap
seed = 5
repetitions = $repetitions
[scenarios]
generator = random
count = 4
[generator.random]
width = 6
height = 6
min_distance = 3
max_obstacles = 10
max_size = 0.4
[metrics]
descriptors = density
[method.nd]
adapter = mrpt_holonomic
class = CHolonomicND
[method.gap]
adapter = library
plugin = libslalom_follow_the_gap.so
INI
total=$((8 * repetitions))
simulate="slalom-simulate run campaign.ini -j 2"

report() { printf '%s\t%s\t%s\n' "$1" "$2" "$3"; }
runs_in() { slalom-analyze dump "$1" 2>/dev/null | wc -l; }
# The digest of all values, and whether any run is there twice.
digest() { slalom-analyze dump "$1" | md5sum | cut -d' ' -f1; }

began=$(date +%s%N)
$simulate -o whole.results --quiet || exit 1
duration=$(( ($(date +%s%N) - began) / 1000000 ))  # ms
whole=$(digest whole.results)

# Starts the campaign in a process group of its own; sets pid.
start() {
  setsid $simulate -o "$1" --quiet 2>>"$1.log" &
  pid=$!
}

# Any part of the time that a campaign takes.
pause() { sleep "$(printf '%d.%03d' $((at / 1000)) $((at % 1000)))"; }

# Ends a campaign at random moments in the given way until it is complete.
# Sets lost: runs that were stored before it was ended and were not there afterwards.
end_at_random() {
  local way=$1 file=$2 before=0 after
  lost=0
  for _ in 1 2 3; do
    start "$file"
    at=$(( (RANDOM * 32768 + RANDOM) % duration ))
    pause
    case $way in
      parent) kill -9 $pid ;;
      group) kill -9 -- -$pid ;;
      worker) pkill -9 -P $pid ;;
      term) kill -TERM $pid ;;
    esac 2>/dev/null
    wait $pid 2>/dev/null
    after=$(runs_in "$file")
    [ "$after" -gt 0 ] && [ "$after" -lt $total ] && partial=$((partial + 1))
    [ "$after" -ge "$before" ] || lost=$((lost + before - after))
    before=$after
  done
  $simulate -o "$file" --quiet
}

for way in parent group worker term; do
  rounds=0 lost_all=0 wrong=0 missing=0 partial=0
  end=$((SECONDS + (seconds + 3) / 4))
  while :; do
    rm -f run.results*
    end_at_random $way run.results || wrong=$((wrong + 1))
    rounds=$((rounds + 1))
    lost_all=$((lost_all + lost))
    [ "$(runs_in run.results)" -eq $total ] || missing=$((missing + 1))
    # A worker that is killed from outside may be taken for a crash of its method.
    [ $way = worker ] || [ "$(digest run.results)" = "$whole" ] || wrong=$((wrong + 1))
    [ $SECONDS -lt $end ] || break
  done
  report "$way ended 3 times, x$rounds, $partial partial" "0 lost, 0 incomplete, 0 other" \
    "$lost_all lost, $missing incomplete, $wrong other"
done

# A full disk: files may not grow beyond 64 KB.
rm -f run.results*
(trap '' XFSZ; ulimit -f 64; $simulate -o run.results --quiet 2>full.log)
status=$?
report "disk full" "status 1, one line" "status $status, $( [ "$(wc -l <full.log)" = 1 ] && echo one line || cat full.log)"
$simulate -o run.results --quiet
report "continued with space on the disk" "$whole" "$(digest run.results)"

# Two programs on one output.
rm -f run.results*
start run.results
until [ -e run.results.lock ]; do sleep 0.02; done
$simulate -o run.results --quiet 2>second.log
second=$?
wait $pid
report "two programs on one output" "first 0, second 1, same values" \
  "first $?, second $second, $( [ "$(digest run.results)" = "$whole" ] && echo same values || echo other values)"

# All is there: nothing is computed again.
cp run.results before.results
$simulate -o run.results 2>again.log
report "the same command again" "all $total runs are there" "$(grep -o 'all .* are there' again.log)"
report "its file" "unchanged" "$(cmp -s run.results before.results && echo unchanged || echo changed)"

# Other files are refused and kept.
echo "a stranger's text" >stranger.results
$simulate -o stranger.results --quiet 2>/dev/null
report "a stranger's file" "status 3, kept" "status $?, $(grep -q "stranger's text" stranger.results && echo kept || echo lost)"
$simulate -o run.results --set robot.max_v=0.6 --quiet 2>other.log
report "another campaign's results" "status 3, robot.max_v named" \
  "status $?, $(grep -o 'robot.max_v' other.log | head -1) named"
report "files left over" "" "$(ls | grep -E 'lock|journal|tmp')"
