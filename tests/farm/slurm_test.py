#!/usr/bin/env python3
"""Renders a small sequence on a Slurm cluster of emulated nodes, one of which dies half-way.

usage: slurm_test.py LUMINIST OUTPUT_FOLDER

Everything runs on 127.0.0.1 with state in one temporary folder and ends with the test. Needs root, because slurmd does,
and the packages slurm-wlm and munge; without them the test is skipped (status 77).
"""
import ctypes
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SCENE = ROOT / "meshes/creature/creature.glb"
RIG = ROOT / "meshes/creature/rig.toml"
NODES = ["n1", "n2"]
FRAMES = 8
CHUNK = 2
SKIPPED = 77
PROGRAMS = ["munged", "slurmctld", "slurmd", "sbatch", "squeue", "sinfo", "scontrol"]
DEADLINE = 400  # seconds: ten times what the longest wait takes, a dead node and the work of the other
DAEMON_DEADLINE = 60

CONFIG = """
ClusterName=luminist
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
StateSaveLocation={folder}/state
SlurmctldPidFile={folder}/slurmctld.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdPidFile={folder}/slurmd.%n.pid
SlurmdLogFile={folder}/slurmd.%n.log
SlurmdSpoolDir={folder}/spool.%n
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SwitchType=switch/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/filetxt
JobCompLoc={folder}/completed.txt
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=2,bf_interval=2
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
ReturnToService=2
KillWait=1
SlurmdTimeout=5
BatchStartTimeout=5
MessageTimeout=5
"""


class Fault(Exception):
    """What the test found wrong."""


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for each in sockets:
        each.bind(("127.0.0.1", 0))
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


def wait_for(what, holds, deadline, pause=0.2):
    end = time.monotonic() + deadline
    while True:
        value = holds()
        if value:
            return value
        if time.monotonic() > end:
            raise Fault(f"after {deadline} s still no {what}")
        time.sleep(pause)


def children():
    """{parent: [processes]} of the whole machine."""
    tree = {}
    for entry in pathlib.Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            status = (entry / "stat").read_text()
        except OSError:
            continue
        tree.setdefault(int(status.rpartition(")")[2].split()[1]), []).append(int(entry.name))
    return tree


def below(process, tree=None):
    """A process's descendants, parents first."""
    tree = tree or children()
    found = list(tree.get(process, []))
    for each in found:
        found.extend(tree.get(each, []))
    return found


def environment(process):
    try:
        return pathlib.Path(f"/proc/{process}/environ").read_bytes().split(b"\0")
    except OSError:
        return []


def kill(processes):
    for process in processes:
        try:
            os.kill(process, signal.SIGKILL)
        except ProcessLookupError:
            pass


def reap():
    """Takes the statuses of ended processes that came to this one."""
    try:
        while os.waitpid(-1, os.WNOHANG)[0]:
            pass
    except ChildProcessError:
        pass


def kill_all_below():
    """Ends every process that was started from here, however it was detached."""
    for _ in range(200):
        reap()
        left = below(os.getpid())
        if not left:
            return
        kill(left)
        time.sleep(0.05)
    print("left behind:", left, file=sys.stderr)


LIBC = ctypes.CDLL(None, use_errno=True)


def set_process(option, value):
    """prctl(2)"""
    if LIBC.prctl(option, value, 0, 0, 0) != 0:
        raise OSError(ctypes.get_errno(), "prctl")


def adopt_orphans():
    """Processes whose parents end come to this one and not to init, so that none is lost sight of."""
    pr_set_child_subreaper = 36
    set_process(pr_set_child_subreaper, 1)


def end_with_the_test():
    """In a daemon, before it runs: also where the test itself is killed."""
    pr_set_pdeathsig = 1
    set_process(pr_set_pdeathsig, signal.SIGKILL)


