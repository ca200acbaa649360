#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the package FOLDER/slalom as a wheel (PEP 427, PEP 600), with its programs on PATH:
    scripts/wheel.py FOLDER VERSION GLIBC TIME OUT
GLIBC is the number after "2." of the oldest glibc, TIME in s since 1970 that of all files, OUT a folder. Of scripts/wheel.sh.
"""
import base64
import hashlib
import os
import pathlib
import sys
import time
import zipfile

#: A program of the package on PATH; pip replaces the first line.
PROGRAM = """#!python
import runpy
import sys

sys.argv = ["-m", "{}", *sys.argv[1:]]
runpy.run_module("slalom", run_name="__main__", alter_sys=True)
"""


def main(folder: str, version: str, glibc: str, seconds: str, out: str) -> None:
    tag = f"py3-none-manylinux_2_{glibc}_x86_64"
    info = f"slalom-{version}.dist-info"
    record = []
    path = pathlib.Path(out) / f"slalom-{version}-{tag}.whl"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as wheel:

        def write(name: str, content: bytes, mode: int) -> None:
            entry = zipfile.ZipInfo(name, time.gmtime(int(seconds))[:6])
            entry.external_attr = (0o100000 | mode) << 16
            wheel.writestr(entry, content, zipfile.ZIP_DEFLATED, 9)
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            record.append(f'"{name}",sha256={digest},{len(content)}')

        for file in sorted(pathlib.Path(folder, "slalom").rglob("*")):
            if file.is_file():
                mode = 0o755 if os.access(file, os.X_OK) else 0o644
                write(str(file.relative_to(folder)), file.read_bytes(), mode)
        for program in sorted(pathlib.Path(folder, "slalom/bundle/bin").iterdir()):
            text = PROGRAM.format(program.name[len("slalom-") :])
            write(f"slalom-{version}.data/scripts/{program.name}", text.encode(), 0o755)
        metadata = (
            f"Metadata-Version: 2.1\nName: slalom\nVersion: {version}\n"
            "Summary: Evaluation of obstacle avoidance methods for mobile robots\n"
            "License: BSD-3-Clause, and those in slalom/bundle/share/doc/slalom/licenses\n"
            "Requires-Python: >=3.8\n"
        )
        write(f"{info}/METADATA", metadata.encode(), 0o644)
        write(f"{info}/WHEEL", f"Wheel-Version: 1.0\nGenerator: slalom\nRoot-Is-Purelib: false\nTag: {tag}\n".encode(), 0o644)
        lines = "".join(line + "\n" for line in record + [f"{info}/RECORD,,"])
        write(f"{info}/RECORD", lines.encode(), 0o644)
    print(f"{path}: {path.stat().st_size / 1e6:.0f} MB")


if __name__ == "__main__":
    if len(sys.argv) != 6:
        sys.exit(__doc__)
    main(*sys.argv[1:])
