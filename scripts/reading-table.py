#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the table of docs/performance.md, "Reading a trace": what whole processes take to read a large trace, over
`wc -l` of the file, and the memory of their own (RssAnon) at most.

usage: scripts/reading-table.py PROGRAM [RUNS]
"""

import json
import os
import subprocess
import sys
import tempfile
import time

CALLS = ["show --last", "validate", "stats", "explain --pixel 300,300"]


def measure(words, runs):
    """The least processor time of some runs in seconds, and the most memory in MB."""
    seconds, memory = [], 0
    for _ in range(runs):
        process = subprocess.Popen(words, stdout=subprocess.DEVNULL)
        while True:
            try:
                with open(f"/proc/{process.pid}/status") as status:
                    anonymous = [line for line in status if line.startswith("RssAnon")]
                if anonymous:
                    memory = max(memory, int(anonymous[0].split()[1]) / 1024)
            except OSError:
                pass
            pid, _, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                break
            time.sleep(0.002)
        seconds.append(usage.ru_utime + usage.ru_stime)
    return min(seconds), memory


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
        lines, _ = measure(["wc", "-l", "torus.jsonl"], runs)
        print(f"{size / 1e6:.0f} MB; `wc -l`: {lines * 1000:.0f} ms\n")
        print("| | processor time | over `wc -l` | memory |\n|---|---|---|---|")
        for call in CALLS:
            seconds, memory = measure([program, *call.split(), "torus.jsonl"], runs)
            print(f"| `{call}` | {seconds:.2f} s | {seconds / lines:.0f} | {memory:.0f} MB |")


main()
