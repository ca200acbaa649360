# SPDX-License-Identifier: BSD-3-Clause
"""Shared parts of the scripts that make the tables of docs/baselines-*.md: limits.py, people.py, tuned.py."""

import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BIN = ROOT / "build/release/bin"
CAMPAIGN = ROOT / "configs/baselines.ini"
JOBS = os.environ.get("JOBS", "2")


def folder_argument(usage):
    """The folder of the results, the first argument; without one the usage is printed."""
    if len(sys.argv) < 2:
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


def print_table(header, rows):
    print("| " + " | ".join(header) + " |\n" + "|---" * len(header) + "|")
    for cells in rows:
        print("| " + " | ".join(cells) + " |")
    print()
