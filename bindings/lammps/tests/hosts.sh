#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Runs LAMMPS with the plugin on two hosts, network namespaces of this machine that reach each other over a virtual cable, with MPI over
# sockets: bindings/lammps/tests/hosts.sh FOLDER SCRIPT. Needs root and iproute2.
set -euo pipefail
folder=$1 script=$2
environment=$(cd "$(dirname "$0")/../../.." && pwd)/target/lammps/environment
remove() { ip netns delete veridem0 2>/dev/null || true; ip netns delete veridem1 2>/dev/null || true; }
trap remove EXIT
remove
for host in 0 1; do
    ip netns add "veridem$host"
    ip netns exec "veridem$host" ip link set lo up
done
ip link add cable netns veridem0 type veth peer name cable netns veridem1
for host in 0 1; do
    ip netns exec "veridem$host" ip address add "10.77.0.1$host/24" dev cable
    ip netns exec "veridem$host" ip link set cable up
done
# The cable is there when one host reaches the other.
for _ in $(seq 50); do
    ip -n veridem1 -brief link show cable | grep -q UP && break
    sleep 0.1
done
# mpiexec starts a process on a "remote" host with this, in place of ssh: launcher HOST COMMAND...
launcher=$(mktemp)
cat >"$launcher" <<'LAUNCH'
#!/usr/bin/env bash
while [[ $1 == -* ]]; do shift; done
host=$1
shift
exec ip netns exec "veridem${host: -1}" unshare --uts bash -c "hostname host-${host: -1}; cd '$VERIDEM_FOLDER'; eval \"$*\""
LAUNCH
chmod +x "$launcher"
export VERIDEM_FOLDER=$(realpath "$folder")
export UCX_TLS=tcp,self UCX_NET_DEVICES=cable MPIR_CVAR_NOLOCAL=1
cd "$folder"
ip netns exec veridem0 "$environment/bin/mpiexec" -launcher ssh -launcher-exec "$launcher" -hosts 10.77.0.10,10.77.0.11 -ppn 1 -n 2 \
    "$environment/bin/lmp" -in "$script" -log none
rm -f "$launcher"
echo "bytes sent to the other host: $(ip netns exec veridem0 cat /sys/class/net/cable/statistics/tx_bytes)"
