# SPDX-License-Identifier: MIT
"""check_page.py PAGE PROGRAM SOURCE [--write]: runs the shell commands on a page, in a folder of their own beside the
project's. What a block ```sh prints has to be the block ```text behind it, if there is one; --write puts it there."""
import os
import re
import subprocess
import sys
import tempfile

page, program, source = (os.path.abspath(path) for path in sys.argv[1:4])
text = open(page).read()
blocks = re.compile(r"```sh\n(.*?)```\n(?:\n```text\n(.*?)```\n)?", re.DOTALL)
failed = 0
with tempfile.TemporaryDirectory() as folder:
    for name in ("examples", "trace"):
        os.symlink(os.path.join(source, name), os.path.join(folder, name))
    environment = dict(os.environ, PATH=os.path.dirname(program) + os.pathsep + os.environ["PATH"], LC_ALL="C",
                       PYTHONDONTWRITEBYTECODE="1")

    def run(block):
        global failed
        commands, expected = block.groups()
        ran = subprocess.run(["sh", "-c", commands], cwd=folder, env=environment, capture_output=True, text=True)
        told = ran.stdout
        if expected is not None and told != expected and "--write" not in sys.argv:
            print(f"{page}: {commands}expected:\n{expected}found:\n{told}{ran.stderr}")
            failed += 1
        if expected is None:
            return block.group(0)
        return f"```sh\n{commands}```\n\n```text\n{told}```\n"

    found = len(blocks.findall(text))
    if found < 5:
        print(f"{page}: expected five blocks of commands at least, found {found}")
        failed += 1
    written = blocks.sub(run, text)
if "--write" in sys.argv:
    open(page, "w").write(written)
sys.exit(1 if failed else 0)
