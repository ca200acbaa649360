#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes configs/testbeds/*.difficulty.csv again, the strata of slalom-evaluate --quick: scripts/difficulty.py FOLDER

The methods of configs/baselines.ini, without those that take longest, in slalom-small and slalom-standard. FOLDER has
a result file for each, which is continued or used again: delete them if methods have changed. Prints how well samples
of 100 scenarios estimate the success of each method by strata of the other methods. Environment variable: JOBS, the
number of workers (2).
"""

import random
import sqlite3
import subprocess

from baseline_tables import BIN, CAMPAIGN, JOBS, ROOT, folder_argument, method_arguments, testbed_list

SLOW = ["mppi", "dwa_ros", "reactive", "reactive_tuned"]
STRATA = 8  # kStrata in stratified_sample.h
SAMPLE = 100
DRAWS = 1000


def solved_by(folder, scenarios, method):
    """The hashes of the scenarios that the method solves, and of all."""
    results = folder / f"{scenarios.stem}.{method}.results"
    command = [BIN / "slalom-simulate", "run", "-c", CAMPAIGN, "--scenarios", scenarios, "-o", results]
    command += ["-j", JOBS, "--quiet"]
    settings = [f"campaign.methods={method}", "metrics.enabled=success", "metrics.descriptors=density"]
    settings += ["record.trajectories=none", "analysis.columns=success", "analysis.rows=all"]
    for setting in settings:
        command += ["--set", setting]
    subprocess.run(command, check=True)
    runs = sqlite3.connect(results).execute("SELECT scenario, outcome FROM runs").fetchall()
    return {one for one, outcome in runs if outcome == "success"}, {one for one, _ in runs}


def write_table(name, solved, scenarios):
    order = sorted(solved, key=lambda method: -len(solved[method]))
    rates = ", ".join(f"{method} {len(solved[method]) / len(scenarios):g}" for method in order)
    rows = [f"{one[:16]},{sum(one in solvers for solvers in solved.values())}" for one in sorted(scenarios)]
    text = "\n".join([f"# {rates}", "scenario,solved_by", *rows])
    (ROOT / f"configs/testbeds/{name}.difficulty.csv").write_text(text + "\n")


def estimate(solvers, strata, allocation, population):
    """The rate and half the 95 % interval of a stratified sample, as stratified_rate() computes them."""
    rate = variance = 0
    for stratum, k in zip(strata, allocation):
        successes = sum(one in solvers for one in random.sample(stratum, k))
        cautious = (successes + 1) / (k + 2)
        weight = len(stratum) / population
        rate += weight * successes / k
        variance += weight**2 * cautious * (1 - cautious) / k * (1 - k / len(stratum))
    return rate, 1.959964 * variance**0.5


def leave_one_out(solved, scenarios):
    """Error relative to that of a simple random sample, and coverage, by method."""
    n = len(scenarios)
    for method, solvers in solved.items():
        others = {one: sum(one in solved[other] for other in solved if other != method) for one in scenarios}
        order = sorted(sorted(scenarios), key=lambda one: (others[one], random.random()))
        strata = [order[i * n // STRATA : (i + 1) * n // STRATA] for i in range(STRATA)]
        allocation = [SAMPLE // STRATA + (i < SAMPLE % STRATA) for i in range(STRATA)]
        truth = len(solvers) / n
        estimates = [estimate(solvers, strata, allocation, n) for _ in range(DRAWS)]
        square = sum((rate - truth) ** 2 for rate, _ in estimates) / DRAWS
        chance = truth * (1 - truth) / SAMPLE * (n - SAMPLE) / (n - 1)
        covered = sum(abs(rate - truth) <= half for rate, half in estimates) / DRAWS
        yield method, square, chance, covered


def main():
    folder = folder_argument(__doc__)
    random.seed(1)
    for name in ["slalom-small", "slalom-standard"]:
        scenarios = testbed_list(folder, name)
        found = {one: solved_by(folder, scenarios, one) for one in method_arguments() if one not in SLOW}
        hashes = set.union(*(all_hashes for _, all_hashes in found.values()))
        solved = {method: solvers for method, (solvers, _) in found.items()}
        write_table(name, solved, hashes)
        rows = list(leave_one_out(solved, hashes))
        for method, square, chance, covered in rows:
            print(f"{name} {method}: error {square**0.5:.4f}, of a random sample {chance**0.5:.4f}, coverage {covered:.3f}")
        squares, chances = (sum(row[i] for row in rows) for i in (1, 2))
        print(f"{name}: relative error {(squares / chances) ** 0.5:.3f}, coverage {sum(r[3] for r in rows) / len(rows):.3f}")


main()
