#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints what docs/performance.md tells in "Traces": the processor time of whole processes that read a trace
from a pipe, the exponent of its growth from the first number of steps that takes 50 ms or more to the last, and their
peak resident memory.

usage: scripts/pipe-table.py PROGRAM [--most STEPS] [--runs N]

STEPS is 10000000 if not given; with 100000000, a trace of 7 GB goes through each pipe.
"""

import argparse
import json
import math
import os
import subprocess
import tempfile

CALLS = ["validate -", "stats -", "show --step last -", "explain - --pixel 50,50"]
SIDE = 100


def scene_of(steps):
    """Squares over each other, of two triangles each: about so many steps."""
    corners = {"A": [0, 0], "B": [SIDE, 0], "C": [SIDE, SIDE], "D": [0, SIDE]}
    of_square = SIDE * SIDE + 2 * SIDE + 8
    return {
        "canvas": {"width": SIDE, "height": SIDE, "origin": "top-left"},
        "vertices": corners,
        "method": {"fill": "top-left"},
        "triangles": [
            {"vertices": half, "name": f"{half}{i}"} for i in range(max(1, steps // of_square)) for half in ("ABC", "ACD")
        ],
    }


def measure(program, scene, call, runs):
    """The least processor time in seconds, and the most resident memory in MB."""
    seconds, memory = math.inf, 0
    for _ in range(runs):
        writer = subprocess.Popen([program, "trace", scene], stdout=subprocess.PIPE)
        words = [program, *call.split(), "--max-steps", "200000000"]
        reader = subprocess.Popen(words, stdin=writer.stdout, stdout=subprocess.DEVNULL)
        writer.stdout.close()
        _, status, usage = os.wait4(reader.pid, 0)
        writer.wait()
        if status != 0:
            raise SystemExit(f"{' '.join(words)}: status {os.waitstatus_to_exitcode(status)}")
        seconds = min(seconds, usage.ru_utime + usage.ru_stime)
        memory = max(memory, usage.ru_maxrss / 1024)
    return seconds, memory


def main():
    options = argparse.ArgumentParser()
    options.add_argument("program")
    options.add_argument("--most", type=int, default=10_000_000)
    options.add_argument("--runs", type=int, default=3)
    given = options.parse_args()
    program = os.path.abspath(given.program)
    counts = [10**power for power in range(4, 9) if 10**power <= given.most]
    with tempfile.TemporaryDirectory() as folder:
        scenes = []
        for count in counts:
            scenes.append(os.path.join(folder, f"{count}.json"))
            with open(scenes[-1], "w") as file:
                json.dump(scene_of(count), file)
        print("| | " + " | ".join(f"10^{len(str(count)) - 1}" for count in counts) + " | exponent | peak |")
        print("|---" * (len(counts) + 3) + "|")
        for call in CALLS:
            found = [measure(program, scene, call, given.runs) for scene in scenes]
            slow = [(count, seconds) for count, (seconds, _) in zip(counts, found) if seconds >= 0.05]
            exponent = "-"
            if len(slow) > 1:
                (few, short), (many, long) = slow[0], slow[-1]
                exponent = f"{math.log(long / short) / math.log(many / few):.2f}"
            times = " | ".join(f"{seconds:.2f} s" for seconds, _ in found)
            print(f"| `{call}` | {times} | {exponent} | {max(memory for _, memory in found):.0f} MB |", flush=True)


main()
