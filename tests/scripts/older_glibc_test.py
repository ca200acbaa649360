#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A library loads without the version that one of its functions had: older_glibc_test.py SOURCE_FOLDER

In place of glibc stands a library of two versions, NEW_1 and NEW_2, of which an older system has the first one only."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

tool = pathlib.Path(sys.argv[1]) / "scripts/older_glibc.py"
folder = pathlib.Path(tempfile.mkdtemp())
load = "import ctypes, sys; print(ctypes.CDLL(sys.argv[1]).user())"


def make(name: str, code: str, *flags: str) -> None:
    (folder / "code.c").write_text(code)
    command = ["cc", "-shared", "-fPIC", f"-Wl,-soname,{name}", "-Wl,-rpath,$ORIGIN", "-L."]
    subprocess.run([*command, "code.c", *flags, "-o", name], cwd=folder, check=True)


def call(*command: object) -> str:
    run = subprocess.run([str(part) for part in command], cwd=folder, capture_output=True, text=True)
    return run.stdout.strip() if run.returncode == 0 else "error: " + run.stderr.strip().split("\n")[-1]


def expect(result: str, text: str) -> None:
    assert text in result, f"'{result}'; expected '{text}'"


try:
    (folder / "new.map").write_text("NEW_1 { global: one; local: *; };\nNEW_2 { global: two; third; } NEW_1;\n")
    (folder / "old.map").write_text("NEW_1 { global: one; local: *; };\n")
    make("libversions.so", "int one() { return 1; } int two() { return 2; } int third() { return 3; }",
         "-Wl,--version-script=new.map")
    make("libreplaced.so", "int two() { return 20; }")
    make("libuser.so", "int one(), two(); int user() { return one() + two(); }",
         "-Wl,--no-as-needed", "-lversions", "-lreplaced")
    make("libgreedy.so", "int one(), two(), third(); int user() { return one() + two() + third(); }", "-lversions")
    make("libalone.so", "int two(); int user() { return two(); }", "-nostdlib", "-lversions")

    expect(call(sys.executable, "-c", load, folder / "libuser.so"), "3")
    expect(call(tool, "libgreedy.so", "two"), "libgreedy.so: more functions of the version of two: ")
    expect(call(tool, "libalone.so", "two"), "libalone.so: no other version beside that of two")
    expect(call(tool, "libuser.so", "four"), "libuser.so: no undefined function four with a version")
    expect(call(tool, "new.map", "two"), "new.map: expected an ELF file for 64 bits")

    make("libversions.so", "int one() { return 1; }", "-Wl,--version-script=old.map")
    expect(call(sys.executable, "-c", load, folder / "libuser.so"), "version `NEW_2' not found")
    expect(call(tool, "libuser.so", "two"), "libuser.so: no longer needs NEW_2 for two")
    expect(call(sys.executable, "-c", load, folder / "libuser.so"), "21")
    expect(call(tool, "libuser.so", "two"), "libuser.so: no undefined function two with a version")
finally:
    shutil.rmtree(folder)
