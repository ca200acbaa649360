#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Campaigns that are ended in the middle and continued: see scripts/faults.sh.
set -u
seconds=$1
RANDOM=7
source "$(dirname "$0")/common/campaign.sh"
plugin=${SLALOM_FAULTY:?the library of tests/faults/plugins}

# Many campaigns at the same time, whose runs mostly wait, so that few processors see many ends in little time.
repetitions=$((seconds < 30 ? 10 : 20))
lanes=$((seconds < 30 ? 1 : 4)) # for each way
ends=$((seconds < 30 ? 3 : 20)) # of each campaign
limit=$((seconds < 30 ? 8000 : 5000)) # ms without a result on disk; a test may share its processors
cat >campaign.ini <<INI
[campaign]
methods = nd, slow
seed = 5
repetitions = $repetitions
$(small_scenarios 4)
[metrics]
descriptors = density
$(method_section nd)
[method.slow]
adapter = library
plugin = $plugin
fault = slow
INI
total=$((8 * repetitions))
simulate="slalom-simulate run campaign.ini -j 2"

# Also rolls back what a killed program had not completed, as the next one would.
runs_in() { sqlite3 "$1" 'SELECT count(*) FROM runs' 2>/dev/null || echo 0; }
milliseconds() { echo $(($(date +%s%N) / 1000000)); }

$simulate -o whole.results --quiet || exit 1
whole=$(digest whole.results)

# Starts the campaign in a process group of its own; sets pid.
start() {
  setsid $simulate -o "$1" --quiet 2>>"$1.log" &
  pid=$!
}

# Mostly up to 4 s, since results are written every 2 s, and sometimes up to 10 s.
pause() { sleep "$(printf '%d.%03d' $((RANDOM % (RANDOM % 4 ? 4 : 10))) $((RANDOM % 1000)))"; }

# Ends a campaign at a random moment in the given way. Counts runs that were stored before and are not there afterwards,
# and ends later than the limit after results were last written.
end_at_random() {
  local way=$1 file=$2 began now after
  began=$(milliseconds)
  start "$file"
  pause
  now=$(milliseconds)
  case $way in
    parent) kill -9 $pid ;;
    group) kill -9 -- -$pid ;;
    worker)
      until pgrep -P $pid || ! kill -0 $pid; do sleep 0.02; done >/dev/null
      pkill -9 -P $pid
      ;;
    term) kill -TERM $pid ;;
    usr1) kill -USR1 -- -$pid ;;
  esac 2>/dev/null && kills=$((kills + 1))
  wait $pid 2>/dev/null
  after=$(runs_in "$file")
  [ "$after" -gt "$before" ] && [ "$after" -lt $total ] && partial=$((partial + 1))
  [ "$after" -ge "$before" ] || lost=$((lost + before - after))
  if [ "$after" -lt $total ] && [ $way != worker ]; then
    local written=$(($(stat -c %Y "$file" 2>/dev/null || echo 0) * 1000 + 999))
    [ $written -gt $began ] || written=$began
    [ $((now - written)) -le $limit ] || late=$((late + 1))
  fi
  before=$after
}

# Ends campaigns until they are complete, up to $ends times each, and starts over until the time is over.
lane() {
  local way=$1 file=$2.results
  local kills=0 partial=0 lost=0 late=0 missing=0 wrong=0 before
  while :; do
    rm -f "$file"*
    before=0
    for _ in $(seq $ends); do
      end_at_random "$way" "$file"
      [ "$before" -lt $total ] || break
    done
    if ! $simulate -o "$file" --quiet 2>"$file.log"; then
      wrong=$((wrong + 1))
      cat "$file.log" >&2
    fi
    [ "$(runs_in "$file")" -eq $total ] || missing=$((missing + 1))
    [ "$(digest "$file")" = "$whole" ] || wrong=$((wrong + 1))
    [ $SECONDS -lt "$seconds" ] || break
  done
  echo "$kills $partial $lost $late $missing $wrong" >"$2.counts"
}

SECONDS=0
for way in parent group worker term usr1; do
  for i in $(seq $lanes); do
    (
      RANDOM=$((i + ${#way} * 100))
      lane $way $way$i
    ) &
  done
done
wait
for way in parent group worker term usr1; do
  cat $way?.counts | awk -v way="$way" '{for (i = 1; i <= 6; ++i) n[i] += $i} END {
    printf "ended %d times by %s, %d with new runs\t0 lost, 0 late, 0 incomplete, 0 other\t", n[1], way, n[2]
    printf "%d lost, %d late, %d incomplete, %d other\n", n[3], n[4], n[5], n[6]}'
done
report "ends in total: $(cat ./*.counts | awk '{n += $1} END {print n}')" "" ""

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
until [ -e run.results.lock ] || ! kill -0 $pid; do sleep 0.02; done
kill -STOP $pid
$simulate -o run.results --quiet 2>second.log
second=$?
kill -CONT $pid
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
