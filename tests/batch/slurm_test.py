#!/usr/bin/python3
"""A batch as a Slurm job array (examples/slurm), on a cluster of this machine alone: munged, slurmctld
and slurmd of its own, with ports and folders of their own, ended afterwards."""

import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from batch_case import CLI, SOURCE, BatchTest, main  # noqa: E402
from processes import until  # noqa: E402

SCRIPT = SOURCE / "examples" / "slurm" / "unfold.sbatch"
PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "scontrol", "squeue")
PATH = os.environ.get("PATH", "") + ":/usr/sbin:/sbin"
SECONDS = 240

CONFIGURATION = """\
ClusterName=planish
SlurmctldHost={host}(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
SlurmUser={user}
SlurmdUser={user}
SlurmctldPort={controller}
SlurmdPort={node}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1,bf_interval=1,defer_batch
SlurmdParameters=config_overrides
MpiDefault=none
SwitchType=switch/none
ReturnToService=2
KillWait=2
NodeName={host} NodeAddr=127.0.0.1 CPUs=4 RealMemory=8000 State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class Cluster:
    """The three daemons, below one folder."""

    def __init__(self, folder):
        self.folder = folder
        self.daemons = []
        self.environment = dict(os.environ, PATH=PATH, SLURM_CONF=str(folder / "slurm.conf"), PLANISH=CLI)

    def start(self):
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(256))
        key.chmod(0o400)
        host = socket.gethostname().split(".")[0]
        user = subprocess.run(["id", "-un"], capture_output=True, text=True, check=True).stdout.strip()
        (self.folder / "slurm.conf").write_text(CONFIGURATION.format(
            host=host, user=user, folder=self.folder, controller=free_port(), node=free_port()))
        self.daemon("munged", "--foreground", "--force", f"--key-file={key}",
                    f"--socket={self.folder}/munge.socket", f"--pid-file={self.folder}/munge.pid",
                    f"--log-file={self.folder}/munge.log", f"--seed-file={self.folder}/munge.seed")
        if not until((self.folder / "munge.socket").exists):
            return "munged does not start"
        self.daemon("slurmctld", "-D", "-i")
        self.daemon("slurmd", "-D", "-N", host)
        if not until(lambda: "State=IDLE" in self.run("scontrol", "show", "node", host), 40):
            return "slurmctld and slurmd do not start: " + self.logs()
        return None

    def daemon(self, *command):
        self.daemons.append(subprocess.Popen(
            command, env=self.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            start_new_session=True))

    def run(self, *command):
        done = subprocess.run(command, env=self.environment, cwd=self.folder, capture_output=True,
                              text=True, timeout=60, check=False)
        return done.stdout + done.stderr

    def logs(self):
        return "\n".join(file.read_text(errors="replace")[-1500:] for file in self.folder.glob("*.log"))

    def jobs(self):
        return self.run("squeue", "--noheader", "--array", "--format=%i %T %r").splitlines()

    def stop(self):
        self.run("scancel", "--user", str(os.getuid()))
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in self.daemons:
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                os.killpg(daemon.pid, signal.SIGKILL)
                daemon.wait()


class OnSlurm(BatchTest):
    def setUp(self):
        super().setUp()
        missing = [name for name in PROGRAMS if not shutil.which(name, path=PATH)]
        if missing:
            self.skipTest(f"Slurm cannot be started here: there is no {', '.join(missing)}")
        folder = tempfile.TemporaryDirectory(prefix="slurm-")  # a socket's name must be short
        self.addCleanup(folder.cleanup)
        self.cluster = Cluster(pathlib.Path(folder.name))
        self.addCleanup(self.cluster.stop)
        failed = self.cluster.start()
        if failed:
            self.skipTest(f"Slurm cannot be started here: {failed}")

    def planish_of(self, share):
        """The process of the batch that does this share."""
        for entry in pathlib.Path("/proc").iterdir():
            try:
                words = (entry / "cmdline").read_bytes().split(b"\0") if entry.name.isdigit() else []
            except OSError:
                continue
            if b"batch" in words and share.encode() in words and str(self.dir / "out").encode() in words:
                if not words[0].endswith(b"bash"):
                    return int(entry.name)
        return None

    def release(self):
        """What is put back waits two minutes by default: not here."""
        for line in self.cluster.jobs():
            if "BeginTime" in line:
                self.cluster.run("scontrol", "update", f"JobId={line.split()[0]}", "StartTime=now")

    def test_an_array_of_4_with_a_task_killed(self):
        self.angles(500)
        self.batch("in", "-o", "whole", "--jobs", "2")
        said = self.cluster.run("sbatch", "--array=1-4", "--cpus-per-task=1", "--mem-per-cpu=1G",
                                str(SCRIPT), str(self.dir / "in"), str(self.dir / "out"))
        self.assertIn("Submitted batch job", said)
        share = self.dir / "out" / "shard-3-of-4" / "parts"
        self.assertTrue(until(lambda: share.is_dir() and len(list(share.iterdir())) > 1, 60),
                        self.cluster.logs())
        killed = self.planish_of("3/4")
        self.assertIsNotNone(killed, "the third share ended before it could be killed")
        os.kill(killed, signal.SIGKILL)
        end = time.monotonic() + SECONDS
        while (self.cluster.jobs()) and time.monotonic() < end:
            self.release()
            time.sleep(0.5)
        logs = "\n".join(file.read_text() for file in self.cluster.folder.glob("planish-*.log"))
        self.assertEqual(self.cluster.jobs(), [], logs)
        self.assertIn("share 3 ended with status 137: it is put back into the queue", logs)
        self.assertIn("inputs were done before", logs)
        self.assertTrue((self.dir / "out" / "parts.jsonl").exists(), logs)
        self.assert_same_result("whole", "out")


if __name__ == "__main__":
    main()
