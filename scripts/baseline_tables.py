# SPDX-License-Identifier: BSD-3-Clause
"""Shared parts of the scripts that make tables of docs: claims.py, limits.py, people.py, transport.py, tuned.py. Environment
variable: SLALOM_BIN, the folder of the programs. As a program it copies Markdown with the LABELS of methods in the rows of
tables."""

import json
import os
import pathlib
import random
import re
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BIN = pathlib.Path(os.environ.get("SLALOM_BIN", ROOT / "build/release/bin"))
CAMPAIGN = ROOT / "configs/baselines.ini"
JOBS = os.environ.get("JOBS", "2")
# Names of rows for MRPT's classes, which say who calls them; by their names in configs/baselines.ini.
LABELS = {
    "nd": "CHolonomicND (Slalom's adapter)",
    "vff": "CHolonomicVFF (Slalom's adapter)",
    "full_eval": "CHolonomicFullEval (Slalom's adapter)",
    "reactive": "CReactiveNavigationSystem (MRPT's)",
    "reactive_tuned": "CReactiveNavigationSystem (MRPT's), tuned",
}


def folder_argument(usage):
    """The folder of the results, the first argument; without one, or with --help, the usage is printed."""
    if "--help" in sys.argv:
        print(usage)
        sys.exit()
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(usage)
    folder = pathlib.Path(sys.argv[1]).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def method_arguments():
    """The other arguments, or all methods of the campaign."""
    return sys.argv[2:] or re.search(r"^methods = (.*)$", CAMPAIGN.read_text(), re.M)[1].split(", ")


def testbed_list(folder, name):
    """The scenario list of a test bed, generated unless it is there."""
    scenarios = folder / f"{name}.scenarios"
    if not scenarios.exists():
        command = [BIN / "slalom-scenarios", "generate", "-c", ROOT / f"configs/testbeds/{name}.ini"]
        subprocess.run([*command, "-o", scenarios, "-j", JOBS, "--quiet"], check=True)
    return scenarios


def call(*command):
    """What a program prints."""
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def run_campaign(folder, name, scenarios, methods, settings):
    """The result file of the methods in the scenarios with other keys, continued if it is there."""
    results = folder / f"{name}.results"
    command = [BIN / "slalom-simulate", "run", "-c", CAMPAIGN, "--scenarios", scenarios]
    command += ["-o", results, "-j", JOBS, "--quiet"]
    for setting in [*settings, "campaign.methods=" + ",".join(methods)]:
        command += ["--set", setting]
    call(*command)
    return results


def robustness(results, metrics):
    """The rows of each table of `robustness` over result files, by its name."""
    command = [BIN / "slalom-analyze", "robustness", *results, "--parameter", "setting", "--despite-settings"]
    command += ["--values", ",".join(str(i) for i in range(len(results)))]
    found = json.loads(call(*command, "--metric", ",".join(metrics), "--json"))
    return {one["name"]: [dict(zip(one["columns"], row)) for row in one["rows"]] for one in found["tables"]}


def successes(results):
    """By scenario: whether each method succeeds in it, in the order of the names of the methods."""
    scenarios = {}
    for line in call(BIN / "slalom-analyze", "dump", results).splitlines():
        run = json.loads(line)
        scenarios.setdefault(run["scenario"]["hash"], {})[run["method"]] = run["outcome"] == "success"
    return {scenario: [of[method] for method in sorted(of)] for scenario, of in scenarios.items()}


def kendall_tau(a, b):
    """Kendall's tau-b; 0 if all values of one side are equal."""
    sign = lambda values, i, j: (values[i] > values[j]) - (values[i] < values[j])
    pairs = [(sign(a, i, j), sign(b, i, j)) for i in range(len(a)) for j in range(i)]
    untied = sum(x != 0 for x, _ in pairs) * sum(y != 0 for _, y in pairs)
    return sum(x * y for x, y in pairs) / untied**0.5 if untied else 0


def by_rank(outcomes):
    """The outcomes with the methods from the most successful one to the least."""
    totals = [sum(column) for column in zip(*outcomes.values())]
    order = sorted(range(len(totals)), key=lambda i: -totals[i])
    return {scenario: [row[i] for i in order] for scenario, row in outcomes.items()}


def noise_ceiling(first, other, repetitions=1000):
    """Kendall's tau of two campaigns with the same true order of the methods: its mean, and what it exceeds in 95 %.

    The true rates are those of `first` and `other`, successes(), where the methods of equal rank count as the same one.
    Scenarios are drawn from both, the same ones if both have the same."""
    first, other = by_rank(first), by_rank(other)
    draw = random.Random(1)
    taus = []
    for _ in range(repetitions):
        drawn = draw.choices(list(first), k=len(first))
        drawn_other = drawn if first.keys() == other.keys() else draw.choices(list(other), k=len(other))
        totals = [[sum(column) for column in zip(*(outcomes[scenario] for scenario in scenarios))]
                  for outcomes, scenarios in ((first, drawn), (other, drawn_other))]
        taus.append(kendall_tau(*totals))
    return statistics.mean(taus), sorted(taus)[repetitions // 20]


def estimate(row, name, digits=2):
    """Text such as 0.82 [0.76, 0.87] of the fields NAME, NAME.low and NAME.high."""
    if row[name] is None:
        return "–"
    low, high = row[name + ".low"], row[name + ".high"]
    return f"{row[name]:.{digits}f}" + ("" if low is None else f" [{low:.{digits}f}, {high:.{digits}f}]")


def print_table(header, rows):
    print("| " + " | ".join(header) + " |\n" + "|---" * len(header) + "|")
    for first, *cells in rows:
        print("| " + " | ".join([LABELS.get(first, first), *cells]) + " |")
    print()


def label_rows(markdown):
    """With the labels of the methods that begin rows of tables."""
    return re.sub(r"^\| (\w+) \|", lambda row: f"| {LABELS.get(row[1], row[1])} |", markdown, flags=re.M)


if __name__ == "__main__":
    sys.stdout.write(label_rows(sys.stdin.read()))
