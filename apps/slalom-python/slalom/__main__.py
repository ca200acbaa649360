# SPDX-License-Identifier: BSD-3-Clause
"""Runs a program of Slalom: `python -m slalom evaluate my.ini` is `slalom-evaluate my.ini`."""

import glob
import os
import sys

from . import _find_program


def main(words: list) -> int:
    """Replaces this process by the program; returns an exit status if it cannot."""
    if words and words[0] in ("--help", "-h"):
        print("usage: python -m slalom PROGRAM [ARGUMENT...]")
        print("PROGRAM is one of " + ", ".join(_programs()))
        return 0
    if not words or words[0] not in _programs():
        given = words[0] if words else "no program"
        print(f"slalom: {given}: expected one of {', '.join(_programs())}", file=sys.stderr)
        return 2
    if sys.prefix != sys.base_prefix:
        # Methods in Python then find the packages of this environment.
        os.environ.setdefault("VIRTUAL_ENV", sys.prefix)
    path = _find_program("slalom-" + words[0])
    sys.stdout.flush()
    os.execv(path, [path, *words[1:]])


def _programs() -> list:
    folder = os.path.dirname(_find_program("slalom-evaluate"))
    return sorted(os.path.basename(path)[len("slalom-") :] for path in glob.glob(os.path.join(glob.escape(folder), "slalom-*")))


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except FileNotFoundError as error:
        print(f"slalom: {error}", file=sys.stderr)
        sys.exit(1)
