#!/usr/bin/env python3
"""`tyndall farm` on a cluster of one machine. usage: farm_test.py PROGRAM. Exit code 77: Slurm is not installed."""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
import traceback

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "robustness"))
sys.path.insert(0, str(HERE))
from cluster import Cluster, missing  # noqa: E402
from harness import ROOT, Tests  # noqa: E402

SCENE = ROOT / "assets" / "scenes" / "shadows.json"
PATIENCE_S = 120
HALF_TRACE = """#!/bin/bash
# The program; shard 2, as long as $HALFWAY is there, saves the first of its samples, tells its process, and hangs.
if [[ "$*" == *"--shard 2/3"* && -e $HALFWAY ]]; then
    "$REAL" "${@/#256/96}"
    echo $$ >"$HALFWAY.id"
    exec sleep 1000
fi
exec "$REAL" "$@"
"""


def wait_for(happened):
    end = time.monotonic() + PATIENCE_S
    while not happened():
        if time.monotonic() > end:
            raise RuntimeError("it does not happen")
        time.sleep(0.05)


class Farm:
    """The farm's commands, in a folder with an awkward name, with the stub as the program that tasks run."""

    def __init__(self, tests, cluster):
        self.tests, self.cluster = tests, cluster
        self.folder = tests.folder / "it's \"a\" $HOME `folder` # é"
        self.stub = self.folder / "stub"
        self.stub.mkdir(parents=True)
        self.scene = self.folder / "my 'own' scene.json"
        shutil.copy(SCENE, self.scene)
        shutil.copytree(SCENE.parent / "textures", self.folder / "textures")

    def run(self, *arguments, **environment):
        command = [self.tests.program, "farm", *map(str, arguments)]
        done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE_S, cwd=self.folder,
                              env={**self.cluster.environment, "FARM_STUB": str(self.stub), **environment})
        done.said = done.stdout + done.stderr
        return done

    def submit(self, job, *arguments, **environment):
        return self.run("submit", self.scene.name, "--folder", job, "--program", HERE / "stub.py", *arguments, **environment)

    def collect(self, job, *arguments):
        return self.run("collect", job, "--program", HERE / "stub.py", *arguments)

    def behave(self, task, does):
        (self.stub / f"{task}.new").write_text(does)
        (self.stub / f"{task}.new").rename(self.stub / str(task))

    def work(self, task):
        (self.stub / str(task)).unlink()

    def runs(self, task):
        file = self.stub / f"{task}.runs"
        return [json.loads(line) for line in file.read_text().splitlines()] if file.exists() else []

    def fresh(self):
        for file in self.stub.iterdir():
            file.unlink()

    def until(self, job, *words):
        """The status that has all the words."""
        end = time.monotonic() + PATIENCE_S
        while True:
            status = self.run("status", job)
            if all(w in status.stdout for w in words):
                return status
            if time.monotonic() > end:
                raise RuntimeError(f"{job}: no status with {words}\n{status.said}")
            time.sleep(0.4)


def works(t, farm):
    options = ["--camera", "it's a \"Camera\" $HOME", "--set", "/entities/Sun/directional_light/illuminance_lux=[1, 'x']"]
    done = farm.submit("good", "--shards", 3, *options)
    t.check(done.returncode == 0 and "sent 3 of 3 tasks" in done.stdout, f"submit: {done.said}")
    status = farm.until("good", "3 of 3 done")
    t.check(status.returncode == 0 and "farm collect" in status.stdout, f"status when done: {status.said}")
    job = farm.folder / "good"
    for i in (1, 2, 3):
        wanted = ["trace", str(farm.scene), *options, "--shard", f"{i}/3", "--out", str(job / "tasks" / f"{i}.exr"), "--resume"]
        t.check([run[1:] for run in farm.runs(i)] == [wanted], f"arguments of task {i}: {farm.runs(i)}")
    done = farm.collect("good", "--out", "all 'of' it.exr")
    merged = farm.folder / "all 'of' it.exr"
    t.check(done.returncode == 0 and merged.exists() and merged.read_text() == "shard 1/3\nshard 2/3\nshard 3/3\n", f"collect: {done.said}")
    done = farm.submit("good", "--shards", 3, *options)
    t.check(done.returncode == 0 and "nothing to send" in done.stdout, f"submit when done: {done.said}")
    done = farm.run("status", "good", SLURM_CONF="/no/slurm.conf")
    t.check(done.returncode == 0, f"what is done needs no Slurm: {done.said}")

    (job / "tasks" / "2.exr").write_text("damaged")
    done = farm.collect("good")
    t.check(done.returncode == 1 and "is damaged" in done.stderr and "after its file is deleted" in done.stderr, f"damaged shard: {done.said}")
    (job / "tasks" / "2.exr").unlink()
    t.check(farm.run("submit", "good").returncode == 0, "submit after a shard was deleted")
    done = farm.collect("good", "--retry", 0)
    t.check(done.returncode == 0 and len(farm.runs(2)) == 2 and len(farm.runs(1)) == 1, f"only the deleted shard is made again: {done.said}")


