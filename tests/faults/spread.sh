#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Campaigns in shards whose files are missing, damaged, doubled or of another campaign: see scripts/faults.sh.
set -u
seconds=$1
source "$(dirname "$0")/common/campaign.sh"
plugin=${SLALOM_FAULTY:?the library of tests/faults/plugins}

cat >campaign.ini <<INI
[campaign]
methods = nd, gap
seed = 5
[metrics]
descriptors = density
$(method_section nd)
$(method_section gap)
INI
small_scenarios 4 >generate.ini

run() { slalom-simulate run campaign.ini --scenarios "${list:-all.scenarios}" --quiet "$@" 2>run.log; }
merge() { slalom-simulate merge -o merged.results --quiet "$@" 2>merge.log; }
# "status N" of the last command, and the word if its log has it.
seen() { echo "status $1$(grep -q -- "$3" "$2" && echo ", $3")"; }
# A folder with fresh copies of the shards.
fresh() { rm -rf "$1" && cp -r shards "$1"; }

slalom-scenarios generate -c generate.ini -o all.scenarios --quiet || exit 1
run -o whole.results || exit 1
whole=$(digest whole.results)
mkdir shards
for i in 1 2 3 4 5 6; do run --shard $i/6 -o shards/$i.results || exit 1; done  # more than scenarios
merge shards
report "more shards than scenarios" "status 0, same values" \
  "status $?, $([ "$(digest merged.results)" = "$whole" ] && echo same values)"

# Who writes a shard.
slalom-simulate run campaign.ini --scenarios all.scenarios --quiet --shard 1/6 -o locked.results & first=$!
until [ -s locked.results.lock ] || ! kill -0 $first 2>/dev/null; do sleep 0.01; done
kill -STOP $first
cp locked.results.lock lock
run --shard 1/6 -o locked.results; second=$?
kill -CONT $first
wait $first
report "two jobs on one shard" "first 0, second 1, complete" \
  "first $?, second $second, $(cmp -s <(slalom-analyze dump locked.results) <(slalom-analyze dump shards/1.results) && echo complete)"
sed "s/$(hostname)/node-that-is-gone/" lock >locked.results.lock
run --shard 1/6 -o locked.results
report "the lock of another host" "status 1, node-that-is-gone" "$(seen $? run.log node-that-is-gone)"
run --shard 1/6 -o locked.results --take-over
report "taken over" "status 0, no lock" "status $?, $([ -e locked.results.lock ] || echo no lock)"

# Files that are not the shards they should be.
while IFS='|' read -r name command expected word; do
  fresh folder
  eval "$command"
  merge folder
  report "merge with $name" "status $expected, $word" "$(seen $? merge.log "$word")"
done <<'CASES'
a missing shard|rm folder/1.results folder/2.results|1|missing: shards 1-2
a truncated shard|truncate -s 5000 folder/2.results|3|2.results
an empty shard|: >folder/2.results|3|2.results
a foreign file|head -c 9999 /dev/zero >folder/2.results|3|2.results
a list for a shard|cp all.scenarios folder/2.results|3|2.results
an older format|sqlite3 folder/2.results 'PRAGMA user_version = 2'|3|unsupported version 2
another plug-in build|cp "$plugin" other.so; run --set method.gap.plugin=./other.so --shard 2/6 -o folder/2.results --overwrite|3|plugin
another list|slalom-scenarios generate -c generate.ini --seed 9 -o 9.scenarios --quiet; list=9.scenarios run --shard 2/6 -o folder/2.results --overwrite|3|scenarios
another setting|run --set robot.max_v=0.6 --shard 2/6 -o folder/2.results --overwrite|3|robot.max_v
CASES
fresh folder
cp shards/1.results folder/again.results
merge folder
report "merge with a shard twice, equal" "status 0, same values" \
  "status $?, $([ "$(digest merged.results)" = "$whole" ] && echo same values)"
random="--set method.gap.plugin=$plugin --set method.gap.fault=random"
rm -rf folder && mkdir folder
for i in 1 2; do run $random --shard 1/6 -o folder/$i.results; done
merge folder --allow-incomplete
report "merge with a shard twice, unequal" "status 3, differ" "$(seen $? merge.log differ)"

# Campaigns that cannot be divided.
slalom-evaluate campaign.ini -o out --until 'interval(success) < 0.1' --shard 1/4 2>run.log
report "a stopping rule with shards" "status 2, --shard" "$(seen $? run.log --shard)"

# Names and numbers of files.
mkdir -p 'a folder é $x'
cp shards/*.results 'a folder é $x'
merge 'a folder é $x'
report "paths with spaces and other letters" "status 0, same values" \
  "status $?, $([ "$(digest merged.results)" = "$whole" ] && echo same values)"
files=$((seconds < 30 ? 500 : 10000))
fresh folder
for i in $(seq $files); do ln shards/1.results folder/copy$i.results; done
merge folder
report "$files more files in the folder" "status 0, same values" \
  "status $?, $([ "$(digest merged.results)" = "$whole" ] && echo same values)"
report "files left over" "" "$(find . -name '*lock' ! -name lock -o -name '*journal' -o -name '*.tmp*' | paste -sd' ')"
