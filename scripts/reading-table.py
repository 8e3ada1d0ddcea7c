#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the table of docs/performance.md, "Reading a trace": what whole processes take to read a large trace, also over
`wc -l` of the file, with one thread and with one for each core; and the memory of their own (RssAnon) at most.

usage: scripts/reading-table.py PROGRAM [RUNS]
"""

import json
import os
import subprocess
import sys
import tempfile
import time

CALLS = ["show --last", "validate", "stats", "explain --pixel 300,300"]


def least_time(words, runs):
    """In seconds, of some runs."""
    times = []
    for _ in range(runs):
        begin = time.monotonic()
        subprocess.run(words, stdout=subprocess.DEVNULL)
        times.append(time.monotonic() - begin)
    return min(times)


def most_memory(words):
    """In MB, of one run."""
    process, memory = subprocess.Popen(words, stdout=subprocess.DEVNULL), 0
    while process.poll() is None:
        try:
            with open(f"/proc/{process.pid}/status") as status:
                anonymous = [line for line in status if line.startswith("RssAnon")]
            if anonymous:
                memory = max(memory, int(anonymous[0].split()[1]) / 1024)
        except OSError:
            pass
        time.sleep(0.002)
    return memory


def main():
    program = os.path.abspath(sys.argv[1])
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 7
    scripts = os.path.dirname(os.path.abspath(__file__))
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        with open("torus.obj", "w") as model:
            subprocess.run([f"{scripts}/make-models.sh", "torus", "250", "200"], stdout=model, check=True)
        scene = {
            "canvas": {"width": 800, "height": 800},
            "camera": {"position": [0, 2, 4]},
            "projection": {"type": "frustum", "fov_y": 60, "near": 1, "far": 20},
            "method": {"depth": "inverse-z"},
            "meshes": [{"obj": "torus.obj"}],
        }
        with open("torus.json", "w") as file:
            json.dump(scene, file)
        subprocess.run([program, "trace", "torus.json", "-o", "torus.jsonl"], check=True)
        size = os.path.getsize("torus.jsonl")
        lines = least_time(["wc", "-l", "torus.jsonl"], runs)
        print(f"{size / 1e6:.0f} MB; `wc -l`: {lines * 1000:.0f} ms\n")
        print("| | one thread | over `wc -l` | all cores | over `wc -l` | memory |\n|---|---|---|---|---|---|")
        for call in CALLS:
            words = [program, *call.split(), "torus.jsonl"]
            alone = least_time([*words, "--jobs", "1"], runs)
            together = least_time(words, runs)
            print(f"| `{call}` | {alone:.2f} s | {alone / lines:.0f} | {together:.2f} s | {together / lines:.0f} "
                  f"| {most_memory(words):.0f} MB |")


main()
