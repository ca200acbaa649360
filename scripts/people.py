#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the tables of docs/results/baselines-people.md again: scripts/people.py FOLDER [METHOD...]

The methods of configs/baselines.ini, or of the arguments, in slalom-people-small when nobody, half and all of the
people notice the robot, and all by ORCA. FOLDER has a result file for each, which is continued or used again: delete
them if methods have changed. The tables, as Markdown, are printed. Environment variable: JOBS, the number of workers
(2).
"""

import itertools

from baseline_tables import estimate, folder_argument, method_arguments, print_table, robustness, run_campaign
from baseline_tables import testbed_list

SETTINGS = {
    "none": ["people.notices=0"],
    "half": ["people.notices=0.5"],
    "all": ["people.notices=1"],
    "orca": ["people.notices=1", "people.model=orca", "people.keep_apart=false"],
}
METRICS = {"success": 2, "people_hindrance": 1, "people_deficit": 2, "frozen_time": 1}  # digits


def main():
    folder = folder_argument(__doc__)
    scenarios = testbed_list(folder, "slalom-people-small")
    results = [run_campaign(folder, name, scenarios, method_arguments(), SETTINGS[name]) for name in SETTINGS]
    tables = robustness(results, METRICS)
    successes = {name[: -len("_success")]: rows for name, rows in tables.items() if name.endswith("_success")}
    methods = sorted(successes, key=lambda method: -sum(row["success"] for row in successes[method]))
    rows = ([one] + [estimate(row, "success") for row in successes[one]] for one in methods)
    print_table(["method", *SETTINGS], rows)
    of_all = list(SETTINGS).index("all")
    effects = [metric for metric in METRICS if metric != "success"]
    cell = lambda one, metric: estimate(tables[f"{one}_{metric}"][of_all], metric, METRICS[metric])
    print_table(["method", *effects], ([one] + [cell(one, metric) for metric in effects] for one in methods))
    orders = [row for i in range(len(results) - 1) for row in robustness(results[i:], METRICS)["order_of_methods"]]
    taus = [[estimate(row, "tau"), estimate(row, "noise_ceiling")] for row in orders if row["metric"] == "success"]
    pairs = [", ".join(pair) for pair in itertools.combinations(SETTINGS, 2)]
    print_table(["settings", "Kendall's tau of success", "noise ceiling"], ([pair, *tau] for pair, tau in zip(pairs, taus)))


main()
