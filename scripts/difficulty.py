#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes configs/testbeds/*.difficulty.csv again, the strata of slalom-evaluate --quick, and the coefficients of the
descriptor predicted_difficulty, modules/world/descriptors/src/path/difficulty_model.h: scripts/difficulty.py FOLDER

The methods of configs/baselines.ini, without those that take longest, in slalom-small and slalom-standard. FOLDER has
a result file for each, which is continued or used again: delete them if methods have changed. Prints how well samples
of 100 scenarios estimate the success of each method by strata of the other methods, and R^2 of the predicted difficulty:
by cross-validation in slalom-standard, with the coefficients as they are in slalom-small and in 420 scenarios of the
seven families by name, and there of each family by the others. Environment variable: JOBS, the number of workers (2).
"""

import csv
import json
import random
import re
import sqlite3
import subprocess

from baseline_tables import BIN, CAMPAIGN, JOBS, ROOT, call, folder_argument, method_arguments, testbed_list

SLOW = ["mppi", "dwa_ros", "reactive", "reactive_tuned"]
STRATA = 8  # kStrata in stratified_sample.h
SAMPLE = 100
DRAWS = 1000
FAMILIES = "random, poisson_forest, cellular_automaton, rooms, maze, traps, perlin"  # those of slalom-standard
HALF_NARROW, HALF_DETOUR = 0.1, 0.05  # chosen in slalom-standard among 0.05, 0.1, 0.2, 0.4 and 0.03, 0.05, 0.1, 0.2


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


def family_list(folder):
    """Scenarios that have the names of their families, which those of a search for bins do not have."""
    scenarios = folder / "families.scenarios"
    if not scenarios.exists():
        config = folder / "families.ini"
        config.write_text(f"[scenarios]\ngenerator = {FAMILIES}\ncount = 420\n")
        call(BIN / "slalom-scenarios", "generate", "-c", config, "-o", scenarios, "-j", JOBS, "--quiet")
    return scenarios


def model_rows(folder, scenarios, solved, hashes):
    """(family, predictors, difficulty) of each scenario."""
    table = folder / f"{scenarios.stem}.csv"
    with table.open("w") as file:
        rows = csv.writer(file)
        rows.writerow(["method", "scenario", "outcome"])
        for method, solvers in solved.items():
            rows.writerows([method, one, "success" if one in solvers else "failure"] for one in sorted(hashes))
    found = json.loads(call(BIN / "slalom-analyze", "difficulty", table, "--metric", "success", "--json"))["tables"]
    scale = next(one for one in found if one["name"] == "scenarios")
    difficulty = {row[0][:12]: row[scale["columns"].index("difficulty")] for row in scale["rows"]}
    described = call(BIN / "slalom-scenarios", "describe", scenarios, "--descriptors", "narrow_fraction,detour_ratio", "--json")
    for one in map(json.loads, described.splitlines()):
        narrow, detour = one["narrow_fraction"], max(0, 1 - 1 / one["detour_ratio"])
        predictors = [1, narrow / (narrow + HALF_NARROW), detour / (detour + HALF_DETOUR)]
        yield re.sub(r"_\d+$", "", one["name"]), predictors, difficulty[one["id"]]


def solve(matrix, right):
    """Gauss's elimination, for a positive definite matrix."""
    rows = [[*row, value] for row, value in zip(matrix, right)]
    for i in range(len(rows)):
        pivot = [value / rows[i][i] for value in rows[i]]
        rows = [pivot if k == i else [a - row[i] * b for a, b in zip(row, pivot)] for k, row in enumerate(rows)]
    return [row[-1] for row in rows]


def fit(rows):
    """The coefficients of the least squares."""
    size = range(len(rows[0][1]))
    products = [[sum(x[i] * x[j] for _, x, _ in rows) for j in size] for i in size]
    return solve(products, [sum(x[i] * y for _, x, y in rows) for i in size])


def explained(rows, coefficients):
    """R^2, with coefficients for each row."""
    center = sum(y for _, _, y in rows) / len(rows)
    rest = sum((y - sum(c * p for c, p in zip(one, x))) ** 2 for (_, x, y), one in zip(rows, coefficients))
    return 1 - rest / sum((y - center) ** 2 for _, _, y in rows)


def cross_validated(rows, folds):
    """R^2, each fold predicted by the others."""
    fitted = {fold: fit([row for row, other in zip(rows, folds) if other != fold]) for fold in set(folds)}
    return explained(rows, [fitted[fold] for fold in folds])


def write_model(coefficients):
    names = ["kEasiest", "kNarrow", "kDetour", "kHalfNarrow", "kHalfDetour"]
    values = [*(f"{value:.3f}" for value in coefficients), HALF_NARROW, HALF_DETOUR]
    lines = [f"constexpr double {name} = {value};" for name, value in zip(names, values)]
    head = ["// SPDX-License-Identifier: BSD-3-Clause", "// Written by scripts/difficulty.py.", "#pragma once", ""]
    head += ["namespace slalom::descriptors {", "", "/// Model of the Rasch difficulty of the scenarios in slalom-standard (logit)."]
    text = "\n".join([*head, *lines, "", "}  // namespace slalom::descriptors", ""])
    (ROOT / "modules/world/descriptors/src/path/difficulty_model.h").write_text(text)


def main():
    folder = folder_argument(__doc__)
    random.seed(1)
    models = {}
    for name in ["slalom-small", "slalom-standard", "families"]:
        scenarios = family_list(folder) if name == "families" else testbed_list(folder, name)
        found = {one: solved_by(folder, scenarios, one) for one in method_arguments() if one not in SLOW}
        hashes = set.union(*(all_hashes for _, all_hashes in found.values()))
        solved = {method: solvers for method, (solvers, _) in found.items()}
        models[name] = list(model_rows(folder, scenarios, solved, hashes))
        if name == "families":
            continue
        write_table(name, solved, hashes)
        rows = list(leave_one_out(solved, hashes))
        for method, square, chance, covered in rows:
            print(f"{name} {method}: error {square**0.5:.4f}, of a random sample {chance**0.5:.4f}, coverage {covered:.3f}")
        squares, chances = (sum(row[i] for row in rows) for i in (1, 2))
        print(f"{name}: relative error {(squares / chances) ** 0.5:.3f}, coverage {sum(r[3] for r in rows) / len(rows):.3f}")
    standard, families = models["slalom-standard"], models["families"]
    shipped = [round(one, 3) for one in fit(standard)]
    write_model(shipped)
    folds = [random.randrange(10) for _ in standard]
    print(f"R^2 in slalom-standard, 10 folds: {cross_validated(standard, folds):.3f}")
    for name in ["slalom-small", "families"]:
        print(f"R^2 in {name}: {explained(models[name], [shipped] * len(models[name])):.3f}")
    print(f"R^2 of each family by the others: {cross_validated(families, [row[0] for row in families]):.3f}")


main()
