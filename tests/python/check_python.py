#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The module of viewer-cli/python with the program itself: alone, as docs/python.md uses it, and in a notebook.

    check_python.py PROGRAM SOURCE_FOLDER [TEST...]   # a TEST is a name of unittest, like Rows

Needs Debian's python3-nbconvert and python3-ipykernel.
"""

import doctest
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
import warnings
import xml.etree.ElementTree
from fractions import Fraction

import nbformat

PROGRAM, SOURCE = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
MODULE = SOURCE / "viewer-cli/python/rastertrace.py"
sys.dont_write_bytecode = True
sys.path.insert(0, str(MODULE.parent))

import rastertrace  # noqa: E402, of the folder above
from rastertrace import Problem, Trace  # noqa: E402

FIRST = "examples/t0-fill/first-triangle.json"
FIRST_AS_DICTIONARY = {"canvas": {"width": 17, "height": 14}, "vertices": {"A": [2, 5], "B": [-4, -3], "C": [5, -3]},
                       "triangles": ["ABC"], "method": {"scalar": "exact"}}


class InFolder(unittest.TestCase):
    """In a folder of its own that has the examples, with the program in the variable RASTERTRACE."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        os.symlink(SOURCE / "examples", "examples")
        environment = unittest.mock.patch.dict(os.environ, {"RASTERTRACE": str(PROGRAM), "RASTERTRACE_LANGUAGE": "en"})
        environment.start()
        self.addCleanup(environment.stop)

    @staticmethod
    def text_of(name):
        return pathlib.Path(name).read_text(encoding="utf-8")

    def problem_of(self, ask, *words, **options):
        with self.assertRaises(Problem) as caught:
            ask(*words, **options)
        return str(caught.exception)


class Rows(InFolder):
    """The first triangle, as T0 works it out; the numbers of rows that T0 leaves out follow from its two edges."""

    # y, both ends of the row, its pixels
    ROWS = [(5, "2", "2", 2, 2), (4, "5/4", "19/8", 1, 2), (3, "1/2", "11/4", 0, 2), (2, "-1/4", "25/8", -1, 3),
            (1, "-1", "7/2", -1, 3), (0, "-7/4", "31/8", -2, 3), (-1, "-5/2", "17/4", -3, 4),
            (-2, "-13/4", "37/8", -4, 4), (-3, "-4", "5", -4, 5)]

    def test_rows_are_those_of_the_text(self):
        rows = [(step["y"], step["left"], step["right"], step["from"], step["to"])
                for step in Trace(FIRST) if step["step"] == "scanline"]
        self.assertEqual(rows, self.ROWS)

    def test_ends_are_fractions_of_the_two_edges(self):
        for row in Trace(FIRST).select("scanline"):
            self.assertEqual(Fraction(row["left"]), Fraction(3 * row["y"] - 7, 4))
            self.assertEqual(Fraction(row["right"]), Fraction(31 - 3 * row["y"], 8))

    def test_each_rounding_draws_the_pixels_counted_by_hand(self):
        for rounding, pixels in ("floor", 49), ("nearest", 49), ("truncate", 45), ("inside", 43), ("half-open", 41):
            trace = Trace(FIRST, rounding=rounding)
            self.assertEqual(len(trace.select("pixel")), pixels, rounding)
            self.assertEqual(trace.end["pixels"], pixels, rounding)
            self.assertEqual(trace.header["method"]["rounding"], rounding)


class Traces(InFolder):
    def test_a_dictionary_is_drawn_like_its_file(self):
        self.assertEqual(list(Trace(FIRST_AS_DICTIONARY)), list(Trace(pathlib.Path(FIRST))))

    def test_a_dictionary_may_have_fractions(self):
        scene = {**FIRST_AS_DICTIONARY, "vertices": {"A": [Fraction(7, 3), 5], "B": [-4, -3], "C": [5, -3]}}
        self.assertEqual(Trace(scene)[0]["at"][0], ["7/3", "5"])

    def test_a_trace_is_a_sequence_in_the_order_of_the_program(self):
        trace = Trace(FIRST)
        table = trace.ask("show", every="scanline", format="csv").text.splitlines()
        numbers = [int(line.split(",")[0]) for line in table[1:]]
        self.assertEqual(numbers, [number for number, step in enumerate(trace, 1) if step["step"] == "scanline"])
        self.assertEqual(trace.end["steps"], len(trace))
        self.assertEqual(trace[-1], trace[len(trace) - 1])
        self.assertEqual(trace[:2], [trace[0], trace[1]])
        self.assertEqual(repr(trace), f"<rastertrace.Trace of {trace.end['steps']} steps>")

    def test_a_trace_of_another_renderer_is_read(self):
        file = "examples/regression/fast.jsonl"
        trace = Trace(file)
        self.assertEqual(len(trace), len(self.text_of(file).splitlines()) - 2)  # header, end record
        self.assertNotIn("steps", trace.header)
        self.assertTrue(trace.figure().svg.startswith("<svg"))

    def test_select_takes_the_words_of_the_program(self):
        trace = Trace(FIRST)
        self.assertEqual(trace.select("edge dx_dy=null"), [{"step": "edge", "edge": "BC", "dx_dy": None}])
        self.assertEqual(trace.select("pixel in=ABC"), [step for step in trace if step["step"] == "pixel"])
        self.assertIn("did you mean", self.problem_of(trace.select, "scanlines"))


