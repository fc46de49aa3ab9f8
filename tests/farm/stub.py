#!/usr/bin/env python3
"""Stands for the program in the farm's test: answers `trace`, `merge` and `capture` as the folder that $FARM_STUB names says.
FOLDER/N says how shard N behaves (a word, else it works at once); FOLDER/N.runs gets a line of JSON per run: its shell, its arguments."""
import json
import os
import pathlib
import signal
import sys
import time

folder = pathlib.Path(os.environ["FARM_STUB"])
words = sys.argv[1:]
out = pathlib.Path(words[words.index("--out") + 1])
if words[0] == "merge":
    shards = [pathlib.Path(w) for w in words[1:words.index("--out")]]
    if any("damaged" in s.read_text() for s in shards):
        sys.exit("tyndall: 2.exr: is damaged")
    out.write_text("".join(s.read_text() for s in shards))
    sys.exit(0)
number = words[words.index("--shard") + 1].split("/")[0]
with open(folder / f"{number}.runs", "a") as runs:
    runs.write(json.dumps([os.getppid(), *words]) + "\n")
behaviour = folder / number
while behaviour.exists():
    does = behaviour.read_text()
    if does == "fail":
        print("working", flush=True)
        sys.exit("tyndall: the scene is no scene")
    if does == "die":
        os.kill(os.getpid(), signal.SIGKILL)
    if does == "die once":
        behaviour.unlink()
        os.kill(os.getpid(), signal.SIGKILL)
    print("tracing", flush=True)  # "wait": until the file is gone
    time.sleep(0.1)
out.write_text(f"shard {words[words.index('--shard') + 1]}\n")
