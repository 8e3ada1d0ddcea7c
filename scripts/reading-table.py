#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the table of docs/performance.md, "Traces": the processor time that whole processes take to draw, write and read
a large trace, and the memory of their own (without the pages of files). Of two programs, if another is named: they run
by turns.

usage: scripts/reading-table.py PROGRAM [BEFORE]
"""

import json
import os
import subprocess
import sys
import tempfile
import time

RUNS = 5
CALLS = [
    "show torus.json",
    "trace torus.json -o written.jsonl",
    "show --step last torus.jsonl",
    "validate torus.jsonl",
    "stats torus.jsonl",
    "explain --pixel 300,300 torus.jsonl",
    "show head.json",
]


def run(words):
    """Processor time in seconds, and the most memory of its own in MB."""
    process = subprocess.Popen(words, stdout=subprocess.DEVNULL)
    memory = 0
    while True:
        pid, status, usage = os.wait4(process.pid, os.WNOHANG)
        if pid != 0:
            break
        try:
            with open(f"/proc/{process.pid}/status") as about:
                for line in about:
                    if line.startswith("RssAnon:"):
                        memory = max(memory, int(line.split()[1]) / 1024)
        except OSError:
            pass
        time.sleep(0.002)
    if status != 0:
        raise SystemExit(f"{' '.join(words)}: status {status}")
    return usage.ru_utime + usage.ru_stime, memory


def torus():
    return {
        "canvas": {"width": 800, "height": 800},
        "camera": {"position": [0, 2, 4]},
        "projection": {"type": "frustum", "fov_y": 60, "near": 1, "far": 20},
        "method": {"depth": "inverse-z"},
        "meshes": [{"obj": "torus.obj"}],
    }


def head():
    """A lit head of 38,080 triangles."""
    return {
        "canvas": {"width": 512, "height": 512},
        "camera": {"position": [0, 0, 4]},
        "projection": {"type": "frustum", "fov_y": 60, "near": 1, "far": 20},
        "light": {"direction": [1, 2, 3]},
        "method": {"depth": "inverse-z", "cull": "back", "shade": "lambert"},
        "meshes": [{"obj": "head.obj"}],
    }


def main():
    programs = [os.path.abspath(program) for program in sys.argv[1:3]]
    scripts = os.path.dirname(os.path.abspath(__file__))
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for name, scene, size in [("torus", torus(), ["torus", "250", "200"]), ("head", head(), ["head", "120", "160"])]:
            with open(f"{name}.obj", "w") as model:
                subprocess.run([f"{scripts}/make-models.sh", *size], stdout=model, check=True)
            with open(f"{name}.json", "w") as file:
                json.dump(scene, file)
        subprocess.run([programs[0], "trace", "torus.json", "-o", "torus.jsonl"], check=True)
        print(f"torus.jsonl: {os.path.getsize('torus.jsonl') / 1e6:.0f} MB\n")
        print("| | time | memory |" + (" before | memory | time over it |" if len(programs) > 1 else ""))
        print("|---|---|---|" + ("---|---|---|" if len(programs) > 1 else ""))
        for call in CALLS:
            runs = [[run([program, *call.split()]) for program in programs] for _ in range(RUNS)]
            least = [min(times[i][0] for times in runs) for i in range(len(programs))]
            memory = [max(times[i][1] for times in runs) for i in range(len(programs))]
            cells = "".join(f" {spent:.2f} s | {held:.0f} MB |" for spent, held in zip(least, memory))
            over = f" {least[0] / least[1]:.2f} |" if len(programs) > 1 else ""
            print(f"| `{call}` |{cells}{over}")


main()