def states(t, farm):
    """Every state at once, then what resuming does about each."""
    farm.fresh()
    farm.behave(1, "wait")
    farm.behave(2, "fail")
    farm.behave(3, "die")
    farm.behave(5, "wait")
    farm.submit("mixed", "--shards", 5, "--cpus", 1, "--time-limit", "30", "--mem", "100M")
    status = farm.until("mixed", "1 of 5 done", "2 running", "1 FAILED", "1 DEAD", "| tracing")
    t.check(status.returncode == 1, "status with a failed task ends with 1")
    for words in ("    2  FAILED", "the scene is no scene", "code 1 on localhost", "logs/2.log", "    3  DEAD", "signal 9", "farm submit"):
        t.check(words in status.stdout, f"status does not say '{words}'\n{status.stdout}")
    done = farm.collect("mixed")
    t.check(done.returncode == 1 and "4 of 5 tasks are missing" in done.stdout and not (farm.folder / "mixed" / "my 'own' scene.exr").exists(),
            f"collect of a job that is not done: {done.said}")

    os.kill(farm.runs(1)[0][0], signal.SIGKILL)  # the task's own shell: it cannot mark its end
    status = farm.until("mixed", "1 running", "2 DEAD")
    t.check("    1  DEAD" in status.stdout and "without a result on localhost" in status.stdout, f"killed with its shell: {status.stdout}")

    for task in (1, 2, 3):
        farm.work(task)
    done = farm.run("submit", "mixed")
    t.check("sent 3 of 5 tasks" in done.stdout, f"resume: {done.said}")
    farm.until("mixed", "4 of 5 done", "1 running")
    running = farm.cluster.ask("squeue", "--noheader", "--array", "--states=running", "--format=%i").split()
    t.check(len(running) == 1, f"in the queue: {running}")
    farm.cluster.ask("scancel", *running)
    status = farm.until("mixed", "1 DEAD")
    # The program may be gone before the task's shell is told: then it marks the signal.
    t.check("cancelled" in status.stdout or "signal 15" in status.stdout, f"cancelled: {status.stdout}")
    farm.work(5)
    done = farm.collect("mixed", "--retry", 1)
    merged = farm.folder / "mixed" / "my 'own' scene.exr"
    t.check(done.returncode == 0 and merged.read_text() == "".join(f"shard {i}/5\n" for i in range(1, 6)), f"collect: {done.said}")
    counts = [len(farm.runs(i)) for i in range(1, 6)]
    t.check(counts == [2, 2, 2, 1, 2], f"what was done is not done again: runs {counts}")


def retries(t, farm):
    farm.fresh()
    farm.behave(2, "die once")
    farm.submit("retry", "--shards", 3)
    done = farm.collect("retry", "--retry", 2)
    t.check(done.returncode == 0 and len(farm.runs(2)) == 2 and len(farm.runs(3)) == 1, f"retry: {done.said}")
    farm.fresh()
    farm.behave(1, "die")
    farm.behave(2, "fail")
    farm.submit("hopeless", "--shards", 3)
    done = farm.collect("hopeless", "--retry", 2)
    t.check(done.returncode == 1 and "2 of 3 tasks are missing" in done.stdout, f"a task that always dies: {done.said}")
    counts = [len(farm.runs(i)) for i in (1, 2, 3)]
    t.check(counts == [3, 1, 1], f"dead tasks are sent again twice, failed ones not: runs {counts}")


def captures(t, farm):
    """The program itself: pictures of two captures, of which one does not hold what it expects."""
    small = {"tyndall_capture": 1, "scene": farm.scene.name, "size": [32, 18], "variants": [{"name": "plain"}]}
    folder = farm.folder / "captures"
    folder.mkdir()
    (folder / "a \"b\".json").write_text(json.dumps({**small, "scene": "../" + farm.scene.name}))
    (folder / "dark.json").write_text(json.dumps({**small, "scene": "../" + farm.scene.name, "expect": [{"of": "plain", "mean_between": [1e8, 1e9]}]}))
    (folder / "other.json").write_text("{}")
    done = farm.run("submit", folder, "--folder", "pictures", "--png")
    t.check("2 captures; sent 2 of 2" in done.stdout, f"submit of captures: {done.said}")
    done = farm.run("collect", "pictures", "--retry", 0, "--out", "taken")
    t.check(done.returncode == 1 and "FAILED" in done.stdout and "1 of 2 tasks are missing" in done.stdout, f"collect of captures: {done.said}")
    t.check("expectations failed" in done.stdout, f"what failed is told: {done.said}")
    pictures = sorted(str(p.relative_to(farm.folder / "taken")) for p in (farm.folder / "taken").rglob("*.png"))
    t.check(pictures == ['a "b"/a "b"-plain.png', "dark/dark-plain.png"], f"pictures: {pictures}")


