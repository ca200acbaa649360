#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs the programs as on other machines and compares bits: same_bits_test.sh dumps|testbeds SOURCES BIN LIBM VECTORS,
# where LIBM and VECTORS are the libraries of other_libm.c and narrow_vectors.cpp.
set -euo pipefail
case=$1 sources=$2 libm=$4 vectors=$5
export PATH="$3:$PATH"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
failed=0

# The machines: "NAME|environment of the programs". The C library selects functions by the processor: without FMA or
# without AVX2, its sin, exp and others have other last bits.
machines=("other last bits of libm|LD_PRELOAD=$libm" "vectors of the oldest processor|LD_PRELOAD=$vectors")
masks=""
if [ "$(uname -m)" = x86_64 ]; then
  for mask in -FMA,-FMA4 -AVX2 -AVX512F,-AVX512VL,-AVX512BW,-AVX512DQ,-AVX512CD; do
    machines+=("$mask|GLIBC_TUNABLES=glibc.cpu.hwcaps=$mask")
    masks+=,$mask
  done
fi
all_at_once=(LD_PRELOAD="$libm $vectors" GLIBC_TUNABLES="${masks:+glibc.cpu.hwcaps=${masks#,}}")

# The libraries are loaded and have an effect: the dynamic linker only warns if it cannot load one.
sines() { env "$@" awk 'BEGIN { for (i = 1; i < 1000; ++i) printf "%.17g\n", sin(i / 7) }' 2>&1; }
sines >sines
if sines LD_PRELOAD="$libm" | cmp -s - sines; then echo "FAILED: $libm changes nothing"; exit 1; fi
sines LD_PRELOAD="$vectors" | cmp - sines || exit 1

# The dump of Slalom's own methods, those of configs/baselines.ini that are plug-ins, among walkers and with noise.
methods=$(awk '/^\[method\./ { name = substr($1, 9, length($1) - 9) }
  /^plugin / { printf "%s%s", separator, name; separator = "," }' "$sources/configs/baselines.ini")
noise=(sensor.noise_sigma=0.02 sensor.dropout_ratio=0.01 odometry.distance_sigma=0.01 odometry.turn_sigma=0.01)
dump() {
  local name=$1 log
  shift
  if ! log=$(env "$@" slalom-evaluate "$sources/configs/baselines.ini" -o "$name" -j 1 --quiet \
    --set campaign.methods="$methods" --set scenarios.count=4 --set scenarios.walkers=2 "${noise[@]/#/--set=}" \
    --set limits.run_wall_time=600 2>&1); then
    echo "$log"
    return 1
  fi
  env "$@" slalom-analyze dump "$name/runs.results" >"$name.dump"
}

# The values of line $first of a dump, one a line.
values() { sed -n "${first}p" "$1" | sed 's/},/},\n/g'; }

# Compares the dump on a machine with the one here: check_dump NAME ENVIRONMENT...
check_dump() {
  local name=$1 first
  shift
  dump there "$@"
  if cmp -s there.dump here.dump; then
    echo "ok: $(wc -l <here.dump) runs with $name"
  else
    failed=1
    echo "FAILED: other bits with $name, in the first run that differs here (<) and there (>):"
    first=$({ cmp here.dump there.dump || true; } | sed 's/.*line //')
    sed -nE "${first}s/.*(\"method\":\"[^\"]*\").*(\"name\":\"[^\"]*\").*/\1 \2/p" here.dump
    diff <(values here.dump) <(values there.dump) | sed -n '/^[<>]/p;12q' || true
  fi
  rm -r there there.dump
}

# One machine tells the cause of a difference that all at once show.
check_dumps() {
  dump here
  [ "$(wc -l <here.dump)" -ge 56 ] && ! grep -q '"outcome":"method_' here.dump ||
    { echo "FAILED: runs of the campaign"; exit 1; }
  check_dump "all of these at once" "${all_at_once[@]}"
  [ $failed -eq 0 ] || for machine in "${machines[@]}"; do check_dump "${machine%%|*}" "${machine#*|}"; done
}

# Compares the hash of a test bed on a machine with that of docs/reference/testbeds.md: check_test_bed SET NAME ENVIRONMENT...
check_test_bed() {
  local set=$1 name=$2 documented seen
  shift 2
  documented=$(sed -n "s/^| \`$set\` .*\`\([0-9a-f]\{32\}\)\` |.*/\1/p" "$sources/docs/reference/testbeds.md")
  env "$@" slalom-scenarios generate -c "$sources/configs/testbeds/$set.ini" -o "$set.scenarios" -j 2 --quiet >/dev/null
  seen=$(env "$@" slalom-scenarios list "$set.scenarios" --hash)
  rm "$set.scenarios"
  if [ "$seen" = "$documented" ]; then
    echo "ok: $set with $name"
  else
    failed=1
    echo "FAILED: $set with $name has the hash $seen, documented is $documented"
  fi
}

check_test_beds() {
  local set
  for set in "$sources"/configs/testbeds/*.ini; do
    check_test_bed "$(basename "$set" .ini)" "all of these at once" "${all_at_once[@]}"
  done
}

case $case in
  dumps) check_dumps ;;
  testbeds) check_test_beds ;;
  *) exit 2 ;;
esac
exit $failed
