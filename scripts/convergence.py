#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints how descriptors depend on the cell size, as the table of docs/reference/definitions.md: for each size the bias of the mean
against the finest cells, and the rank correlation with their values, over 24 generated scenarios with walkers:
scripts/convergence.py [DESCRIPTOR...]

All descriptors without arguments, except those whose values are equal at all sizes. SLALOM_BIN is the folder of the
programs (build/release/bin)."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

SIZES = [0.1, 0.05, 0.025, 0.0125]  # m
BIN = pathlib.Path(os.environ.get("SLALOM_BIN", pathlib.Path(__file__).parent.parent / "build/release/bin"))


def scenarios(*arguments):
    return subprocess.run([BIN / "slalom-scenarios", *arguments], check=True, stdout=subprocess.PIPE, text=True).stdout


def ranks(values):
    """From 0; ties have the mean of their ranks."""
    return [sum(other < value for other in values) + (values.count(value) - 1) / 2 for value in values]


def correlation(x, y):
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    product = sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y))
    scale = sum((a - mean_x) ** 2 for a in x) * sum((b - mean_y) ** 2 for b in y)
    return product / scale**0.5 if scale > 0 else float("nan")


def measure(descriptors):
    """{id: {size: [value of each scenario]}}; None where it is NA."""
    values = {}
    with tempfile.TemporaryDirectory() as folder:
        options, rooms = pathlib.Path(folder, "rooms.ini"), pathlib.Path(folder, "rooms.scenarios")
        options.write_text("[scenarios]\ngenerator = random, poisson_forest, traps, rooms\ncount = 24\nwalkers = 3\n")
        scenarios("generate", "-c", options, "--seed", "31", "-o", rooms, "--quiet")
        chosen = ["--descriptors", ",".join(descriptors)] if descriptors else []
        for size in SIZES:
            for line in scenarios("describe", rooms, "--json", "--resolution", str(size), *chosen).splitlines():
                for name, value in json.loads(line).items():
                    if value is None or isinstance(value, (int, float)):
                        values.setdefault(name, {}).setdefault(size, []).append(value)
    return values


def cells_of_row(values):
    """Bias and rank correlation at each size but the finest, of the scenarios with a value at all sizes."""
    kept = [i for i, known in enumerate(zip(*values.values())) if None not in known]
    known = {size: [values[size][i] for i in kept] for size in SIZES}
    finest = known[SIZES[-1]]
    if all(column == finest for column in known.values()):
        return None
    mean = sum(finest) / len(finest)
    cells = [f"{mean:.3g}"]
    for size in SIZES[:-1]:
        bias = sum(known[size]) / len(finest) / mean - 1
        cells.append(f"{100 * bias:+.1f} %, {correlation(ranks(known[size]), ranks(finest)):.3f}")
    return cells


def main():
    rows = {name: cells_of_row(values) for name, values in measure(sys.argv[1:]).items()}
    head = ["id", f"mean at {SIZES[-1]} m", *(f"{size} m" for size in SIZES[:-1])]
    print("| " + " | ".join(head) + " |\n|" + "---|" * len(head))
    for name, cells in rows.items():
        if cells:
            print(f"| `{name}` | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
