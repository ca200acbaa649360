#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures again what others have published, from their own files: scripts/studies/replayed.py FOLDER [SET...]

Makes the table of docs/results/replayed.md as FOLDER/replayed.md. FOLDER has clones of the repositories that CLONES
names, also bare ones, as `git clone --bare https://github.com/OWNER/NAME FOLDER/NAME`. Only files of the commits that stand
there are read, so that the hash of the commit names the data. Sets without a clone are left out. Environment variables:
JOBS, the number of workers (2); SLALOM_BIN, the folder of the programs.
"""

import csv
import io
import json
import math
import pathlib
import random
import re
import statistics
import subprocess
import sys
import tarfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from baseline_tables import BIN, CAMPAIGN, JOBS, call, folder_argument  # noqa: E402

CLONES = {
    "turtlebot3_local_planner_benchmark": ("gabencui001", "d1c5f9c40fb474ca58b4d45e3938efee95b4483b"),
    "ros_local_planner_benchmark": ("OmerMTKaya", "66e7372ce8bdb07f83358f5bb87dd8d9ad2d2b4e"),
    "jackal_timer": ("dperille", "3408290340729aab0620863472cc9480671eebd7"),
    "barn-challenge-2026": ("zebra314", "5c2281be9da5b901080f0b914e518f98df1230ee"),
}
# The laser of TurtleBot 3 in Gazebo: 360 rays, 3.5 m, noise of 0.01 m.
TURTLEBOT = {"sensor": {"rays": 360, "aperture_deg": 359, "max_range": 3.5, "noise_sigma": 0.01}}
REPETITIONS = 10


class Clone:
    """Files of one commit of a repository."""

    def __init__(self, folder, name):
        self.path, self.commit, self.work = folder / name, CLONES[name][1], folder / "files" / name

    def read(self, path):
        command = ["git", "-C", self.path, "show", f"{self.commit}:{path}"]
        return subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout.decode(errors="replace")

    def file(self, path, name=None):
        """A copy of a file of text, with another name if one is given."""
        copy = self.work / (name or pathlib.Path(path).name)
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(self.read(path))
        return copy

    def tree(self, *paths):
        """Copies of folders, or of files of other kinds than texts."""
        command = ["git", "-C", self.path, "archive", self.commit, *paths]
        archive = subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout
        with tarfile.open(fileobj=io.BytesIO(archive)) as tar:
            tar.extractall(self.work, filter="data")
        return self.work


def runs_of(campaign, list_file, sections):
    """The runs of a campaign in a list, by the lines of dump."""
    ini = campaign.with_suffix(".ini")
    text = f"[campaign]\nname = {campaign.name}\nrepetitions = {REPETITIONS}\nmethods = dwa\n[scenarios]\nlist = {list_file}\n"
    for section, keys in sections.items():
        text += f"[{section}]\n" + "".join(f"{key} = {value}\n" for key, value in keys.items())
    ini.write_text(text)
    results = campaign.with_suffix(".results")
    call(BIN / "slalom-simulate", "run", "-c", ini, "-o", results, "-j", JOBS, "--quiet")
    return runs_in(results)


def runs_in(results):
    return [json.loads(line) for line in call(BIN / "slalom-analyze", "dump", results).splitlines()]


def value(run, metric):
    return run["metrics"][metric]["value"]


def move_base(files, **simulation):
    """A robot with move_base and a dynamic window, as its files of parameters have it."""
    source = {"from": ", ".join(str(file) for file in files)}
    simulation = {**source, "resolution": 0.01, **simulation}
    return {"robot": source, "simulation": simulation, **TURTLEBOT, "method.dwa": {**source, "map": "known"}}


def row(name, quantity, ours, theirs, unit="", digits=2, center=statistics.mean):
    """The means over scenarios of the centers of their runs, here and published, and their ratio with a bootstrap interval
    (95 %) over the runs of each scenario: lists by scenario."""
    draw = random.Random(1)
    groups = [key for key in theirs if ours.get(key) and theirs[key]]
    mean = lambda values: statistics.mean(center(values[key]) for key in groups)
    again = lambda values: {key: draw.choices(values[key], k=len(values[key])) for key in groups}
    drawn = sorted(mean(again(ours)) / mean(again(theirs)) for _ in range(2000))
    published, here = mean(theirs), mean(ours)
    interval = f"{here / published:.3f} [{drawn[50]:.3f}, {drawn[1949]:.3f}]"
    return f"| {name} | {quantity} | {published:.{digits}f}{unit} | {here:.{digits}f}{unit} | {interval} |"


def turtlebot3(clone, work):
    """The static world, which a dynamic window crosses three times."""
    world = clone.file("worlds/Static/world.model", "static.world")
    names = ["dwa_local_planner_params_waffle_pi", "costmap_common_params_waffle_pi", "local_costmap_params"]
    files = [clone.file(f"param/{name}.yaml") for name in [*names, "global_costmap_params", "move_base_params"]]
    scenarios = work / "turtlebot3.scenarios"
    call(BIN / "slalom-scenarios", "import", world, "--start", "13,-2,0", "--goal", "-4,-2", "-o", scenarios)
    # The logs end 0.11 to 0.14 m from the goal.
    runs = runs_of(work / "turtlebot3", scenarios, move_base(files, goal_tolerance=0.14))
    times, lengths = [], []
    for number in (1, 2, 3):
        # A plan, written in part, follows the log.
        lines = [line.split(";") for line in clone.read(f"worlds/Static/Results/0{number}dwa.txt").splitlines()[1:]]
        log = [[float(field) for field in line] for line in lines if len(line) == 7 and line[0].isdigit()]
        times.append(log[-1][1] - log[0][1])
        lengths.append(log[-1][5])
    arrived = [run for run in runs if run["outcome"] == "success"]
    name = "[TurtleBot 3, dynamic window](#turtlebot-3)"
    return [
        row(name, "arrivals", {0: [run in arrived for run in runs]}, {0: [True] * len(times)}),
        row(name, "time", {0: [value(run, "time_to_goal") for run in arrived]}, {0: times}, " s", 1),
        row(name, "length of the path", {0: [value(run, "path_length") for run in arrived]}, {0: lengths}, " m"),
    ]


def kaya(clone, work):
    """Ten goals one after another in an arena with four boxes, ten times, with a dynamic window."""
    world = clone.file("lpb_ws/src/test/worlds/duraganOrt.world")
    navigation = "lpb_ws/src/turtlebot3/turtlebot3_navigation/param"
    names = ["costmap_common_params_burger", "local_costmap_params", "move_base_params"]
    files = [clone.file("lpb_ws/src/my_nav_cfg/param/preliminary_study/dwa_same.yaml")]
    files += [clone.file(f"{navigation}/{name}.yaml") for name in names]
    script = clone.read("lpb_ws/src/test/scripts/nav_measurements_fs.py")
    found = re.findall(r"'x': ([\d.]+), 'y': ([\d.]+), 'theta': *(-?)math.radians\((\d+)\)", script)
    goals = [(float(x), float(y), math.radians(float(sign + angle))) for x, y, sign, angle in found]
    pairs = work / "kaya.csv"
    with open(pairs, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["start_x", "start_y", "start_heading", "goal_x", "goal_y", "goal_heading"])
        writer.writerows([*goals[i - 1], *goals[i]] for i in range(len(goals)))
    scenarios = work / "kaya.scenarios"
    call(BIN / "slalom-scenarios", "import", world, "--pairs", pairs, "--robot-radius", "0.15", "-o", scenarios)
    runs = runs_of(work / "kaya", scenarios, move_base(files))
    table = "full_study/raw_results/same/duraganOrt/dwa_2026-04-21_14-45-09.csv"
    rows = csv.DictReader(io.StringIO(clone.read(f"lpb_ws/src/test/docs_tables_media/{table}")))
    trials = [trial for trial in rows if trial["Trial"].isdigit()]
    leg_of_run = lambda run: int(re.search(r"(\d+)$", run["scenario"]["name"])[1]) - 2  # line 1 has the names
    leg_of_trial = lambda trial: (int(trial["Trial"]) - 1) % len(goals)

    def by_leg(values, leg, number):
        legs = {}
        for one in values:
            legs.setdefault(leg(one), []).append(number(one))
        return legs

    arrived = [run for run in runs if run["outcome"] == "success"]
    succeeded = [trial for trial in trials if trial["Success"] == "Yes"]
    name = "[Kaya and Uslu, dynamic window](#kaya-and-uslu)"
    ours = lambda metric: by_leg(arrived, leg_of_run, lambda run: value(run, metric))
    theirs = lambda column: by_leg(succeeded, leg_of_trial, lambda trial: float(trial[column]))
    success = by_leg(runs, leg_of_run, lambda run: run["outcome"] == "success")
    published = by_leg(trials, leg_of_trial, lambda trial: trial["Success"] == "Yes")
    legs = [(statistics.mean(published[leg]), statistics.mean(success[leg])) for leg in sorted(published)]
    print("success by leg, published and here:", legs, file=sys.stderr)
    collisions = sum(run["outcome"] == "collision" for run in runs)
    print(f"collisions: {collisions} of {len(runs)}", file=sys.stderr)
    return [
        row(name, "arrivals", success, published),
        row(name, "time, median", ours("time_to_goal"), theirs("Navigation Time (s)"), " s", 1, statistics.median),
        row(name, "length of the path, median", ours("path_length"), theirs("Executed Path Length (m)"), " m", 2, statistics.median),
    ]


def barn_trials(clone, work):
    """The worlds of BARN with even numbers, with a dynamic window and with elastic bands."""
    folder = clone.tree("benchmarking_dataset/grid_files", "benchmarking_dataset/path_files") / "benchmarking_dataset"
    scenarios = work / "trials.scenarios"
    import_worlds = [BIN / "slalom-scenarios", "import", folder, "--worlds", "0-299/even", "--task", "trials"]
    call(*import_worlds, "-o", scenarios)
    keys = ["robot.radius=0.21", "robot.max_v=0.5", "robot.max_w=1.57", "robot.delay_tau=0.1"]
    keys += ["simulation.goal_tolerance=0.387", "simulation.max_time=50", "simulation.stuck_time=49"]
    keys += ["campaign.methods=dwa_ros,eband", "method.dwa_ros.inflation_radius=0.3", "method.eband.inflation_radius=0.3"]
    keys += ["method.dwa_ros.footprint_padding=0.055", "method.dwa_ros.controller_patience=15"]
    keys += ["method.dwa_ros.planner_patience=5"]
    results = work / "trials.results"
    command = [BIN / "slalom-simulate", "run", "-c", CAMPAIGN, "--scenarios", scenarios, "-o", results, "-j", JOBS]
    call(*command, "--quiet", *(part for key in keys for part in ("--set", key)))
    runs = runs_in(results)
    trials = list(csv.reader(io.StringIO(clone.read("benchmarking_dataset/ordered_sim_trials.csv"))))
    arrives = lambda time: time != 30 and time < 49.9
    rows = []
    for method, first, label in (("dwa_ros", 0, "dynamic window"), ("eband", 5, "elastic bands")):
        success, time, published, times = {}, {}, {}, {}
        for run in runs:
            if run["method"] != method:
                continue
            world = int(run["scenario"]["name"].split("_")[-1])
            values = [float(number) for number in trials[world][first : first + 5]]
            success[world] = [run["outcome"] == "success"]
            published[world] = [arrives(one) for one in values]
            if success[world][0] and any(published[world]):
                time[world] = [value(run, "time_to_goal")]
                times[world] = [one for one in values if arrives(one)]
        name = f"[BARN, {label}](#barn-2020)"
        rows.append(row(name, "arrivals", pooled(success), pooled(published)))
        rows.append(row(name, "time", pooled(time), pooled(times), " s", 1))
    return rows


def pooled(groups):
    """One group: the means of each."""
    return {0: [statistics.mean(values) for values in groups.values()]}


def barn_2026(clone, work):
    """An entry of 2026: its score with the length of Slalom's shortest path in place of that of a published one."""
    worlds = range(0, 300, 6)
    copies = [clone.file(f"jackal_helper/worlds/BARN/world_{world}.world") for world in worlds]
    scenarios = work / "barn_2026.scenarios"
    call(BIN / "slalom-scenarios", "import", *copies, "-o", scenarios)
    command = [BIN / "slalom-scenarios", "reference", scenarios, "--robot-radius", "0.21", "--json"]
    references = [json.loads(line) for line in call(*command).splitlines()]
    shortest = {int(one["name"].split("_")[-1]): one["shortest_length"] for one in references}
    ours, theirs = {}, {}
    for line in clone.read("res/2026-01-05-mpc.txt").splitlines():
        world, success, _, _, time, score = (float(field) for field in line.split())
        best = shortest[int(world)] / 2  # at 2 m/s
        ours.setdefault(int(world), []).append(success * best / min(max(time, 2 * best), 8 * best))
        theirs.setdefault(int(world), []).append(score)
    return [row("[BARN 2026, an entry](#barn-2026)", "score", ours, theirs, "", 3)]


SETS = {
    "turtlebot3": (turtlebot3, "turtlebot3_local_planner_benchmark"),
    "kaya": (kaya, "ros_local_planner_benchmark"),
    "barn_trials": (barn_trials, "jackal_timer"),
    "barn_2026": (barn_2026, "barn-challenge-2026"),
}


def main():
    folder = folder_argument(__doc__)
    rows = ["| published runs | quantity | published | here | here / published |", "|---|---|---|---|---|"]
    for name in sys.argv[2:] or SETS:
        if name not in SETS:
            sys.exit(f"{name}: unknown set; expected one of {', '.join(SETS)}")
        measure, repository = SETS[name]
        if not (folder / repository).exists():
            print(f"{name}: {folder / repository} is missing: left out", file=sys.stderr)
            continue
        rows += measure(Clone(folder, repository), folder)
    (folder / "replayed.md").write_text("\n".join(rows) + "\n")
    print(folder / "replayed.md")


if __name__ == "__main__":
    main()
