#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails if the project is larger than .ci/budget says: check_budget.py [SOURCES [PROGRAMS]]

Prints each size beside its budget: lines of product and of tests, public headers of modules, words of documents, and, of
the programs in the folder PROGRAMS, their verbs, flags and keys. A commit that raises a number says what was dropped for
it; one that makes the project smaller lowers it."""

import pathlib
import re
import subprocess
import sys

CODE = {".cpp", ".h", ".hpp", ".c", ".js", ".html", ".css", ".py"}
PRODUCT = ("modules", "adapters", "reactive_algos", "lcm_types", "apps")
FLAG = re.compile(r"^  (--?[\w-]+)", re.MULTILINE)
VERB = re.compile(r"^  ([a-z][\w-]*)  ", re.MULTILINE)


def files(root, folders):
    names = subprocess.run(["git", "ls-files", "-z", "--", *folders], cwd=root, check=True, capture_output=True)
    return [root / name for name in names.stdout.decode().split("\0") if name]


def lines(root, folders):
    return sum(path.read_bytes().count(b"\n") for path in files(root, folders) if path.suffix in CODE)


def sizes_of_sources(root):
    pages = [path for path in files(root, ["README.md", "docs"]) if path.suffix == ".md"]
    headers = [path for path in files(root, ["modules"]) if path.suffix == ".h" and "include" in path.parts]
    return {
        "product_lines": lines(root, PRODUCT),
        "test_lines": lines(root, ["tests"]),
        "public_headers": len(headers),
        "document_words": sum(len(path.read_text().split()) for path in pages),
    }


def sizes_of_programs(folder):
    """Verbs, flags and keys, as --help and --options print them; --help and --version count once per program."""

    def printed(*command):
        return subprocess.run([*command], check=True, capture_output=True, text=True).stdout

    verbs = flags = 0
    for program in sorted(folder.glob("slalom-*")):
        text = printed(program, "--help")
        names = VERB.findall(text.partition("Subcommands:")[2])
        verbs += len(names)
        flags += len(FLAG.findall(text))
        flags += sum(len(FLAG.findall(printed(program, name, "--help"))) - 1 for name in names)
    keys = re.findall(r"^  \w+ = ", printed(folder / "slalom-evaluate", "--options"), re.MULTILINE)
    return {"verbs": verbs, "flags": flags, "keys": len(keys)}


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent).resolve()
    sizes = sizes_of_sources(root)
    if len(sys.argv) > 2:
        sizes |= sizes_of_programs(pathlib.Path(sys.argv[2]).resolve())
    budget = dict(line.split() for line in (root / ".ci/budget").read_text().splitlines())
    over = [name for name, size in sizes.items() if size > int(budget[name])]
    for name, size in sizes.items():
        print(f"{name:15} {size:7} of {int(budget[name]):7}{'  too large' if name in over else ''}")
    sys.exit(len(over) > 0)


if __name__ == "__main__":
    main()
