#!/usr/bin/python3
"""Cost at equal error: tyndall trace against Blender's Cycles on the reference scenes. Needs blender, python3-openimageio and python3-numpy.

    tests/bench/cycles/compare.py [--tyndall build/release/bin/tyndall] [--out FOLDER] [--threads N] [--samples N...] [--repeat N] [--only SCENE]

The error is the relative mean square error against a long trace with another seed, whose own noise (its film's variance) is subtracted.
Error times cost is about the same for any number of samples, so its ratio is that of costs at equal error.
The cost is in CPU seconds, user and system, of all threads, so that other work on the machine counts for little: that of the whole process
less that of the same command with one sample, which starts up, loads and writes as well. Both renderers are measured in the same way and
take turns, each with a new seed; the figures are medians (cost) and means (error) of the turns.
"""
import argparse
import os
import pathlib
import re
import statistics
import subprocess

import numpy as np
import OpenImageIO as oiio

# scene file, options of the trace, size, samples of the truth
SCENES = {
    "s1_fog_spot": ("s1_fog_spot.json", ["--single-scattering"], "320x180", 256),
    "s3_potato_matched": ("s3_sphere_potato_matched.json", [], "192x192", 128),
    "s4_hetero": ("s4_hetero.json", ["--single-scattering"], "256x256", 128),
}


def layer(path, prefix=""):
    buffer = oiio.ImageBuf(str(path))
    names = list(buffer.spec().channelnames)
    return np.array(buffer.get_pixels(oiio.FLOAT), dtype=np.float64)[..., [names.index(prefix + c) for c in "RGB"]]


def relative_error(truth, variance, test):
    return float(np.mean(((test - truth) ** 2 - variance) / (truth ** 2 + (0.1 * truth.mean()) ** 2)))


def run(command):
    """CPU seconds of a process, and what it printed."""
    process = subprocess.Popen(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    said = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, command))}\n{said}")
    return usage.ru_utime + usage.ru_stime, said


def work(said):
    """Millions of rays and events of a trace."""
    seconds, rays, events = map(float, re.search(r"%, ([\d.]+) s, ([\d.]+) million rays and ([\d.]+) million events", said).groups())
    return rays * seconds, events * seconds


class Scene:
    """One scene's commands and figures."""

    def __init__(self, name, options):
        self.name, self.options = name, options
        scene, extra, size, self.many = SCENES[name]
        self.counts = options.samples
        threads = ["--threads", options.threads] if options.threads else []
        self.trace = [options.tyndall, "trace", f"assets/scenes/{scene}", "--size", size, *extra, *threads]
        self.blender = ["blender", "--background", "--factory-startup", "--python-exit-code", "1", "--python", "tests/bench/cycles/render.py", "--",
                        name, *threads]

    def render(self, renderer, samples, seed):
        """Picture, CPU seconds of the whole process, and what it said."""
        out = (self.options.out / f"{self.name}_{renderer}.exr").absolute()
        command = ([*self.trace, "--spp", samples] if renderer == "tyndall" else [*self.blender, "--samples", samples]) + ["--seed", seed, "--out", out]
        seconds, said = run(command)
        return layer(out), seconds, said

    def truth(self):
        file = self.options.out / f"{self.name}_truth.exr"
        run([*self.trace, "--seed", 4711, "--spp", self.many, "--out", file, "--resume"])
        return layer(file), layer(file, "variance.")

    def compare(self):
        truth, variance = self.truth()
        turns = range(1, self.options.repeat + 1)
        found = {}
        for samples in self.counts:
            for seed in turns:
                for renderer in ("tyndall", "cycles"):
                    start = self.render(renderer, 1, seed)[1]
                    picture, seconds, said = self.render(renderer, samples, seed)
                    figures = found.setdefault((renderer, samples), {"cpu": [], "start": [], "error": [], "mean": [], "rate": []})
                    cpu = (seconds - start) * samples / (samples - 1)
                    figures["cpu"].append(cpu)
                    figures["start"].append(start)
                    figures["error"].append(relative_error(truth, variance, picture))
                    figures["mean"].append(picture.mean() / truth.mean())
                    if renderer == "tyndall":
                        figures["rate"].append([amount / cpu for amount in work(said)])
            for renderer in ("tyndall", "cycles"):
                self.show(renderer, samples, found[renderer, samples])
        for samples in self.counts:
            ours, theirs = (self.cost(found[renderer, samples]) for renderer in ("tyndall", "cycles"))
            print(f"{self.name:18} {samples} samples: Cycles needs {theirs / ours:.2f} times the CPU seconds for the same error", flush=True)

    @staticmethod
    def cost(figures):
        return statistics.mean(figures["error"]) * statistics.median(figures["cpu"])

    def show(self, renderer, samples, figures):
        rate = "".join(f" {statistics.median(values):8.2f}" for values in zip(*figures["rate"])) if figures["rate"] else ""
        print(f"{self.name:18} {renderer:8} {samples:7} {statistics.median(figures['cpu']):7.2f} {statistics.median(figures['start']):7.2f} "
              f"{statistics.mean(figures['error']):10.3g} {statistics.mean(figures['mean']):7.4f} {self.cost(figures):11.3g}{rate}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tyndall", default="build/release/bin/tyndall")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/cycles"))
    parser.add_argument("--threads", type=int, default=0)
    parser.add_argument("--samples", type=int, nargs="+", default=[32])
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--only", choices=SCENES)
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    print(f"{'scene':18} {'renderer':8} {'samples':>7} {'CPU s':>7} {'start':>7} {'relMSE':>10} {'mean':>7} {'relMSE x s':>11}  million rays, events a CPU second")
    for name in SCENES:
        if not options.only or name == options.only:
            Scene(name, options).compare()


main()
