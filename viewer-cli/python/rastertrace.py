# SPDX-License-Identifier: MIT
"""The program rastertrace in Python: steps as dictionaries, figures for notebooks, answers as text.

    >>> import rastertrace
    >>> trace = rastertrace.Trace("examples/t0-fill/first-triangle.json", rounding="truncate")
    >>> trace.select("scanline y=2")[0]["from"], trace.end["pixels"]
    (0, 45)

Options of the program are keyword arguments: fill_rule="non-zero" is --fill-rule non-zero. With True an option has no
value; with False or None it is left out. A tuple is joined by commas: pixel=(4, 2). A list gives the option once for
each of its values. A name that is a keyword of Python gets an underscore: with_="order".
"""
import collections.abc
import html
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import warnings

__all__ = ["Answer", "Figure", "Player", "Problem", "Trace", "program", "run"]


class Problem(Exception):
    """Why the program could not answer, as it says it: str(problem) is "first.json:3:5: expected ..., found ..."."""


class Answer:
    """What the program printed: `text`. False if it found a difference or a wrong claim: bool(trace.check(claims))."""

    def __init__(self, text, is_fine):
        self.text, self._is_fine = text, is_fine

    def __bool__(self):
        return self._is_fine

    def __repr__(self):
        return self.text.rstrip("\n")

    @property
    def data(self):
        """An answer in JSON as dictionaries and lists: trace.explain(pixel=(4, 2), json=True).data["answer"]."""
        return json.loads(self.text)


def program():
    """The path of the program: by RASTERTRACE, else PREFIX/bin/rastertrace, else the first on PATH: program()."""
    named = os.environ.get("RASTERTRACE")
    installed = os.path.normpath(pathlib.Path(__file__).resolve().parent / "../../bin/rastertrace")
    path = shutil.which(named) if named else shutil.which(installed) or shutil.which("rastertrace")
    if path is None:
        places = f"as {named}, which RASTERTRACE says" if named else f"as {installed}, on the PATH or in RASTERTRACE"
        raise FileNotFoundError(f"expected the program {places}, found none")
    return path


def run(command, *words, stdin="", _hide="", **options):
    """The Answer to any command: run("check", "anna.txt", json=True)."""
    arguments = [program(), command, *words]
    for name, given in options.items():
        option = "--" + name.rstrip("_").replace("_", "-")
        for value in given if isinstance(given, list) else [given]:
            text = ",".join(map(str, value)) if isinstance(value, tuple) else value
            if value is not None and value is not False:  # 0 is a value
                arguments.append(option if value is True else f"{option}={text}")
    # _hide, the path of a temporary folder, is left out of texts: messages then begin with the name of the file.
    done = subprocess.run(arguments, input=stdin, capture_output=True, encoding="utf-8")
    message = done.stderr.replace(_hide, "").removeprefix("rastertrace: ").rstrip("\n")
    if done.returncode not in (0, 1):
        raise Problem(message or f"{command} ended with status {done.returncode}")
    if message:
        warnings.warn(message)
    return Answer(done.stdout.replace(_hide, ""), done.returncode == 0)


class Trace(collections.abc.Sequence):
    """The steps of a scene as dictionaries, with `header` and `end`. trace[0] is what the program calls step 1.

    The scene is a file, or a dictionary of what such a file holds; a trace will do as well. The options are those of
    its method. A figure and an answer draw the scene anew: when its file has changed, make a new Trace.

    >>> trace = Trace({"vertices": {"A": [0, 0], "B": [5, 2]}, "lines": ["AB"]}, line="dda", scalar="exact")
    >>> [step["value"] for step in trace if step["step"] == "along"]
    ['0', '2/5', '4/5', '6/5', '8/5', '2']
    """

    def __init__(self, scene, **method):
        is_file = isinstance(scene, (str, os.PathLike))
        self._file, self._text = (scene, "") if is_file else ("-", json.dumps(scene, default=str))  # Fraction: "1/3"
        self._method = method
        self.header = self.ask("trace", format="json").data
        self._steps, self.end = self.header.pop("steps"), self.header.pop("end")

    def __len__(self):
        return len(self._steps)

    def __getitem__(self, index):
        return self._steps[index]

    def __repr__(self):
        return f"<rastertrace.Trace of {len(self)} steps>"

    def ask(self, command, *words, **options):
        """The Answer of any command that takes a scene: trace.ask("trace", output="first.trace.json")."""
        return run(command, self._file, *words, stdin=self._text, **{**self._method, **options})

    def select(self, steps):
        """The list of the steps that --every of the program would take: trace.select("scanline y=2")."""
        return self.ask("show", every=steps, json=True).data

    def figure(self, **options):
        """The Figure with these options of `rastertrace figure`: trace.figure(step="scanline y=2", with_="order")."""
        return Figure(self, options)

    def player(self, **options):
        """The Player with these options of `rastertrace figure`: trace.player(step=14)."""
        return Player(self, options)

    def explain(self, **question):
        """Why a pixel, a row, an edge, ... is as it is: trace.explain(pixel=(4, 2))."""
        return self.ask("explain", **question)

    def check(self, claims, **options):
        """Which lines of a worked example are wrong, and why: trace.check("y=2: -1/4, 25/8 -> -1..3", hint=1)."""
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "claims")
            file.write_text(claims, encoding="utf-8")
            return self.ask("check", file, _hide=folder + os.sep, **options)

    def diff(self, other, **options):
        """What another Trace decides differently: trace.diff(Trace("first.json", scalar="float"), ignore="header")."""
        with tempfile.TemporaryDirectory() as folder:
            a, b = (pathlib.Path(folder, name) for name in ("a.json", "b.json"))
            self.ask("trace", output=a)
            other.ask("trace", output=b)
            return run("diff", a, b, _hide=folder + os.sep, **options)


class Figure:
    """A figure, which a notebook shows: trace.figure(step=14). Its text is `svg`."""

    def __init__(self, trace, options):
        self._trace, self._options = trace, options
        self.svg = trace.ask("figure", format="svg", output="-", **options).text

    def _repr_svg_(self):
        return self.svg

    def save(self, path, **options):
        """Writes it in the format that the file's name ends in, with more options: figure.save("row.png", scale=4)."""
        self._trace.ask("figure", output=path, **{**self._options, **options})


class Player:
    """A page to click through, which a notebook shows in a frame: trace.player(). Its text is `html`."""

    def __init__(self, trace, options):
        self.html = trace.ask("figure", format="html", output="-", **options).text

    def _repr_html_(self):
        return f'<iframe srcdoc="{html.escape(self.html)}" title="Player" width="100%" height="800"></iframe>'