class Options(InFolder):
    def test_an_underscore_stands_for_a_hyphen_and_leaves_a_keyword_alone(self):
        scene = {"vertices": {"A": [4, 1], "B": [0, 0], "C": [0, 4]}, "triangles": ["ABC"], "lines": ["AB"]}
        method = Trace(scene, from_="low", fill="fan", fan_passes=2)
        self.assertEqual(method.header["method"]["from"], "low")
        self.assertEqual(method.header["method"]["fan_passes"], 2)

    def test_a_tuple_is_one_value_and_a_list_several(self):
        trace = Trace(FIRST)
        self.assertEqual(trace.figure(region=(0, 1, 3, 3)).svg, trace.figure(region="0,1,3,3").svg)
        svg = trace.figure(note=["3,2: here", "0,0: and there"]).svg
        self.assertIn("here", svg)
        self.assertIn("and there", svg)

    def test_true_is_an_option_without_value_and_false_and_none_are_no_option(self):
        trace = Trace(FIRST)
        plain = trace.figure().svg
        self.assertNotEqual(trace.figure(bare=True).svg, plain)
        self.assertEqual(trace.figure(bare=False, step=None).svg, plain)
        self.assertNotEqual(trace.figure(step=0).svg, plain)  # 0 is a value
        wrong = "y=2: 0, 25/8"  # --hint is an option that may have a value
        self.assertEqual(str(trace.check(wrong, hint=True)), str(trace.check(wrong, hint=1)))
        self.assertNotEqual(str(trace.check(wrong, hint=True)), str(trace.check(wrong)))
        self.assertEqual(str(trace.check(wrong, hint=False)), str(trace.check(wrong)))

    def test_the_method_of_the_trace_holds_for_what_is_asked(self):
        trace = Trace(FIRST_AS_DICTIONARY, rounding="truncate")
        self.assertIn("not drawn", str(trace.explain(pixel=(-1, 2))))
        self.assertTrue(trace.check("y=2: -1/4, 25/8 -> 0..3"))
        self.assertNotEqual(trace.figure(step="scanline y=2").svg, Trace(FIRST).figure(step="scanline y=2").svg)


class Answers(InFolder):
    def test_what_was_worked_out_right_is_true(self):
        answer = Trace(FIRST).check(self.text_of("examples/claims/t0-rows.claims"))
        self.assertIs(bool(answer), True)
        self.assertEqual(str(answer), "4 right, 0 wrong")

    def test_what_was_worked_out_wrong_is_false_and_told(self):
        answer = Trace(FIRST_AS_DICTIONARY).check("y=2: 0, 25/8 -> 0..3")
        self.assertIs(bool(answer), False)
        self.assertTrue(str(answer).startswith("claims:1: y=2: 0, 25/8 -> 0..3\n"), answer)
        self.assertIn("expected -1/4, found 0", str(answer))

    def test_claims_that_cannot_be_read_are_a_problem_at_a_line(self):
        message = self.problem_of(Trace(FIRST).check, "xyzzy 7")
        self.assertTrue(message.startswith("claims:1:7: expected a space"), message)

    def test_equal_traces_are_true(self):
        answer = Trace(FIRST).diff(Trace(FIRST))
        self.assertIs(bool(answer), True)

    def test_traces_that_differ_are_false_and_the_first_difference_is_told(self):
        answer = Trace(FIRST).diff(Trace(FIRST_AS_DICTIONARY, rounding="truncate"), json=True)
        self.assertIs(bool(answer), False)
        self.assertEqual((answer.data["a"], answer.data["b"]), ("a.json", "b.json"))
        # The row y = 2 begins at -1/4, which is the first end below 0 that is no whole number.
        self.assertEqual(answer.data["first"]["a"]["step"]["y"], 2)
        self.assertEqual(answer.data["first"]["fields"], [{"field": "from", "a": -1, "b": 0, "distance": 1}])
        self.assertEqual(answer.data["picture"]["only_a"], 49 - 45)

    def test_options_of_diff_are_those_of_the_command(self):
        truncated = Trace(FIRST, rounding="truncate")
        self.assertTrue(Trace(FIRST).diff(truncated, ignore="scanline.from,pixel,header"))


