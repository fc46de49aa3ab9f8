#!/usr/bin/python3
"""Time at equal error: tyndall trace against Blender's Cycles on the reference scenes. Needs blender, python3-openimageio and python3-numpy.

    tests/bench/cycles/compare.py [--tyndall build/release/bin/tyndall] [--out FOLDER] [--threads N]

For each scene both render with two numbers of samples. The error is the relative mean square error against a long trace with another seed
(its own noise is far below). Error times time is about the same for any number of samples, so its ratio is that of times at equal error.
Times are of rendering alone, without starting up and loading. Run it on a quiet machine.
"""
import argparse
import pathlib
import re
import subprocess

import numpy as np
import OpenImageIO as oiio

# scene file, options of the trace, size, samples of Tyndall, of Cycles, and of the truth
SCENES = {
    "s1_fog_spot": ("s1_fog_spot.json", ["--single-scattering"], "320x180", (64, 256), (64, 256), 8192),
    "s3_potato_matched": ("s3_sphere_potato_matched.json", [], "192x192", (64, 256), (64, 256), 8192),
    "s4_hetero": ("s4_hetero.json", ["--single-scattering"], "256x256", (64, 256), (64, 256), 4096),
}


def pixels(path):
    buffer = oiio.ImageBuf(str(path))
    names = list(buffer.spec().channelnames)
    return np.array(buffer.get_pixels(oiio.FLOAT), dtype=np.float64)[..., [names.index(c) for c in "RGB"]]


def relative_error(truth, test):
    return float(np.mean((test - truth) ** 2 / (truth ** 2 + (0.1 * truth.mean()) ** 2)))


def run(command, pattern):
    done = subprocess.run(command, capture_output=True, text=True)
    found = re.search(pattern, done.stdout)
    if not found:
        raise SystemExit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return float(found.group(1))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tyndall", default="build/release/bin/tyndall")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/cycles"))
    parser.add_argument("--threads", type=int, default=0)
    parser.add_argument("--only", choices=SCENES)
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    threads = ["--threads", str(options.threads)] if options.threads else []
    print(f"{'scene':20} {'renderer':8} {'samples':>7} {'seconds':>8} {'relMSE':>10} {'mean':>7} {'relMSE x s':>11}")
    for name, (scene, extra, size, ours, theirs, many) in SCENES.items():
        if options.only and name != options.only:
            continue
        trace = [options.tyndall, "trace", f"assets/scenes/{scene}", "--size", size, *extra, *threads]
        truth_file = options.out / f"{name}_truth.exr"
        if not truth_file.exists():
            run([*trace, "--seed", "4711", "--spp", str(many), "--out", str(truth_file)], r"([\d.]+) s,")
        truth = pixels(truth_file)
        cost = {}
        for renderer, counts in (("tyndall", ours), ("cycles", theirs)):
            for samples in counts:
                out = options.out / f"{name}_{renderer}_{samples}.exr"
                if renderer == "tyndall":
                    seconds = run([*trace, "--spp", str(samples), "--out", str(out)], r"%, ([\d.]+) s,")
                else:
                    seconds = run(["blender", "--background", "--factory-startup", "--python", "tests/bench/cycles/render.py", "--",
                                   name, "--samples", str(samples), "--out", str(out.absolute()), *threads], r"cycles ([\d.]+)")
                test = pixels(out)
                error = relative_error(truth, test)
                cost.setdefault(renderer, []).append(error * seconds)
                print(f"{name:20} {renderer:8} {samples:7} {seconds:8.2f} {error:10.3g} {test.mean() / truth.mean():7.4f} {error * seconds:11.3g}",
                      flush=True)
        print(f"{name:20} Cycles needs {cost['cycles'][0] / cost['tyndall'][0]:.1f} and {cost['cycles'][1] / cost['tyndall'][1]:.1f} times "
              "as long for the same error")


main()
