#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How the methods of a campaign fail: scripts/studies/failures.py RESULTS LIST FOLDER

Puts each failed run of RESULTS into a class by its last seconds (CLASSES), prints a table of the classes by method, and
writes pictures of ten runs of each method and class to FOLDER. LIST has the scenarios, continuous ones: whether the goal
is visible is not known of others. A method with more than a third of its failures in the first three classes deserves a
look at its publication, or at another implementation. Environment variable: SLALOM_BIN, the folder of the programs.
"""

import collections
import csv
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from baseline_tables import BIN, call  # noqa: E402

LAST = 8  # s
PICTURES = 10
RADIUS = 0.25  # m, of the robot of configs/baselines.ini
OPEN = 0.25  # m, clearance of the footprint
NEAR = 2  # m
SLOW = 0.05  # m/s
TURNING = 0.1  # rad/s
WANDERING = 3  # m within the last seconds
CLASSES = {
    "open": "stands in the open: nothing within 0.25 m",
    "visible goal": "within 2 m of a goal that it could drive to straight",
    "turns in place": "turns without moving, for most of the time",
    "wanders": "drives 3 m or more",
    "collides": "touches an obstacle",
    "blocked": "stands within 0.25 m of an obstacle",
    "other": "ends by an error or a limit",
}


def task_of(scenario_list, scenario):
    """Goal, discs (x, y, radius) and polygons of a scenario."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "task.scenario.yaml"
        call(BIN / "slalom-scenarios", "export", scenario_list, scenario, "-o", path)
        text = path.read_text()
    goal = json.loads(re.search(r"^goal: (.*)$", text, re.M)[1])
    shapes = [json.loads(one) for one in re.findall(r"^  - (\[.*\])$", text, re.M)]
    return goal[:2], [one for one in shapes if len(one) == 3 and not isinstance(one[0], list)], [
        one for one in shapes if isinstance(one[0], list)]


def to_segment(p, a, b):
    """The distance of a point to a segment."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    square = dx * dx + dy * dy
    t = min(1, max(0, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square)) if square else 0
    return math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy)


def line_is_free(a, b, radius, discs, polygons):
    """Whether a disc can move straight from a to b. A line that begins outside of a polygon leaves it free if it is nowhere
    near its sides."""
    steps = max(1, math.ceil(math.dist(a, b) / 0.02))
    for i in range(steps + 1):
        p = [a[k] + (b[k] - a[k]) * i / steps for k in (0, 1)]
        if any(math.dist(p, disc[:2]) < disc[2] + radius for disc in discs):
            return False
        if any(to_segment(p, one[k - 1], one[k]) < radius for one in polygons for k in range(len(one))):
            return False
    return True


def class_of(outcome, samples, radius, task):
    """The class of a failed run by its samples: t, x, y, v, w, clearance."""
    if outcome == "collision":
        return "collides"
    if outcome not in ("stuck", "timeout") or not samples:
        return "other"
    last = [one for one in samples if one["t"] >= samples[-1]["t"] - LAST]
    end = last[-1]
    turning = sum(abs(one["v"]) < SLOW and abs(one["w"]) > TURNING for one in last)
    if turning > len(last) / 2:
        return "turns in place"
    goal, discs, polygons = task
    place = [end["x"], end["y"]]
    if math.dist(place, goal) < NEAR and line_is_free(place, goal, radius, discs, polygons):
        return "visible goal"
    length = sum(math.dist((a["x"], a["y"]), (b["x"], b["y"])) for a, b in zip(last, last[1:]))
    if length >= WANDERING:
        return "wanders"
    return "open" if end["clearance"] > OPEN else "blocked"


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__.split("\n\n")[0])
    results, scenario_list, folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    folder.mkdir(parents=True, exist_ok=True)
    runs = [json.loads(line) for line in call(BIN / "slalom-analyze", "dump", results).splitlines()]
    tasks, found = {}, collections.defaultdict(list)
    call(BIN / "slalom-analyze", "trajectories", results, "-o", folder / "trajectories", "--quiet")
    for run in runs:
        if run["outcome"] == "success":
            found[run["method"]]  # a method without failures has a row, too
            continue
        scenario = run["scenario"]["hash"]
        path = folder / "trajectories" / f"{scenario[:8]}_{run['method']}_{run['repetition']}.csv"
        rows = csv.DictReader(path.read_text().splitlines())
        samples = [{key: float(value or "nan") for key, value in row.items()} for row in rows]
        if scenario not in tasks:
            tasks[scenario] = task_of(scenario_list, scenario[:12])
        found[run["method"]].append((class_of(run["outcome"], samples, RADIUS, tasks[scenario]), scenario[:12]))
    print("| method | failures | " + " | ".join(CLASSES) + " |")
    print("|---" * (2 + len(CLASSES)) + "|")
    for method in sorted(found):
        counts = collections.Counter(one for one, _ in found[method])
        print(f"| {method} | {len(found[method])} | " + " | ".join(str(counts[one]) for one in CLASSES) + " |")
        for one in CLASSES:
            for scenario in [scenario for kind, scenario in found[method] if kind == one][:PICTURES]:
                picture = folder / f"{method}-{one.replace(' ', '_')}-{scenario}.svg"
                command = [BIN / "slalom-analyze", "figure", results, "--scenario", scenario, "--method", method, "-o", picture]
                subprocess.run([*command, "--quiet"], check=True)


if __name__ == "__main__":
    main()
