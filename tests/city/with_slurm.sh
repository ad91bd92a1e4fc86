#!/usr/bin/env bash
# with_slurm.sh COMMAND...: runs a command beside a Slurm cluster of this machine alone, whose daemons, key and files
# are in a temporary folder and end with the command. Takes Debian's slurm-wlm and munge.
#
#     tests/city/with_slurm.sh ctest --test-dir build/release -R city_slurm -V
set -euo pipefail
for program in munged slurmctld slurmd sinfo; do
    command -v "$program" >/dev/null || {
        echo "with_slurm.sh: '$program' is missing; install slurm-wlm and munge." >&2
        exit 77
    }
done
folder=$(mktemp -d)
chmod 755 "$folder"
daemons=()
end() { 
    for ((i = ${#daemons[@]} - 1; i >= 0; --i)); do
        kill "${daemons[i]}" 2>/dev/null || true
        wait "${daemons[i]}" 2>/dev/null || true
    done
    rm -rf "$folder"
}
trap end EXIT
mkdir "$folder"/{munge,state,spool}
chmod 711 "$folder/munge"
(umask 077 && head -c 1024 /dev/urandom >"$folder/munge/key")
munged --foreground --force --socket="$folder/munge/socket" --key-file="$folder/munge/key" \
    --pid-file="$folder/munge/pid" --seed-file="$folder/munge/seed" \
    >"$folder/munge.log" 2>&1 &
daemons+=($!)

name=$(hostname -s) processors=$(nproc)
memory=$(($(awk '/^MemTotal/ { print $2 }' /proc/meminfo) / 1024))
cat >"$folder/slurm.conf" <<CONF
ClusterName=here
SlurmctldHost=$name(127.0.0.1)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
SlurmctldPort=26817
SlurmdPort=26818
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket,cred_expire=5
CryptoType=crypto/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
SchedulerParameters=sched_interval=1,batch_sched_delay=0,bf_interval=1
JobRequeue=1
ReturnToService=2
MailProg=/bin/true
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
NodeName=$name NodeAddr=127.0.0.1 CPUs=$processors RealMemory=$memory
PartitionName=here Nodes=$name Default=YES MaxTime=INFINITE State=UP
CONF
echo "CgroupPlugin=cgroup/v1" >"$folder/cgroup.conf"
export SLURM_CONF=$folder/slurm.conf
slurmctld -D -i >/dev/null 2>&1 &
daemons+=($!)
slurmd -D >/dev/null 2>&1 &
daemons+=($!)
for ((try = 0; try < 60; ++try)); do
    [[ $(sinfo -h -o %t 2>/dev/null) != idle ]] || break
    sleep 0.5
done
if ((try == 60)); then
    echo "with_slurm.sh: the cluster didn't start:" >&2
    tail -n 20 "$folder"/*.log >&2
    exit 1
fi
"$@"