class Cluster:
    """Slurm on this machine, without systemd."""

    def __init__(self, folder):
        self.folder = folder
        self.environment = {**os.environ, "SLURM_CONF": str(folder / "slurm.conf")}
        self.daemons = {}
        port, *node_ports = free_ports(1 + len(NODES))
        text = CONFIG.format(folder=folder, host=socket.gethostname().split(".")[0], port=port)
        for node, node_port in zip(NODES, node_ports):
            text += f"NodeName={node} NodeHostname=localhost NodeAddr=127.0.0.1 Port={node_port} CPUs=1 State=UNKNOWN\n"
            (folder / f"spool.{node}").mkdir()
        text += "PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP\n"
        (folder / "slurm.conf").write_text(text)
        (folder / "state").mkdir()
        key = folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)

    def start(self):
        at = self.folder
        self.daemon("munged", ["munged", "--foreground", "--force", f"--key-file={at}/munge.key",
                               f"--socket={at}/munge.socket", f"--pid-file={at}/munged.pid",
                               f"--log-file={at}/munged.log", f"--seed-file={at}/munged.seed"])
        wait_for("munge socket", (at / "munge.socket").exists, DAEMON_DEADLINE)
        self.daemon("slurmctld", ["slurmctld", "-D"])
        for node in NODES:
            self.daemon(node, ["slurmd", "-D", "-N", node])
        wait_for("idle nodes", lambda: self.ask("sinfo", "-h", "-N", "-o", "%T") == ["idle"] * len(NODES),
                 DAEMON_DEADLINE)

    def daemon(self, name, words):
        with open(self.folder / f"{name}.out", "wb") as out:
            self.daemons[name] = subprocess.Popen(words, env=self.environment, stdin=subprocess.DEVNULL, stdout=out,
                                                  stderr=out, start_new_session=True,
                                                  preexec_fn=end_with_the_test)

    def ask(self, *words):
        """Lines of an answer; none while there is no controller to give one."""
        done = subprocess.run(words, env=self.environment, capture_output=True, text=True, check=False)
        return done.stdout.split("\n")[:-1] if done.returncode == 0 else None

    def submit(self, script):
        subprocess.run(["sbatch", script.name], cwd=script.parent, env=self.environment, check=True)

    def working(self, program):
        """{node: processes} of the program on the nodes."""
        found = {}
        for process in below(os.getpid()):
            words = environment(process)
            for node in NODES:
                if f"SLURMD_NODENAME={node}".encode() not in words:
                    continue
                try:
                    if os.readlink(f"/proc/{process}/exe") == program:
                        found.setdefault(node, []).append(process)
                except OSError:
                    pass
        return found

    def kill_node(self, node):
        """As if its power failed: the daemon first, so that nobody tells the controller, then all of its steps."""
        tree = children()
        parents = {child: parent for parent, all_children in tree.items() for child in all_children}
        steps = []
        for process in below(os.getpid(), tree):
            if f"SLURMD_NODENAME={node}".encode() not in environment(process):
                continue
            way = [process]
            while parents.get(way[-1]) not in (None, os.getpid(), self.daemons[node].pid):
                way.append(parents[way[-1]])
            steps.extend(reversed(way))
        kill([self.daemons[node].pid, *dict.fromkeys(steps)])

    def idle(self):
        """Whether no task is left. A task of a node that died waits two minutes before Slurm starts it again, whatever
        is configured; here as soon as it is queued again."""
        lines = self.ask("squeue", "-h", "-o", "%i %r")
        for line in lines or []:
            task, reason = line.split(maxsplit=1)
            if reason == "BeginTime":
                self.ask("scontrol", "update", f"JobId={task}", "StartTime=now")
        return lines == []

    def logs(self):
        for path in sorted(self.folder.glob("*.log")) + sorted(self.folder.glob("*.out")):
            print(f"--- {path.name}", *path.read_text(errors="replace").splitlines()[-25:], sep="\n", file=sys.stderr)


def whole_frames(output):
    return sorted(output.glob("f.*.exr"))


def render(luminist, output):
    words = [luminist, "render", SCENE, "--rig", RIG, "--size", "64x48", "--frames", f"0-{FRAMES - 1}",
             "-o", output / "f.####.exr"]
    done = subprocess.run(words, stdout=subprocess.PIPE, text=True, check=True)
    return done.stdout.splitlines()


def run_job(cluster, luminist, output):
    """Submits the sequence and kills the first node that works once a frame is there."""
    job = output / "job"
    subprocess.run([luminist, "farm", SCENE, "--rig", RIG, "--size", "64x48", "--frames", f"0-{FRAMES - 1}",
                    "--chunk", str(CHUNK), "-o", output / "f.####.exr", "--job", job], check=True,
                   stdout=subprocess.DEVNULL)
    cluster.submit(job / "job.sh")
    wait_for("first frame", lambda: whole_frames(output), DEADLINE, 0.05)
    victim = wait_for("node at work", lambda: next(iter(cluster.working(luminist)), None), DEADLINE, 0.01)
    cluster.kill_node(victim)
    there = len(whole_frames(output))
    print(f"{victim} was killed at work with {there} of {FRAMES} frames there")
    if there == FRAMES:
        raise Fault("the node was killed when all was done")
    wait_for("end of the job", cluster.idle, DEADLINE)


def check(luminist, output, serial):
    frames = whole_frames(output)
    if len(frames) != FRAMES:
        raise Fault(f"{len(frames)} of {FRAMES} frames are there")
    again = [line for line in render(luminist, output) if not line.endswith("(was there)")]
    if again:
        raise Fault(f"these were not whole: {', '.join(again)}")
    different = [path.name for path in frames if path.read_bytes() != (serial / path.name).read_bytes()]
    if different:
        raise Fault(f"these differ from a serial run: {', '.join(different)}")
    left = [path.name for path in output.iterdir() if path.is_file() and path not in frames]
    if left:
        print(f"torn by the kill, as temporary files: {', '.join(left)}")


def main():
    luminist, output = os.path.realpath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
    os.environ["PATH"] += os.pathsep + os.pathsep.join(["/usr/sbin", "/sbin"])
    missing = [program for program in PROGRAMS if shutil.which(program) is None]
    if missing or os.geteuid() != 0:
        print("skipped:", f"no {', '.join(missing)} (packages slurm-wlm and munge)" if missing else "needs root")
        return SKIPPED
    shutil.rmtree(output, ignore_errors=True)
    (output / "farm").mkdir(parents=True)
    (output / "serial").mkdir()
    folder = pathlib.Path(tempfile.mkdtemp(prefix="luminist-slurm-"))
    adopt_orphans()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
    started = time.monotonic()
    cluster = Cluster(folder)
    try:
        render(luminist, output / "serial")
        print(f"serial run: {time.monotonic() - started:.1f} s")
        cluster.start()
        print(f"cluster up: {time.monotonic() - started:.1f} s")
        run_job(cluster, luminist, output / "farm")
        print(f"job done: {time.monotonic() - started:.1f} s")
        check(luminist, output / "farm", output / "serial")
    except (Fault, subprocess.CalledProcessError) as fault:
        cluster.logs()
        print(f"slurm: {fault}")
        return 1
    finally:
        kill_all_below()
        shutil.rmtree(folder, ignore_errors=True)
    print(f"slurm: all frames are there, as of a serial run, {time.monotonic() - started:.1f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
