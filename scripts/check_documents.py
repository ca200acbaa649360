#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails if a document has a broken link, or words of a laboratory notebook: check_documents.py [FILE...]

Documents describe the present program to its users: measurements in progress and the history of defects belong in commit
messages. Without files: README.md, CHANGELOG.md, CONTRIBUTING.md, docs/ and the pages of packages,
modules/*/README.md. Code, output and pictures are not read."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Pattern of what is not written, and what is written instead.
WORDS = [
    (r"\bmended\b", "no history of defects"),
    (r"\bthe program before\b|\bprogram of before\b", "compare with another program, or not at all"),
    (r"\bnot reached\b|\bthe mark of \d|\bmarks were\b|^\|.*\| mark \|", "measurements, without targets"),
    (r"\bbeside (one|two|three|four|ten|about|\d+)[^.|]*other programs?\b", "measure on an idle machine"),
    (r"\b(with|under) (a |much |little )?(other )?load\b|\bload of (about )?\d|\bbusy (AMD|processor)\b",
     "measure on an idle machine"),
    (r"\bleast of (\d+|two|three|four|five|several) (rounds|executions|alternating)\b", "say it in one line for all figures"),
    (r"\bpreviously\b|\bformerly\b|\bsince then\b|\bwas found so\b|\bearlier versions? of Slalom\b",
     "describe the present program"),
    (r"\bmovers?\b", "moving obstacle"),
]
LINK = re.compile(r"\]\(([^)\s]+)\)")


def prose(text):
    """The lines outside of blocks of code, numbered from 1, without code and quoted output in them."""
    fence = False
    for number, line in enumerate(text.split("\n"), 1):
        if line.startswith("```"):
            fence = not fence
        elif not fence and not line.startswith(("    ", "<!-- $")):
            yield number, re.sub(r"`[^`]*`|\"[^\"]*\"", "``", line)


def anchors(path):
    """The anchors of a document, as GitHub makes them of headings."""
    found, count = set(), {}
    fence = False
    for line in path.read_text().split("\n"):
        if line.startswith("```"):
            fence = not fence
        heading = None if fence else re.match(r"#+ (.*)", line)
        if heading:
            text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading.group(1)).strip().lower()
            slug = re.sub(r"[^\w\- ]", "", text).replace(" ", "-")
            found.add(slug if slug not in count else f"{slug}-{count[slug]}")
            count[slug] = count.get(slug, 0) + 1
        found.update(re.findall(r'<a name="([^"]+)"', line))
    return found


def broken(path, target):
    """Why a link of a document leads nowhere, or ""."""
    if re.match(r"[a-z]+:", target):
        return ""
    name, _, anchor = target.partition("#")
    file = (path.parent / name).resolve() if name else path
    if not file.exists():
        return "no such file"
    if anchor and file.suffix == ".md" and anchor not in anchors(file):
        return "no such heading"
    return ""


def findings(path):
    for number, line in prose(path.read_text()):
        # Rows about an id repeat the names and the help of the programs.
        words = "" if line.startswith("| ``") else LINK.sub("]()", line)
        for pattern, instead in WORDS:
            for match in re.finditer(pattern, words, re.IGNORECASE):
                yield f"{number}: '{match.group(0)}': {instead}"
        for target in LINK.findall(line):
            why = broken(path, target)
            if why:
                yield f"{number}: ({target}): {why}"


def main():
    names = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md"]
    paths = [pathlib.Path(name) for name in sys.argv[1:]]
    paths = paths or [ROOT / name for name in names] + [
        *sorted((ROOT / "docs").rglob("*.md")), *sorted((ROOT / "modules").glob("*/README.md"))]
    count = 0
    for path in paths:
        for finding in findings(path):
            name = path.relative_to(ROOT) if path.is_relative_to(ROOT) else path
            print(f"{name}:{finding}")
            count += 1
    sys.exit(count > 0)


if __name__ == "__main__":
    main()
