# SPDX-License-Identifier: BSD-3-Clause
"""The diffs in docs/develop/extending.md apply to the tree, one after another, and their sources compile:
extending_test.py SOURCES BUILD"""

import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

# A target with the flags for new sources below a folder; the adapters and methods are new targets there.
TARGETS = {
    "modules/run/metrics/": "slalom_metrics",
    "modules/world/descriptors/": "slalom_descriptors",
    "modules/generation/": "slalom_generation",
    "adapters/": "slalom_library",
    "apps/campaign/": "slalom_app_campaign",
    "reactive_algos/": "slalom_go_to_goal_parts",
    "tests/modules/run/metrics/": "metrics_test",
    "tests/modules/world/descriptors/": "descriptors_test",
}
FOLDERS = ("adapters", "apps", "docs", "lcm_types", "modules", "reactive_algos", "tests")


def diffs(text):
    return re.findall(r"^```diff\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def flags(build, target):
    """The compiler and its options for the sources of a target, whose precompiled header they therefore accept."""
    for entry in json.loads((build / "compile_commands.json").read_text()):
        if f"/{target}.dir/" in entry["command"]:
            break
    else:
        raise SystemExit(f"no source of {target} in compile_commands.json")
    words = shlex.split(entry["command"])
    return words[: words.index("-o")]


def moved(word, sources, build, tree):
    """A path of the sources, but not of the build folder in them, becomes one of the tree."""
    if str(build) in word:
        return word
    return word.replace(str(sources), str(tree))


def by_target(files):
    """The files of each target, each once."""
    found = {}
    for name in files:
        target = next(target for start, target in TARGETS.items() if name.startswith(start))
        found.setdefault(target, {})[name] = None
    return found


def main():
    sources, build = (pathlib.Path(path).resolve() for path in sys.argv[1:])
    found = diffs((sources / "docs/develop/extending.md").read_text())
    assert len(found) >= 5, f"{len(found)} diffs in docs/develop/extending.md"
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        tree = pathlib.Path(folder)
        for name in FOLDERS:
            shutil.copytree(sources / name, tree / name, ignore=shutil.ignore_patterns("corpus", "*.png"))
        for number, diff in enumerate(found, 1):
            applied = subprocess.run(["git", "apply", "-"], input=diff, text=True, cwd=tree)
            if applied.returncode != 0:
                print(f"diff {number} of docs/develop/extending.md does not apply")
                failed = True
        files = [name for diff in found for name in re.findall(r"^\+\+\+ b/(\S+\.cpp)$", diff, re.MULTILINE)]
        for target, together in by_target(files).items():
            command = [moved(word, sources, build, tree) for word in flags(build, target)]
            command += [f"-I{path}" for path in sorted(tree.glob("adapters/*/*/include"))]
            command += ["-fsyntax-only", "-x", "c++", "-"]
            # Compiles in one go, like unity builds: reading the headers takes most of the time.
            lines = "".join(f'#include "{tree / name}"\n' for name in together)
            if subprocess.run(command, input=lines, text=True).returncode != 0:
                print(f"{', '.join(together)} of docs/develop/extending.md: does not compile")
                failed = True
    sys.exit(failed)


if __name__ == "__main__":
    main()
