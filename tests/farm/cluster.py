"""A Slurm cluster of one machine, as the user that runs the tests: munged, slurmctld and slurmd with keys, ports, state and logs of
their own. It ends with the test, whatever happens."""
import ctypes
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import tempfile
import time

PATH = os.environ.get("PATH", "") + ":/usr/sbin:/sbin"
NEEDED = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "sinfo")
START_S = 30


def missing():
    """Which of Slurm's programs are not installed."""
    return [name for name in NEEDED if not shutil.which(name, path=PATH)]


def die_with_parent():
    ctypes.CDLL(None).prctl(1, signal.SIGTERM)  # PR_SET_PDEATHSIG: also when the test is killed


def free_ports(count):
    taken = [socket.socket() for _ in range(count)]
    for s in taken:
        s.bind(("127.0.0.1", 0))
    ports = [s.getsockname()[1] for s in taken]
    for s in taken:
        s.close()
    return ports


class Cluster:
    def __init__(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="tyndall_slurm_", dir="/tmp"))  # a socket's path is short
        self.daemons = []
        self.configuration = self.folder / "slurm.conf"

    def __enter__(self):
        try:
            self.start()
        except BaseException:
            self.stop()
            raise
        return self

    def __exit__(self, *_):
        self.stop()

    def start(self):
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        self.folder.chmod(0o755)
        self.configuration.write_text(self.slurm_conf(*free_ports(2)))
        here = str(self.folder)
        self.daemon("munged", "--foreground", "--force", f"--key-file={key}", f"--socket={here}/munge.socket",
                    f"--pid-file={here}/munged.pid", f"--log-file={here}/munged.log", f"--seed-file={here}/munged.seed")
        self.wait("munged", lambda: (self.folder / "munge.socket").exists())
        self.daemon("slurmctld", "-D")
        self.daemon("slurmd", "-D", "-N", "localhost")
        self.wait("the node", lambda: "idle" in self.ask("sinfo", "--noheader", "--format=%t"))

    def slurm_conf(self, controller_port, node_port):
        import getpass
        here, user = self.folder, getpass.getuser()
        return f"""
ClusterName=tyndall_test
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort={controller_port}
SlurmdPort={node_port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={here}/munge.socket
StateSaveLocation={here}/state
SlurmdSpoolDir={here}/spool
SlurmctldPidFile={here}/slurmctld.pid
SlurmdPidFile={here}/slurmd.pid
SlurmctldLogFile={here}/slurmctld.log
SlurmdLogFile={here}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1,sched_min_interval=0,batch_sched_delay=0,bf_interval=1
SlurmdParameters=config_overrides
ReturnToService=2
KillWait=2
InactiveLimit=0
NodeName=localhost NodeAddr=127.0.0.1 CPUs=4 RealMemory=1000 State=UNKNOWN
PartitionName=main Nodes=localhost Default=YES MaxTime=INFINITE State=UP
PartitionName=night Nodes=localhost Default=NO MaxTime=INFINITE State=UP
"""

    @property
    def environment(self):
        clean = {k: v for k, v in os.environ.items() if not k.startswith(("SLURM_", "SBATCH_", "SQUEUE_", "SINFO_"))}
        return {**clean, "PATH": PATH, "SLURM_CONF": str(self.configuration)}

    def daemon(self, name, *arguments):
        with open(self.folder / f"{name}.out", "wb") as out:
            self.daemons.append(subprocess.Popen([shutil.which(name, path=PATH), *arguments], stdin=subprocess.DEVNULL, stdout=out, stderr=out,
                                                 env=self.environment, preexec_fn=die_with_parent))

    def ask(self, *command):
        """What one of Slurm's programs writes."""
        return subprocess.run(command, capture_output=True, text=True, env=self.environment, timeout=60).stdout

    def wait(self, what, ready):
        end = time.monotonic() + START_S
        while not ready():
            fallen = [d.args[0] for d in self.daemons if d.poll() is not None]
            if fallen or time.monotonic() > end:
                logs = "".join(f"--- {f.name}\n{f.read_text(errors='replace')[-2000:]}" for f in sorted(self.folder.glob("*.log")) + sorted(self.folder.glob("*.out")))
                raise RuntimeError(f"{what} did not start ({', '.join(fallen) or 'time is up'})\n{logs}")
            time.sleep(0.1)

    def stop(self):
        if len(self.daemons) == 3 and self.ask("squeue", "--noheader"):
            self.ask("scancel", "--full", "--signal=KILL", f"--user={os.getuid()}")
            self.ask("scancel", f"--user={os.getuid()}")
            for _ in range(50):
                if not self.ask("squeue", "--noheader"):
                    break
                time.sleep(0.1)
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in self.daemons:
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        shutil.rmtree(self.folder, ignore_errors=True)
