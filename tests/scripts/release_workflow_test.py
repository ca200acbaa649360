#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The workflow of a release calls scripts that exist, with the tools that they need, and only its last job, which executes
nothing of the repository, may write: release_workflow_test.py SOURCE_FOLDER. 77 without yaml."""
import fnmatch
import os
import pathlib
import re
import sys

try:
    import yaml
except ImportError:
    print("Skipped: needs the package python3-yaml")
    sys.exit(77)

source = pathlib.Path(sys.argv[1])
workflow = yaml.safe_load((source / ".github/workflows/release.yml").read_text())
build, publish = workflow["jobs"]["build"], workflow["jobs"]["publish"]
assert workflow["permissions"] == {"contents": "read"} and "permissions" not in build, workflow["permissions"]
assert publish["permissions"] == {"contents": "write"} and publish["needs"] == "build", publish
assert not any("checkout" in step.get("uses", "") for step in publish["steps"]), publish["steps"]

commands = [step["run"] for step in build["steps"] if "run" in step]
scripts = [command.split()[0] for command in commands if command.startswith("scripts/")]
assert {"scripts/package.sh", "scripts/archive.sh", "scripts/wheel.sh"} <= set(scripts), scripts
installed = " ".join(command for command in commands if "apt-get install" in command).split()
for name in ("packages.txt", "packages_test.txt"):
    installed += (source / "scripts" / name).read_text().split()
package_of = {"objdump": "binutils"}
for script in [*scripts, "scripts/bundle.sh"]:
    text = (source / script).read_text()
    assert script == "scripts/bundle.sh" or os.access(source / script, os.X_OK), script
    for tools in re.findall(r"for tool in ([^;]*); do", text) + re.findall(r"^bundle_require (.*)$", text, re.M):
        for tool in re.findall(r"[a-z]+", tools):
            assert tool == "dpkg" or package_of.get(tool, tool) in installed, f"{script} needs {tool}"

version = re.search(r"project\(slalom VERSION (\S+)", (source / "CMakeLists.txt").read_text()).group(1)
patterns = build["steps"][-1]["with"]["path"].split()
for file in (f"slalom-{version}-x86_64.tar.zst", f"slalom-{version}-py3-none-manylinux_2_35_x86_64.whl",
             f"slalom_{version}-1_amd64.deb"):
    assert any(fnmatch.fnmatch(f"build/release/{file}", pattern) for pattern in patterns), (file, patterns)
