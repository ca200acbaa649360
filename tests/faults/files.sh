#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Hostile, damaged and doubled files, and machines at their limits: see scripts/faults.sh.
set -u
seconds=$1
RANDOM=7

source "$(dirname "$0")/common/campaign.sh"

cat >campaign.ini <<INI
[campaign]
methods = gap
seed = 5
repetitions = 2
$(small_scenarios 4)
[metrics]
descriptors = density
$(method_section gap)
INI

run() { slalom-simulate run campaign.ini --quiet "$@"; }
scenarios() { slalom-scenarios "$@"; }
analyze() { slalom-analyze "$@"; }

scenarios generate -c campaign.ini -o all.scenarios --quiet || exit 1
run --scenarios all.scenarios -o all.results || exit 1
scenarios show all.scenarios random_0000 >/dev/null || exit 1
run -o whole.results || exit 1
whole=$(digest whole.results)
echo "a stranger's text" >stranger.txt
cp stranger.txt stranger.results
cp stranger.txt stranger.scenarios
mkfifo pipe.results pipe.scenarios pipe.ini pipe.yaml
ln -s /dev/zero zero.ini
ln -s /dev/zero zero.results
md5sum campaign.ini stranger.txt stranger.results stranger.scenarios all.scenarios all.results >before.md5

# Outputs that are inputs or other files, and inputs that are no files. All inputs remain as they were.
while IFS='|' read -r status command; do
  eval "timeout 20 $command" >out.log 2>err.log
  seen=$?
  lines=$(wc -l <err.log)
  kept=$(md5sum --quiet -c before.md5 >/dev/null 2>&1 && echo kept)
  report "$command" "status $status, one line, kept" "status $seen, $([ "$lines" = 1 ] && echo one line || echo "$lines lines"), $kept"
done <<'CASES'
2|slalom-simulate run campaign.ini --scenarios all.scenarios --quiet -o all.scenarios
2|slalom-simulate run campaign.ini --scenarios all.scenarios --quiet -o campaign.ini
3|slalom-simulate run campaign.ini --quiet -o stranger.results
2|slalom-scenarios generate -c campaign.ini --quiet -o campaign.ini
3|slalom-scenarios generate -c campaign.ini --quiet -o stranger.scenarios
3|slalom-scenarios generate -c campaign.ini --quiet -o all.results
2|slalom-analyze table all.results -o all.results
2|slalom-analyze export all.results --format csv -o all.results
3|slalom-simulate merge all.results -o stranger.results
3|slalom-analyze dump pipe.results
3|slalom-analyze dump zero.results
3|slalom-analyze dump stranger.results
3|slalom-scenarios list pipe.scenarios
3|slalom-simulate run pipe.ini -o a.results
3|slalom-simulate run zero.ini -o a.results
3|slalom-scenarios import pipe.yaml -o a.scenarios
2|slalom-simulate run campaign.ini --set campaign.name=../a -o a.results
2|slalom-analyze show all.results "$(printf 'no\033[2J\377')"
CASES
report "control characters in messages" 0 "$(grep -c $'\033' err.log)"

# A run that is there costs only itself, wherever a bit flips.
flips=$((20 + 5 * seconds)) refused=0 unnoticed=0 other=0
size=$(stat -c %s all.results)
analyze dump all.results >all.dump
for _ in $(seq $flips); do
  at=$(((RANDOM * 32768 + RANDOM) % size))
  cp all.results flipped.results
  perl -e 'open F, "+<", "flipped.results"; binmode F; seek F, $ARGV[0], 0; read F, $c, 1; seek F, $ARGV[0], 0;
           print F chr(ord($c) ^ (1 << $ARGV[1]))' "$at" $((RANDOM % 8))
  analyze dump flipped.results >flipped.dump 2>flipped.log
  status=$?
  grep -vxFf all.dump flipped.dump >/dev/null && unnoticed=$((unnoticed + 1))
  if [ $status = 3 ] && grep -q flipped.results flipped.log; then
    refused=$((refused + 1))
  elif [ $status -gt 3 ] || { [ $status != 0 ] && [ ! -s flipped.log ]; }; then
    other=$((other + 1))
  fi
done
report "$flips flipped bits ($refused noticed)" "0 changed values, 0 other ends" "$unnoticed changed values, $other other ends"

# A program that reads for long.
run -o read.results & writer=$!
until [ -s read.results ]; do sleep 0.01; done
(echo 'BEGIN; SELECT count(*) FROM runs;'; sleep 2; echo 'COMMIT;') | sqlite3 read.results >/dev/null 2>&1
wait $writer
report "a reader holds a transaction" "status 0, 8 runs" "status $?, $(analyze dump read.results | wc -l) runs"

# Text for spreadsheets.
scenarios show all.scenarios random_0000 --yaml >named.scenario.yaml 2>/dev/null ||
  scenarios export all.scenarios random_0000 --format yaml -o named.scenario.yaml 2>/dev/null
sed -i 's/^name:.*/name: "=HYPERLINK(1)"/' named.scenario.yaml
scenarios import named.scenario.yaml -o named.scenarios --quiet 2>/dev/null
run --scenarios named.scenarios -o named.results
analyze export named.results --format csv -o named 2>/dev/null
report "a formula as a name, in CSV" "quoted" \
  "$(grep -rhoE "(^|,)\"?'=HYPERLINK" named* 2>/dev/null | grep -q . && ! grep -rqE '(^|,)"?=HYPERLINK' named && echo quoted)"

# Machines at their limits: no space at the start, in between, and when a file is to be replaced.
for blocks in 0 8 40; do
  rm -f full.results*
  { (ulimit -f $blocks; run -o full.results); echo "status $?" >&3; } 3>status 2>&1 | cat >full.log
  report "files of at most $blocks KB" "status 1, one line" "$(cat status), $([ "$(wc -l <full.log)" = 1 ] && echo one line)"
  run -o full.results
  report "continued" "$whole" "$(digest full.results)"
done
cp all.results merged.results
(ulimit -f 8; slalom-simulate merge --quiet all.results full.results -o merged.results) 2>full.log
report "no space to merge" "status 1, kept" "status $?, $(cmp -s merged.results all.results && echo kept)"
(ulimit -f 8; analyze report all.results -o report) >/dev/null 2>full.log
report "no space for a report" "status 1, no page" "status $?, $([ -e report/index.html ] || echo no page)"
for megabytes in 200 400; do
  (ulimit -v $((megabytes * 1024)); run -o small.results) >/dev/null 2>full.log
  status=$?
  report "$megabytes MB of memory" "ends by itself" "$([ $status -lt 128 ] && echo ends by itself || echo "status $status")"
done

# Interrupted at any moment, nothing temporary remains.
for command in "scenarios generate -c campaign.ini --quiet -n 400 -o i.scenarios" \
  "run --set campaign.repetitions=100 -o i.results" "slalom-evaluate campaign.ini --quiet -o i"; do
  for signal in INT TERM; do
    slalom=${command/#scenarios/slalom-scenarios}
    slalom=${slalom/#run/slalom-simulate run campaign.ini --quiet}
    setsid timeout --foreground -s $signal 0.$((RANDOM % 5 + 1)) $slalom >/dev/null 2>&1
  done
done
report "temporary files left over" "" \
  "$(find . -name '*tmp*' -o -name '*journal' -o -name '*.lock' -o -name 'slalom_list*' | paste -sd' ')"
report "all inputs at the end" kept "$(md5sum --quiet -c before.md5 >/dev/null 2>&1 && echo kept)"
