#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The manifest for colcon and rosdep says what CMake says: package_xml_test.py SOURCE_FOLDER. 77 without catkin_pkg."""
import pathlib
import re
import sys

try:
    from catkin_pkg.package import parse_package
except ImportError:
    print("Skipped: needs the package python3-catkin-pkg")
    sys.exit(77)

source = pathlib.Path(sys.argv[1])
warnings = []
package = parse_package(str(source / "package.xml"), warnings=warnings)
package.validate(warnings=warnings)
assert not warnings, warnings

name, version, description = re.search(
    r'project\((\S+) VERSION (\S+).*?DESCRIPTION "([^"]*)"', (source / "CMakeLists.txt").read_text(), re.S).groups()
assert package.name == name, package.name
assert package.version == version, f"package.xml has {package.version}, CMakeLists.txt {version}"
assert package.description == description, package.description
assert package.get_build_type() == "cmake"
assert (source / package.licenses[0].file).exists(), package.licenses

# Packages of Debian without a key of rosdep are in the command of the documents.
command = re.search(r"\$ sudo apt install (.*)", (source / "docs/start/platforms.md").read_text()).group(1).split()
required = {line for line in (source / "scripts/packages.txt").read_text().split("\n") if line and line[0] != "#"}
assert set(command) <= required, set(command) - required