class Figures(InFolder):
    def test_a_figure_is_its_svg(self):
        figure = Trace(FIRST).figure(step="scanline y=2")
        self.assertEqual(xml.etree.ElementTree.fromstring(figure.svg).tag, "{http://www.w3.org/2000/svg}svg")
        self.assertIn("scanline y=2", figure.svg)
        self.assertEqual(figure._repr_svg_(), figure.svg)
        player = Trace(FIRST).player(step=14)
        self.assertTrue(player.html.startswith("<!doctype html>"))
        self.assertRegex(player._repr_html_(), r'^<iframe srcdoc="&lt;!doctype html&gt;[^<>"]*" title=')

    def test_a_figure_is_saved_with_its_options_in_the_format_of_the_name(self):
        figure = Trace(FIRST_AS_DICTIONARY, rounding="truncate").figure(step="scanline y=2")
        figure.save("row.svg")
        self.assertEqual(self.text_of("row.svg"), figure.svg)
        for name, begin in ("row.png", b"\x89PNG"), ("row.tex", b"%"), ("row.html", b"<!"):
            figure.save(pathlib.Path(name))
            self.assertEqual(pathlib.Path(name).read_bytes()[:len(begin)], begin, name)
        small = pathlib.Path("row.png").stat().st_size
        figure.save("row.png", scale=6)
        self.assertGreater(pathlib.Path("row.png").stat().st_size, small)


class Problems(InFolder):
    def test_a_scene_that_is_wrong_is_told_with_line_and_column(self):
        pathlib.Path("bad.json").write_text('{"vertices": {"A": [2, 5]},\n "triangles": 3}', encoding="utf-8")
        self.assertEqual(self.problem_of(Trace, "bad.json"),
                         'bad.json:2:15: expected a list of triangles, like ["ABC"], found 3\n'
                         ' "triangles": 3}\n'
                         '              ^')

    def test_a_dictionary_that_is_wrong_is_told_as_standard_input(self):
        self.assertTrue(self.problem_of(Trace, {"triangles": 3}).startswith("standard input:1:15: expected a list"))

    def test_words_of_the_command_line_are_told(self):
        self.assertIn("did you mean scanline?", self.problem_of(Trace, FIRST, fill="scanlin"))
        self.assertIn("no such option", self.problem_of(Trace, FIRST, filling="scanline"))
        self.assertIn("nosuch.json: expected a file", self.problem_of(Trace, "nosuch.json"))
        self.assertIn("(x -8 to 8, y -6 to 7)", self.problem_of(Trace(FIRST).explain, pixel=(40, 2)))
        self.assertIn("--step", self.problem_of(Trace(FIRST).figure, step=99))

    def test_a_trace_that_breaks_off_is_a_problem(self):
        lines = self.text_of("examples/regression/fast.jsonl").splitlines(keepends=True)
        pathlib.Path("broken.jsonl").write_text("".join(lines[:5]), encoding="utf-8")
        self.assertIn("truncated after 4 whole steps", self.problem_of(Trace, "broken.jsonl"))

    def test_a_program_that_crashes_is_a_problem(self):
        pathlib.Path("crash").write_text("#!/bin/sh\nkill -9 $$\n", encoding="utf-8")
        os.chmod("crash", 0o755)
        os.environ["RASTERTRACE"] = "./crash"
        self.assertEqual(self.problem_of(Trace, FIRST), "trace ended with status -9")

    def test_a_remark_is_a_warning(self):
        scene = {**FIRST_AS_DICTIONARY, "camera": {"position": [0, 0, 5]}}
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            Trace(scene)
        self.assertEqual(len(caught), 1)
        self.assertIn("projection", str(caught[0].message))


