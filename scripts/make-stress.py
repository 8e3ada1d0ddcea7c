#!/usr/bin/env python3
"""Writes the entries between the marks of docs/stress.md anew, from a run of the cases. With --check it only says
whether they are what the program writes. Takes seconds; the same on every machine.

    scripts/make-stress.py [--check] [PROGRAM]
"""
import difflib
import itertools
import json
import pathlib
import re
import subprocess
import sys


def in_page(text):
    """Text in a line of a page, as it is: what stands between backquotes is code already."""
    parts = text.split("`")
    for i in range(0, len(parts), 2):
        parts[i] = re.sub(r"([*_\\]|\](?=[(\[]))", r"\\\1", parts[i].replace("&", "&amp;").replace("<", "&lt;"))
    return "`".join(parts)


def in_item(text):
    """The same where a line or an item of a list begins: it begins no item of a list, and no heading."""
    return re.sub(r"^(?:(\d+)(?=[.)](?: |$))|(?=[-+#>]))", r"\1\\", in_page(text))


def as_sentence(text):
    """A text as a sentence: its first word gets a capital, unless a formula begins it."""
    if re.match(r"a [A-Za-z]|[A-Za-z]{2,}($|[ ,:]([^=.]|$))", text):
        text = text[0].upper() + text[1:]
    return in_item(text if re.search(r"\.\)?$", text) else text + ".")


def anchor_of(heading):
    return re.sub(r"[^a-z0-9_-]", "", heading.lower().replace(" ", "-"))


def error_of(row):
    """ "590 rows wrong, at most 0.024 px" """
    if row["verdict"] == "refused":
        return "refused"
    parts = []
    if row["wrong"] and row["unit"]:
        parts.append(f"{row['wrong']} {row['unit']}{'' if row['wrong'] == 1 else 's'} wrong")
    if "worst_unit" in row:
        # As many digits as are documented.
        digits = len(re.sub(r"e.*|\D", "", str(row["documented"].get("worst", "12"))).lstrip("0")) or 1
        parts.append(f"at most {float(row['worst']):.{digits}g} {row['worst_unit']}")
    return ", ".join(parts)


def failing_items(rows):
    """What a case has wrong or refused: an item for each method; nothing if all is right."""
    if all(row["verdict"] == "refused" for row in rows):
        return "\nAll of it is refused, with every scalar.\n"
    scalars_with = {}
    for row in rows:
        if row["verdict"] in ("wrong", "refused"):
            scalars_with.setdefault((row["method"], error_of(row)), []).append(row["scalar"])
    items = ""
    for method, failing in itertools.groupby(scalars_with.items(), lambda one: one[0][0]):
        told = [f"{in_page(what)} ({'every scalar' if len(scalars) == 5 else in_page(', '.join(scalars))})"
                for (_, what), scalars in failing]
        items += f"\n- {in_item(method)}: {'; '.join(told)}"
    return items and items + "\n"


def entry(case):
    heading = f"{case['id']}: {case['title']}"
    return (f"\n### {in_page(heading)}\n\n{as_sentence(case['input'])}{'' if case['scenes'] else ' No scene.'}\n\n"
            f"{as_sentence(case['holds'])}\n{failing_items(case['rows'])}")


def entries(cases):
    text = f"{len(cases)} cases.\n"
    for family, some in itertools.groupby(cases, lambda case: case["family"]):
        some = list(some)
        links = ", ".join(f"[{case['id']}](#{anchor_of(case['id'] + ': ' + case['title'])})" for case in some)
        text += f"\n## {family.capitalize()}\n\n{links}\n" + "".join(map(entry, some))
    return text


def main():
    words = sys.argv[1:]
    checks = words[:1] == ["--check"]
    program = (words[checks:] or ["build/release/viewer-cli/rastertrace"])[0]
    told = subprocess.run([program, "stress", "--quick", "--json"], stdout=subprocess.PIPE, check=False)
    # Status 1: a row is not as documented in the code. Then the page would be wrong, too.
    if told.returncode:
        subprocess.run([program, "stress", "--quick"], stdout=sys.stderr, check=False)
        return told.returncode
    page = pathlib.Path(__file__).parent.parent / "docs" / "stress.md"
    before = page.read_text()
    after = re.sub(r"(<!-- stress: begin.*?\n).*?(<!-- stress: end -->)",
                   lambda marks: marks[1] + entries(json.loads(told.stdout, parse_float=str)["cases"]) + marks[2], before, flags=re.S)
    if not checks:
        page.write_text(after)
    elif after != before:
        sys.stderr.writelines(difflib.unified_diff(before.splitlines(True), after.splitlines(True)))
        print(f"docs/stress.md is not what the program writes; to renew it: scripts/make-stress.py {program}", file=sys.stderr)
        return 1
    return 0


sys.exit(main())
