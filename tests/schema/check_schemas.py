#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Holds the JSON Schemas against the program's own readers, by Debian's python3-jsonschema.

    check_schemas.py PROGRAM SOURCE_FOLDER [--quick]

Whatever the program reads, the schema must accept: all examples, their traces, and thousands of scenes, claims and
steps with something changed in them. What the program refuses, the schema must refuse too, unless it cannot know: the
messages of these cases are listed here. Of many changes every third one is tried; with --quick, for a program under a sanitizer, every 30th.
"""

import copy
import glob
import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile

import jsonschema

PROGRAM, SOURCE = sys.argv[1], sys.argv[2]
EVERY = 30 if "--quick" in sys.argv[3:] else 3
failures = []


def fail(message):
    failures.append(message)


def load(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


SCHEMAS = {kind: load(os.path.join(SOURCE, "docs", kind + ".schema.json")) for kind in ("scene", "trace", "claims")}
VALIDATORS = {}
for schema_kind, schema in SCHEMAS.items():
    jsonschema.Draft7Validator.check_schema(schema)
    VALIDATORS[schema_kind] = jsonschema.Draft7Validator(schema)


def accepts(kind, value):
    return VALIDATORS[kind].is_valid(value)


def fault_by_schema(kind, value):
    """What the schema has against a value, or None. Takes much longer than accepts()."""
    error = jsonschema.exceptions.best_match(VALIDATORS[kind].iter_errors(value))
    return None if error is None else f"{list(error.absolute_path)}: {error.message[:120]}"


def faults_by_program(kind, texts, folder):
    """The first message of the program about each text, or None for a valid one."""
    found = []
    for begin in range(0, len(texts), 400):
        paths = []
        for number, text in enumerate(texts[begin:begin + 400]):
            paths.append(os.path.join(folder, f"{number}.json"))
            with open(paths[-1], "w", encoding="utf-8") as file:
                file.write(text)
        run = subprocess.run([PROGRAM, "validate", "--json", "--kind", kind] + paths, capture_output=True, text=True)
        for report in json.loads(run.stdout):
            found.append(None if report["valid"] else report["problems"][0]["message"])
    assert len(found) == len(texts)
    return found


def compare(kind, mutants, cannot_know, folder, by_schema=None):
    """Mutants are (what was changed, value). Returns how many were refused by both."""
    if len(mutants) > 100:
        mutants = mutants[::EVERY]
    texts = [as_text(kind, value) for _, value in mutants]
    refused = 0
    for (change, value), by_program in zip(mutants, faults_by_program(kind, texts, folder)):
        is_accepted = accepts(kind, value)
        if by_program is None and not is_accepted:
            fail(f"{kind}, {change}: the program reads it, the schema says {fault_by_schema(kind, value)}")
        if by_program is not None and is_accepted and not any(re.search(known, by_program) for known in cannot_know):
            fail(f"{kind}, {change}: the schema accepts it, the program says: {by_program}")
        refused += by_program is not None and not is_accepted
    return refused


def as_text(kind, value):
    """A step becomes a trace of its own."""
    if kind != "trace":
        return json.dumps(value)
    return "\n".join([HEADER, json.dumps(value), '{"end":{"steps":1}}']) + "\n"


HEADER = '{"rastertrace":1,"canvas":{"width":1024,"height":1024,"origin":"center"},"region":[0,0,0,0]}'

# --- what is right -----------------------------------------------------------------------------------------------

EXAMPLES = sorted(glob.glob(os.path.join(SOURCE, "examples", "*", "*.json")))
assert len(EXAMPLES) > 50


def sample(steps):
    """All steps of a short trace; of a long one some of each kind and with each set of fields, and some from everywhere."""
    taken = steps[:100] + steps[100::max(1, len(steps) // 50)] + list({tuple(step): step for step in steps}.values())
    for kind in {step["step"] for step in steps}:
        of_kind = [step for step in steps if step["step"] == kind]
        taken += of_kind[:3] + of_kind[-3:]
    return taken


def check_examples(folder):
    """Scenes, and their traces in both layouts. Returns the steps that were met, by kind and fields."""
    met = {}
    variants = [["--full"], ["--fill", "two-halves"], ["--fill", "barycentric"], ["--fill", "fan"],
                ["--fill", "top-left", "--scalar", "adaptive"], ["--line", "dda", "--snap", "nearest"]]
    for path in EXAMPLES:
        says = fault_by_schema("scene", load(path))
        if says:
            fail(f"{path}: {says}")
        runs = [[]] + (variants if path.endswith(("cube-culled.json", "six-spaces.json", "fan.json", "dda.json", "eight-faces.json", "arrow.json")) else [])
        for options in runs:
            texts = {}
            for layout in ("json", "jsonl"):
                run = subprocess.run([PROGRAM, "trace", path, "--frame", "1", "--format", layout] + options,
                                     capture_output=True, text=True)
                texts[layout] = run.stdout
            if run.returncode:
                if not options:
                    fail(f"{path}: {run.stderr}")
                continue
            document = json.loads(texts["json"])
            document["steps"] = sample(document["steps"])
            if not accepts("trace", document):
                fail(f"trace of {path} {options}: {fault_by_schema('trace', document)}")
            lines = texts["jsonl"].splitlines()
            for line in [lines[0], lines[1], lines[-1]]:
                if not accepts("trace", json.loads(line)):
                    fail(f"{line[:80]}: {fault_by_schema('trace', json.loads(line))}")
            for step in document["steps"]:
                met.setdefault((step["step"], tuple(step)), step)
    return met


def claims_examples():
    found = []
    for path in glob.glob(os.path.join(SOURCE, "examples", "claims", "*")):
        with open(path, encoding="utf-8") as file:
            text = file.read()
        if text.lstrip().startswith("{"):
            found.append((path, json.loads(text)))
    assert found
    return found


# --- scenes with something changed -------------------------------------------------------------------------------

FLAT = {
    "$schema": "scene.schema.json", "title": "all that is flat",
    "canvas": {"width": 17, "height": 14, "origin": "center"}, "background": "silver",
    "vertices": {"A": [2, 5], "B": ["-4", "-6/2", 1], "C": [5, -3.0, 0], "P1": [1e0, 1]},
    "colors": {"A": "red", "B": "#00ff00", "C": "#0000ff80"},
    "triangles": ["ABC", ["A", "B", "P1"], {"vertices": "ACB", "name": "roof", "color": "#ff8000"}],
    "outlines": [["A", "B", "P1"], {"vertices": ["A", "B", "C"], "name": "frame", "color": "red"}],
    "lines": ["AB", ["A", "P1"], {"vertices": "AC", "name": "ridge", "color": "red"}],
    "polygons": [["A", "B", "C", "P1"], "CBA", {"vertices": ["P1", "A", "B", "C"], "name": "ring"}],
    "circles": [{"center": "A", "radius": 5}, {"center": "P1", "radius": 0, "name": "rim", "color": "red"}],
    "points": ["A", ["P1"], {"vertices": ["P1"], "name": "dot", "color": "red"}],
    "method": {"scalar": "double", "line": "naive", "from": "first", "ends": "both", "fill": "scanline", "fill_rule": "non-zero",
               "polygon_vertices": "half-open", "fan_passes": 1, "rounding": "floor", "ties": "up", "sample": "center", "lerp": "direct",
               "snap": "none", "cull": "none", "depth": "none", "depth_compare": "auto", "depth_at": "pixel",
               "painter_key": "mean", "shade": "interpolate", "color_lerp": "axis", "color_rounding": "nearest"},
    "keep": ["depth", "canvas"],
    "vary": {"/vertices/A/0": {"from": 2, "to": "3", "steps": 2}, "/vertices/A/1": [5, "9/2"]},
}
SOLID = {
    "canvas": {"width": 20, "height": 20},
    "vertices": {"A": [0, 0, 1], "B": [1, 0, 1], "C": [0, 1, 1]},
    "triangles": ["ABC"],
    "meshes": [{"vertices": {"A": [0, 0, 0], "B": [1, 0, 0], "C": [1, 1, 0], "D": [0, 1, 0]},
                "faces": ["ABCD", ["A", "B", "C"]], "name": "plate", "color": "teal", "draw": "triangles",
                "model": [{"scale": [1, 2, 1]}, {"rotate": {"axis": [1, 1, 0], "degrees": 10}}]},
               {"obj": "tetrahedron.obj", "draw": "outlines"}],
    "model": [{"translate": [0, 0, 1]}, {"rotate": {"axis": "x", "degrees": "45/2"}},
              {"shear": {"xy": 1, "xz": 0, "yx": 0, "yz": 0, "zx": 0, "zy": 0.5}}],
    "camera": {"position": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0]},
    "projection": {"type": "frustum", "fov_y": 50, "near": 1, "far": "infinity"},
    "viewport": "fit",
    "light": {"direction": [0, 0, 1]},
    "method": {"shade": "lambert", "depth": "inverse-z"},
}


def with_parts(**parts):
    scene = copy.deepcopy(SOLID)
    del scene["meshes"], scene["model"]
    scene.update(parts)
    return scene


SCENES = [
    FLAT, SOLID,
    with_parts(projection={"type": "frustum", "left": -1, "right": 1, "bottom": -1, "top": 1, "near": 1, "far": 9}),
    with_parts(projection={"type": "orthographic", "left": -3, "right": 3, "bottom": -3, "top": 3, "near": 1, "far": 9}),
    with_parts(projection={"type": "pinhole", "distance": 1, "near": "1/10"}, camera={"position": [0, 0, -5]},
               viewport={"pixels_per_unit": 10}, light={"position": [0, 0, 4]}),
    with_parts(projection={"type": "view-plane", "distance": 2, "near": 0.1}, viewport={"pixels_per_unit": "21/2"}),
    with_parts(camera="fit", projection={"type": "orthographic", "left": -9, "right": 9, "bottom": -9, "top": 9}),
    {"vertices": {"A": [2, 5], "B": [-4, -3], "C": [5, -3]}, "triangles": ["ABC"], "projection": {"type": "none"}},
    with_parts(projection={"type": "frustum", "fov_y": 60, "near": 1, "far": 9},
               viewport={"pixels": "edges", "y": "down", "depth_range": ["1/4", 0]}, method={"depth": "ndc-z"}),
    {"canvas": {"width": 9, "height": 7}, "vertices": {"A": [2, 5, 0, 6], "B": [-4, -3, 1, "-3/2"], "C": [5, -3, 0, 5]},
     "triangles": ["ABC"], "projection": {"type": "clip-space", "z": "zero-to-one"}},
    {"canvas": {"width": 9, "height": 7}, "vertices": {"A": [0, 0], "B": [4, -3], "C": [3, 3]}, "triangles": ["ABC"],
     "convention": "cs418", "method": {"rows": "half-open", "rounding": "inside", "horizontal_edge": "bottom", "mistake": "weights-permuted,byte-cast"}},
]

# What a schema cannot know: names, sizes of numbers in relation to one another, what hangs on other keys.
SCENE_CANNOT_KNOW = [
    r"^expected the name of a vertex, found", r"^expected a name that no other (primitive|mesh|vertex) has",
    r"^expected (right|top|far) above (left|bottom|near), found", r"^expected an axis other than \[0, 0, 0\]",
    r"^expected a direction to the light that is not 0", r"^expected a camera that looks at another place",
    r"^expected an up that is not parallel", r"^expected a light for ", r"^expected a depth buffer for hidden lines",
    r"^expected a canvas (with|of)", r"^expected vertices (in|that|less)", r"^expected a rounding that lines can have",
    r"^expected ties that", r"^expected as many values as", r"^expected a key of (the scene|/)", r"^expected an index of",
    r"^expected a number at /", r"^expected the pointer to end", r"^expected a file that can be read", r"^expected a file, found a folder",
    r"^expected a field of view", r"^expected a projection that a camera can be fitted to", r"^expected a far from",
    r"^expected at least one (face|primitive), found none", r"^expected a distance above 0", r"^expected a whole number of steps",
    r"^expected an OBJ file in the scene's folder", r"^expected one of 1, 2, 3", r"^expected a number up to", r"^expected 0 or a number from",
    r"^expected two depths that differ", r"^expected a frustum, an orthographic projection", r"^expected \"depth\": ",
    r"^expected no (projection|camera|light|model|cull) beside vertices", r"^expected a vertex in clip space",
    r"^expected \"rounding\": ", r"^expected a fill by rows", r"^expected a number from 0 to 1/2", r"^expected no \"ends\"", r"^expected no coordinate beyond",
]
WRONG = [None, True, 5, -1, 0, 0.5, "x", "", "12", "1/0", "red", "#f00", "#12", "NaN", "-inf", "fit", [], {}, [[]], [1, 2, 3], {"x": 1}]


def paths_of(value, path=()):
    """Every place in a JSON value, but for the whole."""
    if path:
        yield path
    if isinstance(value, dict):
        for key in value:
            yield from paths_of(value[key], path + (key,))
    elif isinstance(value, list):
        for index in range(len(value)):
            yield from paths_of(value[index], path + (index,))


def parent_of(value, path):
    for key in path[:-1]:
        value = value[key]
    return value


def replaced(value, path, other):
    result = copy.deepcopy(value)
    parent_of(result, path)[path[-1]] = copy.deepcopy(other)
    return result


def removed(value, path):
    result = copy.deepcopy(value)
    del parent_of(result, path)[path[-1]]
    return result


def with_unknown_keys(value):
    """An unknown key in each object; not where keys are names."""
    for path in [()] + list(paths_of(value)):
        inside = value
        for key in path:
            inside = inside[key]
        if isinstance(inside, dict):
            yield path, replaced(value, path + ("wobble",), 1)


def is_varied(path):
    """The program never looks at a number in whose place `vary` types others."""
    return path[:2] == ("vertices", "A")


def mutants_of(value, wrong):
    for path in paths_of(value):
        if is_varied(path):
            continue
        for other in wrong:
            yield f"{path} = {json.dumps(other)}", replaced(value, path, other)
        yield f"no {path}", removed(value, path)
    for path, other in with_unknown_keys(value):
        yield f"wobble in {path}", other


def random_mutants(values, count):
    chance = random.Random(20220705)
    pool = WRONG + [chance.choice(values)["vertices"] for _ in range(2)] + ["A", "AB", "ABC", ["A", "B", "C"], 1e300, "1e400", -0.0]
    for number in range(count):
        base = copy.deepcopy(chance.choice(values))
        base.pop("vary", None)
        for _ in range(chance.randint(2, 4)):
            places = list(paths_of(base))
            if not places:
                break
            path = chance.choice(places)
            action = chance.randint(0, 3)
            if action == 0:
                base = removed(base, path)
            elif action == 1:
                base = replaced(base, path, chance.choice(pool))
            else: # what stands elsewhere in a scene
                other = chance.choice(values)
                from_path = chance.choice(list(paths_of(other)))
                base = replaced(base, path, parent_of(other, from_path)[from_path[-1]])
        yield f"random {number}: {json.dumps(base)[:300]}", base


def check_scenes(folder):
    with open(os.path.join(SOURCE, "examples", "models", "tetrahedron.obj"), encoding="utf-8") as file:
        obj = file.read()
    with open(os.path.join(folder, "tetrahedron.obj"), "w", encoding="utf-8") as file:
        file.write(obj)
    right = [("as it is", scene) for scene in SCENES]
    assert compare("scene", right, [], folder) == 0
    for _, message in zip(SCENES, faults_by_program("scene", [json.dumps(scene) for scene in SCENES], folder)):
        if message:
            fail("a scene of this test is wrong: " + message)
    mutants = [mutant for scene in SCENES[:1] for mutant in mutants_of(scene, WRONG)]
    mutants += [mutant for scene in SCENES[1:] for mutant in mutants_of(scene, WRONG[::4])]
    refused = compare("scene", mutants, SCENE_CANNOT_KNOW, folder)
    print(f"{len(mutants)} scenes with one thing changed: {refused} refused by both")
    assert refused > len(mutants) // 2 // EVERY
    mutants = list(random_mutants(SCENES, 1000))
    refused = compare("scene", mutants, SCENE_CANNOT_KNOW, folder)
    print(f"{len(mutants)} random scenes: {refused} refused by both")


def check_all_keys_are_met():
    """Every key of the schema of scenes stands in a scene of this test."""
    keys = {str(key) for scene in SCENES for path in paths_of(scene) for key in path}

    def properties(node):
        if isinstance(node, dict):
            yield from node.get("properties", {})
            for value in node.values():
                yield from properties(value)
        elif isinstance(node, list):
            for value in node:
                yield from properties(value)
    for key in set(properties(SCHEMAS["scene"])) - keys:
        fail(f"no scene of this test has the key {key}")


# --- claims and steps with something changed ---------------------------------------------------------------------

CLAIMS = {
    "$schema": "claims.schema.json", "round": "nearest",
    "claims": [
        {"step": "scanline", "y": 2, "left": "-1/4", "right": None, "from": -1, "in": "ABC"},
        {"step": "pixel", "x": 3, "y": "2", "plotted": True, "color": "red", "z": "10/3"},
        {"step": "vertex", "name": "A", "space": "screen", "at": [2, "?"]},
        {"step": "matrix", "name": "view", "rows": [[1, 0, 0, 0], [0, None, 0, 0]]},
        {"step": "edge", "edge": "AC", "dx_dy": "?"},
        {"step": "decide", "x": 0, "y": 0, "d": [-1, 3]},
        {"step": "decide", "x": 0, "y": 0, "d": 1, "move": "E"},
        {"step": "clip", "name": "ABC", "plane": "near", "inside": [True, "false", "?"]},
        {"step": "order", "names": ["ABC", "ACD"]},
        {"picture": ["..#", "?##"]},
    ],
}
CLAIMS_CANNOT_KNOW = [r"^expected a row of \d+ pixels like the first one", r"^expected a whole number, found \"", r"^expected a field of view"]

TRACE_CANNOT_KNOW = [r"^expected pixels on the canvas"]


def check_claims(folder):
    for path, claims in claims_examples():
        says = fault_by_schema("claims", claims)
        if says:
            fail(f"{path}: {says}")
        claims.pop("scene", None)
        mutants = list(mutants_of(claims, WRONG))
        compare("claims", mutants, CLAIMS_CANNOT_KNOW, folder)
    if fault_by_schema("claims", CLAIMS) or faults_by_program("claims", [json.dumps(CLAIMS)], folder)[0]:
        fail("the claims of this test are wrong")
    wrong = [value for value in WRONG if value is not None]
    mutants = list(mutants_of(CLAIMS, wrong))
    refused = compare("claims", mutants, CLAIMS_CANNOT_KNOW, folder)
    print(f"{len(mutants)} claims with one thing changed: {refused} refused by both")
    assert refused > len(mutants) // 2 // EVERY


def check_steps(met, folder):
    """Each field of each kind, where it stands in some trace."""
    fields = {}
    for step in met.values():
        for field in step:
            fields.setdefault((step["step"], field), step)
    for name, definition in SCHEMAS["trace"]["definitions"].items():
        for field in definition.get("properties", {}) if name.startswith("step-") else []:
            if (name[len("step-"):], field) not in fields and (name, field) not in RARE_FIELDS:
                fail(f"no trace of this test has the field {field} of {name}")
    mutants = []
    for (_, field), step in sorted(fields.items()):
        mutants += [(f"{field} = {json.dumps(other)} in {json.dumps(step)}", replaced(step, (field,), other)) for other in WRONG
                    if not (field == "step" and isinstance(other, str))]
        mutants.append((f"no {field} in {json.dumps(step)}", removed(step, (field,))))
        mutants.append((f"wobble in {json.dumps(step)}", replaced(step, ("wobble",), 1)))
    mutants.append(("an unknown kind", {"step": "wobble", "x": "y"}))
    refused = compare("trace", mutants, TRACE_CANNOT_KNOW, folder)
    print(f"{len(mutants)} steps with one thing changed: {refused} refused by both")
    assert refused > len(mutants) // 4 // EVERY


# Fields of steps that only numbers beyond double, or hidden lines next to faces, bring about.
RARE_FIELDS = {("step-depth", "beside"), ("step-undecided", "difference"), ("step-undecided", "error")}


def check_headers(folder):
    """Keys of the header and of the end record."""
    document = {"rastertrace": 1, "title": "t", "canvas": {"width": 3, "height": 2, "origin": "center"},
                "background": "red", "method": {"scalar": "double", "fan_passes": 1}, "numbers": "n",
                "projection": "none", "viewport": "none", "matrices": "m",
                "stages": [{"stage": "clip", "plane": "near", "kept": True, "why": "w"}], "only": ["pixel"],
                "region": [0, 0, 1, 1], "primitive": "ABC", "steps": [],
                "end": {"steps": 0, "count": {"pixel": 0}, "pixels": 4, "frame": "0123456789abcdef"}}
    header = SCHEMAS["trace"]["definitions"]["header-line"]["properties"]
    for key in set(header) ^ (set(document) - {"steps", "end"}):
        fail(f"the header of this test and the schema differ in {key}")
    mutants = ([("as it is", document)] + list(mutants_of(document, WRONG)))[::EVERY]
    texts = [json.dumps(value) for _, value in mutants]
    refused = 0
    for (change, value), by_program in zip(mutants, faults_by_program("trace", texts, folder)):
        is_accepted = accepts("trace", value)
        # A document without steps is the header of JSON Lines, one without a version an end record.
        known = by_program is not None and re.search(
            r"as the end record says|^expected a canvas of at most|truncated after 0 whole steps|^expected a trace, found a scene", by_program)
        if is_accepted != (by_program is None) and not known:
            fail(f"header, {change}: the program says {by_program}, the schema {fault_by_schema('trace', value)}")
        refused += by_program is not None and not is_accepted
    print(f"{len(mutants)} headers with one thing changed: {refused} refused by both")
    assert refused > len(mutants) // 2 // EVERY


def check_marks(folder):
    """What the programs in docs/for-teachers.md write for Gradescope and PrairieLearn is as these say."""
    page = open(os.path.join(SOURCE, "docs", "for-teachers.md"), encoding="utf-8").read()
    programs = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    assert len(programs) == 2
    scene = os.path.join(SOURCE, "examples", "t0-fill", "first-triangle.json")
    for place in ("source", "submission", "results", "tests", "student"):
        os.mkdir(os.path.join(folder, place))
    for place in ("source", "tests"):
        shutil.copy(scene, os.path.join(folder, place, "scene.json"))
    with open(os.path.join(folder, "submission_metadata.json"), "w", encoding="utf-8") as file:
        json.dump({"users": [{"sid": "4711"}]}, file)
    os.symlink(PROGRAM, os.path.join(folder, "rastertrace"))
    environment = {**os.environ, "PATH": folder + os.pathsep + os.environ["PATH"]}
    sheet = subprocess.run([PROGRAM, "sheet", scene, "--seed", "4711"], capture_output=True, text=True).stdout
    tests = 0
    for text in (sheet, sheet.replace("edge AB: ?", "edge AB: 77"), sheet.replace("4711", "4712"), "y=2: 1/4\n", "y=2: x\n"):
        for place in ("submission", "student"):
            with open(os.path.join(folder, place, "sheet.txt"), "w", encoding="utf-8") as file:
                file.write(text)
        for system, program in zip(("gradescope", "prairielearn"), programs):
            program = program.replace('"/autograder/"', repr(folder + "/")).replace('"/grade/', f'"{folder}/')
            subprocess.run([sys.executable, "-c", program], env=environment, check=True)
            schema = load(os.path.join(SOURCE, "tests", "schema", system + ".schema.json"))
            jsonschema.Draft7Validator.check_schema(schema)
            results = load(os.path.join(folder, "results", "results.json"))
            error = jsonschema.exceptions.best_match(jsonschema.Draft7Validator(schema).iter_errors(results))
            if error is not None:
                fail(f"{system}, {text}: {list(error.absolute_path)}: {error.message[:120]}")
            tests += len(results.get("tests", []))
    print(f"{tests} tests for Gradescope and PrairieLearn")
    assert tests > 0


def main():
    with tempfile.TemporaryDirectory() as folder:
        met = check_examples(folder)
        check_scenes(folder)
        check_all_keys_are_met()
        check_claims(folder)
        check_steps(met, folder)
        check_headers(folder)
        check_marks(folder)
    for message in failures[:40]:
        print(message)
    if failures:
        print(f"{len(failures)} failures")
    return 1 if failures else 0


sys.exit(main())
