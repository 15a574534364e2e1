#!/usr/bin/env python3
"""Points for a student's program and pictures: a table says what is asked, and what each part gives.

Run: python3 grade.py table.csv --seed 48151623 --results results.json -- ./student
docs/grade.md describes the table. The exit status is 0 for all points, 1 for fewer, 2 if it cannot be told."""
import argparse
import csv
import glob
import json
import math
import os
import shlex
import subprocess
import sys

FIELDS = ["name", "points", "conform", "pictures", "references", "options"]


def fail(problem):
    print(f"error: {problem}", file=sys.stderr)
    sys.exit(2)


def read_part(row, place):
    """The part of a line of the table."""
    part = {field: (row.get(field) or "").strip() for field in FIELDS}
    try:
        part["points"] = float(part["points"])
    except ValueError:
        part["points"] = math.nan
    if not (part["name"] and 0 < part["points"] < math.inf) or None in row:
        fail(f"{place}: write a name, points above 0, and one field for each column")
    asks, shows, refers = (bool(part[field]) for field in FIELDS[2:5])
    if asks == shows or shows != refers:
        fail(f"{place}: write what to ask under `conform`, or both `pictures` and `references`")
    return part


def read_table(path):
    """The parts of the assignment. Python's csv knows quotes with commas and line breaks in them (RFC 4180)."""
    with open(path, newline="", encoding="utf-8-sig") as file:
        rows = csv.DictReader(file)
        if not {"name", "points"} <= set(rows.fieldnames or []) <= set(FIELDS):
            fail(f"{path}: the first line names the columns: {','.join(FIELDS)}")
        parts = [read_part(row, f"{path}, line {rows.line_num}") for row in rows]
    return parts or fail(f"{path}: there is no part")


def groundtruth(arguments, options):
    """What the program prints as JSON, or None; its standard error; and whether it says yes."""
    command = [options.groundtruth, *arguments]
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace")
    except OSError as error:
        fail(f"{command[0]}: cannot be started: {error}")
    if done.returncode not in (0, 1, 2):
        fail(f"{shlex.join(command)}: ended with {done.returncode}\n{done.stderr}")
    return json.loads(done.stdout) if done.stdout.strip() else None, done.stderr, done.returncode == 0


def asked(part, options):
    """The share of kinds of questions whose answers are all right, and hints that do not give the answers away."""
    words = shlex.split(part["conform"])
    question = ["conform", *words, "--profile", "book", "--json", "--seed", str(options.seed), *shlex.split(part["options"])]
    card, problem, _ = groundtruth([*question, "--", *options.program], options)
    if card is None:
        return (0, "Your program answered no question.\n") if "answered no question" in problem else fail(problem)
    right, judged, hints = 0, 0, ""
    for family in card["families"]:
        # answers that nobody can judge count neither way; what was not asked any more is not right
        counts = family["counts"]
        cases = family["cases"] - counts["undecided"]
        judged += cases > 0
        if counts["pass"] == cases:
            right += cases > 0
            continue
        rest = "" if counts["wrong"] else f" ({counts['unsupported']} unsupported)"
        hints += (f"{family['about']}: {cases - counts['pass']} of {cases} answers are not right{rest}\n"
                  f"  {family['chapter']}; to see such cases: groundtruth conform {family['family']} --profile book"
                  " -- YOUR PROGRAM\n")
    return (right / judged, hints) if judged else fail(f"part {part['name']}: no answer could be judged")


def shown(part, options):
    """1 if the pictures agree with the teacher's, else 0; and what `groundtruth` says."""
    pictures = sorted(glob.glob(os.path.join(glob.escape(options.folder), part["pictures"])))
    references = sorted(glob.glob(part["references"])) or fail(f"part {part['name']}: no file {part['references']}")
    if not pictures:
        return 0, f"There is no picture {part['pictures']}.\n"
    one = len(pictures) == len(references) == 1
    names = [*pictures, *references] if one else ["--before", *references, "--after", *pictures]
    command = "compare" if one else "verify"
    told, problem, is_right = groundtruth([command, *names, "--json", *shlex.split(part["options"])], options)
    if told is None:
        return 0, f"Your picture cannot be judged.\n{problem}"
    return int(is_right), "" if is_right else told["verdict"] + "\n"


def cell(value):
    """For spreadsheets, which take what begins so for a formula."""
    return f"'{value}" if str(value).startswith(("=", "+", "-", "@", "\t", "\r")) else value


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0], epilog="-- and the student's program follow")
    parser.add_argument("table", help="the parts of the assignment (CSV)")
    parser.add_argument("--seed", type=int, help="of the questions: long, and the same for the class")
    parser.add_argument("--folder", default=".", help="where the student's pictures are")
    parser.add_argument("--results", help="write the points for Gradescope")
    parser.add_argument("--class", dest="students", help="add a line to this table of the class (CSV)")
    parser.add_argument("--student", default="", help="the name in that line")
    parser.add_argument("--groundtruth", default="groundtruth", help="the program that asks and compares")
    words = sys.argv[1:]
    end = words.index("--") if "--" in words else len(words)
    options = parser.parse_args(words[:end])
    options.program = words[end + 1:]
    parts, tests = read_table(options.table), []
    if any(part["conform"] for part in parts) and not (options.program and options.seed is not None):
        fail("questions need --seed, and the student's program after --")
    for part in parts:
        share, hints = asked(part, options) if part["conform"] else shown(part, options)
        # hundredths, rounded down: all points only if all is right
        score = part["points"] if share == 1 else math.floor(100 * part["points"] * share + 1e-6) / 100
        tests.append({"name": part["name"], "score": score, "max_score": part["points"], "visibility": "visible",
                      "status": "passed" if share == 1 else "failed", "output": hints or "Everything is right.\n"})
    score, most = (round(sum(test[key] for test in tests), 2) for key in ("score", "max_score"))
    width = max(len(test["name"]) for test in tests)
    for test in [*tests, {"name": "total", "score": score, "max_score": most}]:
        print(f"{test['name']:{width}} {test['score']:>6g} of {test['max_score']:g}")
    for test in tests:
        if test["status"] == "failed":
            print(f"\n{test['name']}\n{test['output']}", end="")
    if options.results:
        with open(options.results, "w", encoding="utf-8") as file:
            json.dump({"score": score, "stdout_visibility": "hidden", "tests": tests}, file, indent=1)
    if options.students:
        with open(options.students, "a", newline="", encoding="utf-8") as file:
            head = [["student", "total", *(test["name"] for test in tests)]] if file.tell() == 0 else []
            rows = [*head, [options.student, score, *(test["score"] for test in tests)]]
            csv.writer(file).writerows([cell(value) for value in row] for row in rows)
    sys.exit(0 if score == most else 1)


if __name__ == "__main__":
    main()
