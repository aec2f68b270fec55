# shellcheck shell=sh
# Slurm on this machine alone, started and stopped by root; sourced by parts.sh.

# FOLDER: for its configuration, logs and state.
start_cluster() {
    cluster=$1/cluster
    mkdir -p "$cluster/state" "$cluster/spool"
    install -d -o munge -g munge /run/munge
    setpriv --reuid=munge --regid=munge --clear-groups munged --force 2>/dev/null || true
    cat >"$cluster/slurm.conf" <<CONF
ClusterName=parts
SlurmctldHost=$(hostname)(127.0.0.1)
SlurmUser=root
SlurmctldPort=16817
SlurmdPort=16818
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/spool
SlurmctldPidFile=$cluster/slurmctld.pid
SlurmdPidFile=$cluster/slurmd.pid
SlurmctldLogFile=$cluster/slurmctld.log
SlurmdLogFile=$cluster/slurmd.log
ReturnToService=2
NodeName=$(hostname) NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=1000
PartitionName=all Nodes=ALL Default=YES State=UP
CONF
    SLURM_CONF=$cluster/slurm.conf
    export SLURM_CONF
    slurmctld -f "$SLURM_CONF"
    slurmd -f "$SLURM_CONF"
    for _ in $(seq 30); do
        if sinfo -h -o %T 2>/dev/null | grep -q idle; then return; fi
        sleep 1
    done
    cat "$cluster"/*.log
    echo "Slurm does not start" && return 1
}

# Slurm's own daemons, by the numbers they left.
stop_cluster() {
    for daemon in slurmd slurmctld; do kill "$(cat "$cluster/$daemon.pid")" || true; done
    sleep 1
}
