#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails if the includes of modules/, adapters/ and apps/ contradict their order, or if a class has two definitions:
check_includes.py [SOURCES]. Prints the packages of modules/ with their modules, lowest first.

A package includes only packages that precede it in modules/CMakeLists.txt; a module, headers only of core and of modules
in its DEPENDS. No modules depend on each other in a circle; nor do components of a module (a header with its source). Public headers are interfaces: the private components behind them may
include them, and the sources of FACTORIES what implements them. A linker joins classes of equal names without a word;
those of a source belong into an unnamed namespace."""

import pathlib
import re
import sys

INCLUDE = re.compile(r'^#include [<"]([^>"]+)[>"]', re.MULTILINE)
PACKAGE = re.compile(r"^add_subdirectory\((\w+)\)", re.MULTILINE)
MODULE = re.compile(r"slalom_add_module\((\w+)([^)]*)\)")
# Layout of clang-format: nothing within a namespace is indented.
SCOPE = re.compile(r"^namespace ?([\w:]*) \{$|^\}  // namespace|^(?:class|struct|union|enum class) ([\w:<>]+)[^;]*\{")
# Their headers declare an interface, their sources make or call what implements it.
FACTORIES = ["modules/generation/generator", "modules/run/methods/registry", "modules/world/references/reference",
             "modules/world/robot/vehicle", "modules/run/simulation/simulate"]


class Sources:
    def __init__(self, root):
        self.root = root
        self.folders, self.allowed = {"core": "modules/base/core"}, {}  # of modules by name; names by folder
        packages = root / "modules/CMakeLists.txt"
        self.packages = PACKAGE.findall(packages.read_text()) if packages.exists() else []  # lowest first
        self.public, self.private, self.files = {}, {}, []  # headers by the name that is included; all
        for top in ("modules", "adapters", "apps"):
            for path in sorted((root / top).rglob("*")):
                if path.name == "CMakeLists.txt":
                    self.read_modules(path)
                elif path.suffix in (".h", ".cpp"):
                    self.files.append(path)
        for path in self.files:
            _, include, name = str(path.relative_to(root)).partition("/include/")
            if include:
                self.public[name] = path
            elif path.suffix == ".h":
                self.private[self.unit(path), path.name] = path

    def read_modules(self, path):
        unit = "/".join(path.relative_to(self.root).parts[:-1])
        for name, arguments in MODULE.findall(path.read_text()):
            depends = re.search(r"\bDEPENDS\b([a-z_\s]*)", arguments)
            self.folders[name] = unit
            self.allowed.setdefault(unit, ["core"]).extend(depends.group(1).split() if depends else [])

    def unit(self, path):
        """The folder of the module, adapter or program of a file."""
        parts = path.relative_to(self.root).parts
        return next((folder for n in (2, 3) if (folder := "/".join(parts[:n])) in self.allowed), "/".join(parts[:2]))

    def floor(self, unit):
        """The number of the package of a module's folder, 1 for the lowest; None outside packages."""
        top, package, *_ = f"{unit}//".split("/")
        return self.packages.index(package) + 1 if top == "modules" and package in self.packages else None

    def component(self, path):
        return f"{self.unit(path)}/{path.stem}"

    def included(self, path):
        """The headers of modules, adapters and programs that a file includes."""
        for name in INCLUDE.findall(path.read_text()):
            header = self.public.get(name) or self.private.get((self.unit(path), pathlib.Path(name).name))
            if header:
                yield header


def foreign(sources):
    """Includes of modules that are not among the dependencies."""
    for path in sources.files:
        allowed = sources.allowed.get(sources.unit(path))
        if allowed is None:
            continue
        folders = {sources.folders.get(name) for name in allowed} | {sources.unit(path)}
        for header in sources.included(path):
            if sources.unit(header) not in folders:
                name = sources.unit(header).rpartition("/")[2]
                yield f"{path.relative_to(sources.root)}: {name} is not in the DEPENDS of its module"


def climbs(sources):
    """Modules that depend on a package above theirs."""
    for unit, names in sources.allowed.items():
        for name in names:
            here, there = sources.floor(unit), sources.floor(sources.folders.get(name, name))
            if here and there and there > here:
                yield f"{unit}: {name} is in a package above it"


def graph(sources):
    """By component, those of the same module that it includes."""
    public = {sources.component(path) for path in sources.public.values()}
    edges = {}
    for path in sources.files:
        here = sources.component(path)
        if path.suffix == ".cpp" and here in FACTORIES:
            continue
        for header in sources.included(path):
            there = sources.component(header)
            is_interface = there in public and here not in public
            if there != here and sources.unit(header) == sources.unit(path) and not is_interface:
                edges.setdefault(here, set()).add(there)
    return edges


def modules(sources):
    """By module, its dependencies."""
    return {unit: {sources.folders.get(name, name) for name in names} - {unit} for unit, names in sources.allowed.items()}


def circles(edges):
    """A circle through each component that is in one and was in none before."""
    seen = set()
    for start in sorted(edges):
        if start in seen:
            continue
        came_from, open_ = {}, [start]
        while open_ and start not in came_from:
            here = open_.pop(0)
            for there in sorted(edges.get(here, ())):
                if there not in came_from:
                    came_from[there] = here
                    open_.append(there)
        if start in came_from:
            circle = [start]
            while len(circle) == 1 or circle[-1] != start:
                circle.append(came_from[circle[-1]])
            seen.update(circle)
            yield " -> ".join(reversed(circle))


def classes(path):
    """The full names of the classes that a file defines outside unnamed namespaces."""
    scopes = []
    for line in path.read_text().splitlines():
        if found := SCOPE.match(line):
            if found[2]:
                if "" not in scopes:
                    yield "::".join([*scopes, found[2]])
            elif found[1] is not None:
                scopes.append(found[1])
            elif scopes:
                scopes.pop()


def homonyms(sources):
    """Classes with more than one definition."""
    files = {}
    for path in sources.files:
        for name in classes(path):
            files.setdefault(name, set()).add(str(path.relative_to(sources.root)))
    for name, where in files.items():
        if len(where) > 1:
            yield f"{name} is defined in {' and '.join(sorted(where))}"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
    sources = Sources(root if root.is_dir() else root.parent.parent)
    findings = sorted({*foreign(sources), *climbs(sources)}) + list(circles(modules(sources))) + list(circles(graph(sources)))
    findings += homonyms(sources)
    for number, package in enumerate(sources.packages, 1):
        names = (folder.rpartition("/")[2] for folder in sources.allowed if sources.floor(folder) == number)
        print(f"{number} {package}: {', '.join(dict.fromkeys(names))}")
    print("\n".join(findings), end="\n" if findings else "")
    sys.exit(len(findings) > 0)


if __name__ == "__main__":
    main()
