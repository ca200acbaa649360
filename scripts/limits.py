#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the tables of docs/results/baselines-limits.md again: scripts/limits.py FOLDER [METHOD...]

Methods are those of configs/baselines.ini by default. Each has its certificates in FOLDER, which are used again if they
are complete: delete those of methods that have changed. The tables, as Markdown, are printed. Environment variable:
JOBS, the number of workers (2).
"""

import json
import subprocess
import sys

from baseline_tables import BIN, CAMPAIGN, JOBS, folder_argument, method_arguments, print_table

RELIABILITIES = ["0.5", "0.8", "0.95"]
BUDGET = ["--reliability", *RELIABILITIES, "--budget", "1000", "--max-per-step", "500"]
QUESTIONS = {
    "passage": ["limit", "--of", "passage.width", "--from", "1.2", "--to", "0.5", "--step", "0.1", *BUDGET],
    "random": ["limit", "--of", "random.obstacles", "--from", "8", "--to", "56", "--step", "8", *BUDGET],
    "standard": ["standard"],
}


def answer(folder, method, name):
    path = folder / f"{method}-{name}.certificate.json"
    if not path.exists():
        command = [BIN / "slalom-certify", QUESTIONS[name][0], CAMPAIGN, "--method", method]
        command += [*QUESTIONS[name][1:], "-o", path, "-j", JOBS, "--quiet"]
        run = subprocess.run(command, stdout=subprocess.DEVNULL)
        if run.returncode != 0:
            sys.exit(f"limits.py: {method}, {name}: exit status {run.returncode}")
    return json.loads(path.read_text())["answer"]


def limit_rows(folder, methods, name):
    for method in methods:
        claims = answer(folder, method, name)["claims"]
        yield method, ["–" if claim["limit"] is None else f"{claim['limit']:g}" for claim in claims]


def standard_rows(folder, methods):
    for method in methods:
        tests = answer(folder, method, "standard")["tests"]
        passed = sum(test["passed"] for test in tests)
        cells = [("" if test["passed"] else "**") for test in tests]
        yield method, [f"{mark}{test['failures']}{mark}" for mark, test in zip(cells, tests)] + [f"{passed}/{len(tests)}"]


def print_sorted(header, rows, key):
    print_table(header, ([method, *cells] for method, cells in sorted(rows, key=key)))


def value(text, worst):
    return worst if text == "–" else float(text)


def main():
    folder, methods = folder_argument(__doc__), method_arguments()
    header = ["method"] + [f"success >= {rate}" for rate in RELIABILITIES]
    narrow = list(limit_rows(folder, methods, "passage"))
    print_sorted(header, narrow, lambda row: [value(text, 9) for text in row[1]][::-1] + [row[0]])
    crowded = list(limit_rows(folder, methods, "random"))
    print_sorted(header, crowded, lambda row: [-value(text, 0) for text in row[1]][::-1] + [row[0]])
    standard = list(standard_rows(folder, methods))
    tests = answer(folder, methods[0], "standard")["tests"]
    names = [f"{test['test']} {100 * test['speed']:g} %" for test in tests]
    print_sorted(["method", *names, "passed"], standard, lambda row: [-int(row[1][-1].split("/")[0]), row[0]])


main()