def truth(t, farm):
    """The program itself traces: a shard is killed halfway, and goes on where it was saved."""
    options = ["--size", "64x36", "--spp", "256", "--batch", "16"]
    scene = str(SCENE.parent / "s1_fog_spot.json")
    alone = subprocess.run([t.program, "trace", scene, *options, "--out", "alone.exr"], cwd=farm.folder, capture_output=True, text=True)
    t.check(alone.returncode == 0, f"trace: {alone.stderr}")
    if alone.returncode != 0:
        return
    half = farm.folder / "half"
    half.write_text(HALF_TRACE)
    half.chmod(0o755)
    halfway = farm.folder / "halfway"
    halfway.write_text("")
    done = farm.run("submit", scene, "--folder", "film", "--shards", 3, "--program", half, *options, REAL=str(t.program), HALFWAY=str(halfway))
    t.check("sent 3 of 3" in done.stdout, f"submit of a trace: {done.said}")
    process = farm.folder / "halfway.id"
    wait_for(lambda: process.exists() and process.read_text())
    farm.until("film", "2 of 3 done", "1 running")
    os.kill(int(process.read_text()), signal.SIGKILL)
    farm.until("film", "2 of 3 done", "1 DEAD", "signal 9")
    halfway.unlink()
    done = farm.run("collect", "film", "--retry", 1, "--out", "film.exr", REAL=str(t.program), HALFWAY=str(halfway))
    t.check(done.returncode == 0, f"collect of a trace: {done.said}")
    same = (farm.folder / "film.exr").read_bytes() == (farm.folder / "alone.exr").read_bytes()
    t.check(same, "the merged film is not the film that is traced alone, bit for bit")


def refusals(t, farm):
    def refused(name, done, *words):
        t.check(done.returncode == 1, f"{name}: ended with {done.returncode}\n{done.said}")
        for w in words:
            t.check(w in done.stderr, f"{name}: does not say '{w}'\n{done.said}")
        t.check(done.stderr.startswith("tyndall: ") and len(done.stderr.splitlines()) <= 4, f"{name}: {done.stderr}")

    refused("unknown partition", farm.submit("p", "--partition", "nigth"), "unknown partition 'nigth'", "main, night", "did you mean 'night'")
    done = farm.submit("p", "--partition", "night")
    t.check(done.returncode == 0, f"the same with the right partition: {done.said}")
    refused("too many tasks", farm.submit("many", "--shards", 5000), "MaxArraySize")
    refused("too much memory", farm.submit("much", "--mem", "900G"), "sbatch")
    refused("another job's folder", farm.submit("p", "--shards", 2), "another job", "number of shards")
    refused("a job with options", farm.run("submit", "p", "--shards", 2), "settled")
    refused("missing scene", farm.run("submit", "no.json", "--shards", 2), "no.json")
    refused("nothing", farm.run("submit"), "nothing to submit")
    refused("the farm's own option", farm.submit("own", "--shard", "1/2"), "--shard")
    refused("no job", farm.run("status", farm.stub), "no farm job")
    refused("no job", farm.run("collect", "nowhere"), "nowhere", "no farm job")
    refused("a folder without captures", farm.run("submit", farm.stub), "holds no captures")
    refused("a folder of something else", farm.submit(farm.folder / "textures"), "is no farm job")
    refused("a folder that Slurm cannot take", farm.submit("50%a"), "'%'")
    (farm.folder / "broken.json").write_text('{ "tyndall": 1, "entities": [{ "spotlight": {} }] }')
    refused("a broken scene", farm.run("submit", "broken.json"), "broken.json", "spotlight")
    (farm.folder / "corrupt").mkdir()
    (farm.folder / "corrupt" / "job.json").write_text('{ "tyndall_farm": 1,')
    refused("corrupt job", farm.run("status", "corrupt"), "job.json:1:")
    refused("no Slurm", farm.submit("away", PATH="/nowhere"), "'squeue' could not be started", "slurm-client")
    status = farm.run("status", "away", PATH="/nowhere")
    t.check(status.returncode == 1 and "unknown" in status.stdout and "slurm-client" in status.stdout, f"status without Slurm: {status.said}")
    nobody = farm.folder / "nobody.conf"
    nobody.write_text(farm.cluster.configuration.read_text().replace("SlurmctldPort=", "SlurmctldPort=1\n#"))
    refused("no controller", farm.submit("silent", SLURM_CONF=str(nobody)), "contact slurm controller", "slurmctld that answers")


if missing():
    print(f"skipped: not installed: {', '.join(missing())} (Debian packages slurm-wlm and munge)")
    sys.exit(77)
signal.signal(signal.SIGTERM, lambda *_: sys.exit("ended by a signal"))  # the cluster ends with it
with Tests() as tests, Cluster() as cluster:
    farm = Farm(tests, cluster)
    for part in (works, states, retries, captures, truth, refusals):
        started = time.monotonic()
        try:
            part(tests, farm)
            print(f"{part.__name__}: {time.monotonic() - started:.0f} s")
        except Exception:  # what failed before it matters, too
            tests.check(False, f"{part.__name__} ended early\n{traceback.format_exc()}")
