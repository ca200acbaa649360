#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the table of docs/results/baselines-tuned.md again: scripts/tuned.py FOLDER [METHOD...]

Each method of configs/baselines.ini, or of the arguments, is tuned on parts of slalom-standard, with its results in
FOLDER/METHOD, which are used again: delete those of methods that have changed. Environment variable: JOBS, the number of
workers (2).
"""

import json
import subprocess

from baseline_tables import BIN, CAMPAIGN, JOBS, folder_argument, method_arguments, print_table, testbed_list


def answer(folder, scenarios, method):
    path = folder / method / "tuned.json"
    if not path.exists():
        command = [BIN / "slalom-tune", CAMPAIGN, "--method", method, "--runs", "1000", "-o", folder / method]
        command += ["--set", f"scenarios.list={scenarios}", "--set", "scenarios.generator="]
        command += ["--set", "limits.run_wall_time=3600", "-j", JOBS, "--quiet"]
        run = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        if run.returncode != 0:
            return run.stderr.strip()
    return json.loads(path.read_text())["answer"]


def estimate(value):
    number, low, high = (f"{round(value[key], 2) + 0:.2f}" for key in ("value", "low", "high"))  # no -0.00
    return f"{number} [{low}, {high}]"


def row(method, found):
    if isinstance(found, str):
        return [method, "–", "–", "–", "–", "no ranges"]
    sealed = found["sealed"]
    if sealed is None:
        return [method, "–", "–", "–", "–", "the default is the best of the finals"]
    collisions = [sealed[side]["collisions"] for side in ("default_counts", "tuned_counts")]
    verdict = found["verdict"] + (", with more collisions" if sealed["more_collisions"] else "")
    return [
        method,
        estimate(sealed["default"]),
        estimate(sealed["tuned"]),
        estimate(sealed["difference"]),
        f"{collisions[0]}, {collisions[1]} of {sealed['scenarios']}",
        verdict,
    ]


def main():
    folder = folder_argument(__doc__)
    scenarios = testbed_list(folder, "slalom-standard")
    rows = [row(method, answer(folder, scenarios, method)) for method in method_arguments()]
    header = ["method", "default", "tuned", "difference", "collisions: default, tuned", "verdict"]
    print_table(header, sorted(rows, key=lambda cells: cells[2], reverse=True))


main()
