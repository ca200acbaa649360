#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the tables of docs/results/transport.md again: scripts/transport.py FOLDER [METHOD...]

The methods of configs/baselines.ini, or of the arguments, in slalom-small under several settings of robot and sensor,
and in other test beds: how far their order in success is kept, and which comparisons of two methods one setting turns.
FOLDER has a result file for each setting, which is continued or used again: delete them if methods have changed. The
tables, as Markdown, are printed. Environment variable: JOBS, the number of workers (2).
"""

import csv
import json

from baseline_tables import BIN, call, estimate, folder_argument, method_arguments, noise_ceiling, print_table
from baseline_tables import robustness, run_campaign, successes, testbed_list

SMALL = "slalom-small"
SETTINGS = {  # test bed, keys
    "default": (SMALL, []),
    "noise": (SMALL, ["sensor.noise_sigma=0.03", "sensor.dropout_ratio=0.02", "odometry.turn_sigma=0.05"]),
    "latency": (SMALL, ["robot.delay=0.2", "sensor.latency=0.1"]),
    "radius 0.35": (SMALL, ["robot.radius=0.35"]),
    "range 2 m": (SMALL, ["sensor.max_range=2"]),
    "slalom-hard": ("slalom-hard", []),
    "people yield": ("slalom-people-small", ["people.notices=1"]),
    "people do not": ("slalom-people-small", ["people.notices=0"]),
}


def order_of(default, other, folder):
    """Kendall's tau of success in two result files, over the same scenarios if these are the same."""
    names = [SETTINGS[name][0] for name in (default[0], other[0])]
    if names[0] == names[1]:
        row = robustness([default[1], other[1]], ["success"])["order_of_methods"][0]
        return estimate(row, "tau")
    table = folder / f"{default[0]}.csv"
    runs = [json.loads(line) for line in call(BIN / "slalom-analyze", "dump", default[1]).splitlines()]
    with open(table, "w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows([("method", "success")])
        csv.writer(file).writerows((run["method"], int(run["outcome"] == "success")) for run in runs)
    found = json.loads(call(BIN / "slalom-analyze", "sim2real", table, other[1], "--json"))["kendall"]
    return "{:.2f} [{:.2f}, {:.2f}]".format(found["value"], *found["interval"])


def conclusions(results):
    """Whether b is better than a (1), worse (-1) or not told apart (0) in success, by pair."""
    command = [BIN / "slalom-analyze", "compare", results, "--metric", "success", "--json"]
    table = json.loads(call(*command))["tables"][0]
    rows = [dict(zip(table["columns"], row)) for row in table["rows"]]
    sign = {"better": 1, "worse": -1}
    return {(row["a"], row["b"]): sign.get(row["verdict"], 0) for row in rows}


def main():
    folder = folder_argument(__doc__)
    methods = method_arguments()
    results = {}
    for name, (bed, keys) in SETTINGS.items():
        results[name] = run_campaign(folder, name.replace(" ", "_"), testbed_list(folder, bed), methods, keys)
    rows_of = {name: successes(path) for name, path in results.items()}
    told = {name: conclusions(path) for name, path in results.items()}
    default = {pair: sign for pair, sign in told["default"].items() if sign}
    rows, turned = [], []
    for name in list(SETTINGS)[1:]:
        signs = {pair: told[name].get(pair, 0) * sign for pair, sign in default.items()}
        kept, reversed_ = (sum(sign == wanted for sign in signs.values()) for wanted in (1, -1))
        tau = order_of(("default", results["default"]), (name, results[name]), folder)
        ceiling = "{:.2f}, {:.2f}".format(*noise_ceiling(rows_of["default"], rows_of[name]))
        rows.append([name, tau, ceiling, str(kept), str(len(default) - kept - reversed_), str(reversed_)])
        turned += [(pair[::default[pair]], name) for pair, sign in signs.items() if sign < 0]
    print_table(["setting", "Kendall's tau", "noise ceiling", "kept", "not told apart", "turned"], rows)
    everywhere = sum(all(told[name].get(pair, 0) == sign for name in SETTINGS) for pair, sign in default.items())
    print(f"{len(default)} of {len(told['default'])} pairs are told apart by default, {everywhere} under all settings.\n")
    print_table(["by default", "turned by"], ((f"{pair[1]} better than {pair[0]}", name) for pair, name in turned))


main()