class Program(InFolder):
    """Which program is run, in processes of their own: what counts is where the module lies."""

    def program_of(self, module, **environment):
        return subprocess.run([sys.executable, "-Bc", "import rastertrace; print(rastertrace.program())"],
                              env={"PYTHONPATH": str(module.parent), **environment}, capture_output=True, text=True)

    @staticmethod
    def executable(name):
        path = pathlib.Path(name).absolute()
        path.parent.mkdir(parents=True)
        path.symlink_to(PROGRAM)
        return path

    def setUp(self):
        super().setUp()
        self.module = pathlib.Path("prefix/share/rastertrace/rastertrace.py").absolute()
        self.module.parent.mkdir(parents=True)
        shutil.copy(MODULE, self.module)

    def test_the_variable_comes_before_the_installation_and_that_before_the_path(self):
        on_path = self.executable("path/rastertrace")
        environment = {"PATH": str(on_path.parent)}
        self.assertEqual(self.program_of(self.module, **environment).stdout, f"{on_path}\n")
        installed = self.executable("prefix/bin/rastertrace")
        self.assertEqual(self.program_of(self.module, **environment).stdout, f"{installed}\n")
        named = self.executable("named/mine")
        self.assertEqual(self.program_of(self.module, RASTERTRACE=str(named), **environment).stdout, f"{named}\n")

    def test_a_program_that_is_not_there_is_told_with_where_it_was_looked_for(self):
        error = self.program_of(self.module, PATH="").stderr
        self.assertIn("FileNotFoundError: expected the program as", error)
        self.assertIn("prefix/bin/rastertrace, on the PATH or in RASTERTRACE, found none", error)
        error = self.program_of(self.module, PATH="", RASTERTRACE="/nowhere/mine").stderr
        self.assertIn("expected the program as /nowhere/mine, which RASTERTRACE says, found none", error)


class Documentation(InFolder):
    def blocks_of_page(self):
        """Each block of Python in docs/python.md, with the block of text below it: what it prints."""
        page = self.text_of(SOURCE / "docs/python.md")
        blocks = re.findall(r"^```python\n(.*?)^```\n(?:```text\n(.*?)^```\n)?", page, re.DOTALL | re.MULTILINE)
        self.assertEqual(len(blocks), page.count("```python"))
        self.assertEqual(sum(bool(printed) for _, printed in blocks), page.count("```text"))
        return blocks

    def test_examples_in_the_module_are_true(self):
        failed, tried = doctest.testmod(rastertrace)
        self.assertEqual(failed, 0)
        self.assertGreater(tried, 0)

    def test_each_public_name_has_an_example(self):
        names = {name: getattr(rastertrace, name) for name in rastertrace.__all__}
        for owner in rastertrace.Answer, rastertrace.Figure, Trace:
            names.update({f"{owner.__name__}.{name}": part for name, part in vars(owner).items() if name[0] != "_"})
        self.assertIn("Trace.explain", names)
        for name, what in names.items():
            self.assertRegex(what.__doc__, r"\w\(.*\)|: str\(problem\)", name)

    def test_the_page_as_a_notebook_prints_what_it_says_and_shows_its_figure(self):
        blocks = self.blocks_of_page()
        book = nbformat.v4.new_notebook()
        book.cells = [nbformat.v4.new_code_cell(code) for code, _ in blocks]
        book.cells.append(nbformat.v4.new_code_cell("trace[13]"))
        book.cells.append(nbformat.v4.new_code_cell("type(trace[13]), trace.check('y=2: 0, 25/8', no_answers=True)"))
        os.environ.update({"PYTHONPATH": str(MODULE.parent), "PYTHONDONTWRITEBYTECODE": "1", "HOME": os.getcwd(),
                           "PYDEVD_DISABLE_FILE_VALIDATION": "1"})  # no warnings about a debugger
        nbformat.write(book, "page.ipynb")
        command = [sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute", "--inplace", "page.ipynb"]
        done = subprocess.run(command, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        book = nbformat.read("page.ipynb", as_version=4)

        for (code, printed), cell in zip(blocks, book.cells):
            stdout = "".join(output["text"] for output in cell.outputs if output.output_type == "stream")
            self.assertEqual(stdout, printed, code)
        figures = [output["data"] for cell in book.cells for output in cell.outputs
                   if output.output_type == "execute_result" and "image/svg+xml" in output["data"]]
        self.assertEqual(len(figures), 1)
        self.assertEqual(figures[0]["image/svg+xml"].rstrip("\n"), self.text_of("row.svg").rstrip("\n"))
        step, kind = (cell.outputs[0]["data"]["text/plain"] for cell in book.cells[-2:])
        self.assertEqual(step.split(",")[0], "{'step': 'scanline'")
        self.assertRegex(kind, r"^\(dict,\s+claims:1: y=2: 0, 25/8: wrong\n")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
