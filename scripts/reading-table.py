#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the table of docs/performance.md, "Traces": what whole processes take to read a large trace, also over
`wc -l` of the file, and their peak resident memory.

usage: scripts/reading-table.py PROGRAM [RUNS]
"""

import json
import os
import subprocess
import sys
import tempfile
import time

CALLS = ["show --step last", "validate", "stats", "explain --pixel 300,300"]


def least_time(words, runs):
    """In seconds, of some runs."""
    times = []
    for _ in range(runs):
        begin = time.monotonic()
        process = subprocess.Popen(words, stdout=subprocess.DEVNULL)
        if process.wait() != 0:
            raise SystemExit(f"{' '.join(words)}: status {process.returncode}")
        times.append(time.monotonic() - begin)
    return min(times)


def peak_memory(words):
    """In MB."""
    process = subprocess.Popen(words, stdout=subprocess.DEVNULL)
    return os.wait4(process.pid, 0)[2].ru_maxrss / 1024


def reading_table(program, runs):
    size = os.path.getsize("torus.jsonl")
    lines = least_time(["wc", "-l", "torus.jsonl"], runs)
    print(f"{size / 1e6:.0f} MB; `wc -l`: {lines * 1000:.0f} ms\n")
    print("| | time | over `wc -l` | memory |\n|---|---|---|---|")
    for call in CALLS:
        words = [program, *call.split(), "torus.jsonl"]
        spent = least_time(words, runs)
        print(f"| `{call}` | {spent:.2f} s | {spent / lines:.0f} | {peak_memory(words):.0f} MB |")


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
        reading_table(program, runs)


main()
