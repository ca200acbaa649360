#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs a campaign of 16 shards on a Slurm cluster of one node, which is started on the loopback device and ended again:
# slurm_cluster_test.sh BIN_FOLDER. A task is requeued, one is killed, one gets the signal of the time limit, and the node
# goes down. What is missing is submitted again. The merged results are those of one run.
set -euo pipefail
# shellcheck source=../faults/common/campaign.sh
source "$(dirname "$0")/../faults/common/campaign.sh"
PATH=$1:$PATH:/usr/sbin

skip() {
  echo "Skipped: $1"
  exit 77
}
for program in munged slurmctld slurmd sbatch; do
  command -v "$program" >/dev/null || skip "needs the package slurm-wlm, which contains or depends on $program"
done

folder=$(mktemp -d)
chmod 700 "$folder"
pids=()
finish() {
  scancel --user="$(id -un)" 2>/dev/null || true
  kill "${pids[@]}" 2>/dev/null || true
  sleep 1
  kill -9 "${pids[@]}" 2>/dev/null || true # slurmd may wait for its tasks
  wait 2>/dev/null || true
  rm -rf "$folder"
}
trap finish EXIT
fail() {
  echo "$1"
  tail -n 30 "$folder"/*.log "$folder"/out/log-* 2>/dev/null || true
  exit 1
}

# The cluster.
node=$(hostname -s)
user=$(id -un)
head -c 1024 /dev/urandom >"$folder/key"
chmod 400 "$folder/key"
munged --foreground --force --key-file="$folder/key" --socket="$folder/munge" --pid-file="$folder/munged.pid" \
  --log-file="$folder/munged.log" --seed-file="$folder/seed" 2>"$folder/munged.err" &
pids+=($!)
port=$((20000 + RANDOM % 20000))
cat >"$folder/slurm.conf" <<END
ClusterName=test
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
CryptoType=crypto/munge
AuthInfo=socket=$folder/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1,batch_sched_delay=0,sched_min_interval=0
JobAcctGatherType=jobacct_gather/none
ReturnToService=2
SlurmdTimeout=10
KillWait=5
JobRequeue=1
MaxArraySize=10
MailProg=/bin/true
NodeName=$node NodeAddr=127.0.0.1 CPUs=2
PartitionName=all Nodes=$node Default=YES State=UP
END
export SLURM_CONF=$folder/slurm.conf
mkdir "$folder/state" "$folder/spool"
slurmctld -D >/dev/null 2>&1 &
pids+=($!)
slurmd -D -N "$node" >/dev/null 2>&1 &
pids+=($!)
for _ in $(seq 300); do
  [ "$(sinfo -h -o %T 2>/dev/null)" = idle ] && break
  sleep 0.1
done
[ "$(sinfo -h -o %T 2>/dev/null)" = idle ] ||
  skip "the daemons of Slurm cannot run here: $(grep -h -m 1 -E 'fatal|error' "$folder"/slurm*.log "$folder/munged.err" || true)"

# The campaign, and its results from one run.
cd "$folder"
cat >small.ini <<END
[campaign]
name        = cluster
methods     = nd, gap
repetitions = 3
[sensor]
noise_sigma = 0.01
$(small_scenarios 20)
[metrics]
descriptors = density
$(method_section nd)
$(method_section gap)
END
slalom-scenarios generate -c small.ini -o all.scenarios >/dev/null
slalom-simulate run -c small.ini --scenarios all.scenarios -o whole.results --quiet -j 2
submit() { slalom-simulate slurm -c small.ini --scenarios all.scenarios -o out --shards 16 --submit; }

running_task() { squeue -h -r -t R -n slalom -o "%i" | head -n 1; }
await_task() {
  for _ in $(seq 300); do
    [ -n "$(running_task)" ] || [ -z "$(squeue -h)" ] && break
    sleep 0.05
  done
}
# Requeued tasks would wait for minutes.
await_end() {
  for _ in $(seq 600); do
    [ -n "$(squeue -h)" ] || return 0
    for task in $(squeue -h -r -t PD -o "%i %r" | awk '$2 == "BeginTime" {print $1}'); do
      scontrol update jobid="$task" StartTime=now 2>/dev/null || true
    done
    sleep 0.1
  done
  squeue
  fail "the jobs do not end"
}

submit | grep -q "job .*: merge" || fail "nothing was submitted"
await_task
task=$(running_task)
[ -z "$task" ] || scontrol requeue "$task" || true
await_task
task=$(running_task)
[ -z "$task" ] || scancel --batch --signal=TERM "$task" || true # as the time limit does, whose unit is a minute
await_task
pid=$(pgrep -f "slalom-simulate run .*$folder/small.ini" | head -n 1 || true)
[ -z "$pid" ] || kill -9 "$pid" || true
await_task
scontrol update nodename="$node" state=down reason=test
scontrol update nodename="$node" state=resume 2>/dev/null || true # if it has not come back by itself
await_end

# Missing shards are submitted again.
for _ in 1 2 3; do
  [ -n "$(slalom-simulate status out --missing)" ] || [ ! -f out/all.results ] || break
  submit >/dev/null
  await_end
done
[ -z "$(slalom-simulate status out --missing)" ] || fail "$(slalom-simulate status out)"
slalom-analyze dump whole.results >whole.txt
slalom-analyze dump out/all.results >merged.txt || fail "no merged file"
cmp whole.txt merged.txt || fail "the merged results differ"
echo "$(wc -l <merged.txt) runs; $(cat out/log-[0-9]* | grep -c . || true) lines of logs"
