#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails if a comment opens without a head, as "Of the parts, ..." or "What it does": check_comments.py [FILE...]

A comment begins with a noun phrase ("A minimal subset: ...") or a verb ("Returns ..."), so that its first words say what it
is about. Without files: those of the repository in C++, JavaScript, Python, CMake and shell."""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
OPENINGS = re.compile(
    r"(Of|Those|That|What|As|Which|Without|By|Whose|Where|With which|(For|In|To|From|At|On|After|Of) (which|whom|what))"
    r"\b(?!-)")
MARKERS = {".h": "//", ".cpp": "//", ".c": "//", ".js": "//", ".py": "#", ".cmake": "#", ".txt": "#", ".sh": "#"}


def openings(text, marker):
    """Number and text of the first line of each comment, also of those behind code."""
    comment = re.compile(rf"^(?P<code>.*?)(?P<marker>{marker}[/!#]*<?) +(?P<text>\S.*)$")
    before = False
    for number, line in enumerate(text.split("\n"), 1):
        match = comment.match(line)
        code = match and match["code"].strip()
        # A "//" of an address or a "#" of a text is not followed by a space and a capital word.
        if match and (code or not before or match["marker"].endswith("<")):
            yield number, match["text"]
        before = bool(match)


def main():
    listed = subprocess.run(["git", "-C", ROOT, "ls-files"], capture_output=True, text=True, check=False).stdout.split("\n")
    paths = [pathlib.Path(name) for name in sys.argv[1:]] or [ROOT / name for name in listed if name]
    count = 0
    for path in paths:
        marker = MARKERS.get(path.suffix)
        if not marker or not path.is_file():
            continue
        for number, text in openings(path.read_text(errors="replace"), marker):
            if OPENINGS.match(text):
                print(f"{path.relative_to(ROOT) if path.is_relative_to(ROOT) else path}:{number}: headless: {text}")
                count += 1
    sys.exit(count > 0)


if __name__ == "__main__":
    main()
