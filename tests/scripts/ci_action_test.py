#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Executes the steps of the action for GitHub: ci_action_test.py SOURCE_FOLDER. SLALOM_BIN is the folder of the programs.
77 without yaml, curl or zstd."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

try:
    import yaml
except ImportError:
    print("Skipped: needs the package python3-yaml")
    sys.exit(77)
for program in ("curl", "zstd"):
    if not shutil.which(program):
        print(f"Skipped: needs the package {program}")
        sys.exit(77)

BIN = pathlib.Path(os.environ["SLALOM_BIN"])
SOURCE = pathlib.Path(sys.argv[1]).resolve()
FOLDER = SOURCE / "examples" / "ci"
ACTION = yaml.safe_load((FOLDER / "action.yml").read_text())
METHOD = SOURCE / "examples" / "library_method" / "my_method.c"
CAMPAIGN = """[campaign]
methods = planner
[scenarios]
generator = random
count = 12
[method.planner]
adapter = library
plugin = planner.so
"""


def archive_of(folder):
    """An archive whose programs are those of the build, with the header for methods."""
    programs = folder / "slalom-0.1.0-x86_64" / "bin"
    shutil.copytree(SOURCE / "modules/run/methods/include", programs.parent / "include")
    programs.mkdir()
    for name in ("slalom-evaluate", "slalom-analyze"):
        (programs / name).write_text(f'#!/bin/sh\nexec "{BIN / name}" "$@"\n')
        (programs / name).chmod(0o755)
    archive = folder / "slalom.tar.zst"
    subprocess.run(["tar", "--zstd", "-cf", archive, "-C", folder, programs.parent.name], check=True)
    return archive.as_uri()


def play(inputs, folder):
    """The name of the step that fails, and the summary."""
    values = {name: text.get("default", "") for name, text in ACTION["inputs"].items()} | inputs
    missing = [name for name, text in ACTION["inputs"].items() if text.get("required") and not values[name]]
    assert not missing and values.keys() == ACTION["inputs"].keys(), (missing, values)
    path, summary = folder / "path", folder / "summary"
    (folder / "temp").mkdir(parents=True)
    path.touch()
    for step in ACTION["runs"]["steps"]:
        if "uses" in step:  # keeps a folder, whatever happened
            assert step["if"] == "always()" and (folder / step["with"]["path"]).is_dir()
            continue
        fill = lambda text: re.sub(r"\$\{\{ inputs\.(\w+) \}\}", lambda match: values[match.group(1)], text)
        assert "${{" not in step["run"], "an input would be part of the program"
        environment = dict(os.environ, RUNNER_TEMP=str(folder / "temp"), GITHUB_PATH=str(path),
                           GITHUB_STEP_SUMMARY=str(summary), **{k: fill(v) for k, v in step["env"].items()})
        environment["PATH"] = ":".join(path.read_text().split() + [os.environ["PATH"]])
        run = subprocess.run(["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", step["run"]], cwd=folder,
                             env=environment, capture_output=True, text=True)
        if run.returncode != 0:
            return step["name"], run.stdout + run.stderr
    return None, summary.read_text()


with tempfile.TemporaryDirectory() as temporary:
    root = pathlib.Path(temporary)
    inputs = {"archive": archive_of(root), "campaign": "planner.ini", "method": "planner",
              "build": f'cc -O2 -shared -fPIC -I"$SLALOM"/include -o planner.so "{METHOD}" -lm',
              "released": str(root / "released" / "slalom" / "runs.results"),
              "gates": "success >= -0.02\nsafety >= -0.05\n"}
    folders = {}
    for name, keys in {"released": "", "same": "", "worse": "look_ahead = 0.05\n"}.items():
        folders[name] = root / name
        folders[name].mkdir()
        (folders[name] / "planner.ini").write_text(CAMPAIGN + keys)
    failed, text = play(inputs, folders["released"])
    assert failed is None, (failed, text)  # compared with itself

    same = folders["same"]
    failed, text = play(inputs, same)
    assert failed is None, (failed, text)
    assert "gate success >= -0.02" in text and "gate safety >= -0.05" in text and "FAILED" not in text, text
    badge = json.loads((same / "slalom" / "badge.json").read_text())
    assert badge["schemaVersion"] == 1 and re.fullmatch(r"[01]\.\d\d \[[01]\.\d\d, [01]\.\d\d\]", badge["message"]), badge
    assert (same / "slalom" / "report" / "index.html").exists()

    failed, text = play(inputs, folders["worse"])
    assert failed == "Gate" and "FAILED" in text, (failed, text)

    failed, text = play(inputs | {"build": "cc no_such_file.c"}, root / "unbuilt")
    assert failed == "Build" and "no_such_file.c" in text, (failed, text)

# The workflow gives the inputs that the action has.
workflow = yaml.safe_load((FOLDER / "workflow.yml").read_text())
(step,) = [s for job in workflow["jobs"].values() for s in job["steps"] if "with" in s]
assert step["with"].keys() <= ACTION["inputs"].keys(), step
