#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the table of docs/results/claims.md again: scripts/claims.py FOLDER [NAME...]

Each claim of configs/claims, or of the arguments, is a campaign with a section [claim], described in docs/results/claims.md. It is
judged with each of five seeds; a verdict that changes with the seed is undecided. FOLDER has the campaign and the results, which are continued or used again: delete those of methods that have changed. The
table is written to FOLDER/claims.md. Environment variables: JOBS, the number of workers (2); BARN, the folder of that data
set, without which the claims about it are left out.
"""

import collections
import configparser
import csv
import io
import json
import os
import random
import re
import statistics
import sys
import time

from baseline_tables import BIN, JOBS, ROOT, call, folder_argument

CLAIMS = ROOT / "configs/claims"
# The seeds of the scenarios that judge: others may have been seen when a claim was written.
SEEDS = range(20261128, 20261133)
DIRECTIONS = ["more", "less", "same"]
OPTIONAL = {"url": "", "relevant": "", "barn": "", "footprint": ""}
COMPARISON = {"compare": "METRIC, A, B", "test": "anytime or fixed"}
CORRELATION = {"correlate": "DESCRIPTOR:qBINS, METRIC, METHOD", "least": "a rank correlation above 0"}


def read_claim(path):
    """The keys of [claim], and the text of the campaign."""
    parts = re.split(r"^(?=\[)", path.read_text(), flags=re.M)
    parser = configparser.ConfigParser(interpolation=None)
    parser.read_string("".join(part for part in parts if part.startswith("[claim]")) or "[claim]")
    claim = dict(parser["claim"])
    needed = {"source": "author, title, venue, year", "says": "the claim", "direction": "more, less or same"}
    needed |= CORRELATION if "correlate" in claim else COMPARISON
    for key in claim.keys() - needed.keys() - OPTIONAL.keys():
        sys.exit(f"{path}: [claim] {key}: unknown key; expected one of {', '.join([*needed, *OPTIONAL])}")
    for key, expected in needed.items():
        if not claim.get(key):
            sys.exit(f"{path}: [claim] {key}: missing; expected {expected}")
    if claim["direction"] not in DIRECTIONS:
        sys.exit(f"{path}: [claim] direction: '{claim['direction']}'; expected {needed['direction']}")
    rule = claim.get("correlate") or claim["compare"]
    if len(rule.split(",")) != 3:
        sys.exit(f"{path}: [claim] '{rule}'; expected {needed.get('correlate') or needed['compare']}")
    if claim.get("test", "fixed") not in ("anytime", "fixed"):
        sys.exit(f"{path}: [claim] test: '{claim['test']}'; expected {needed['test']}")
    if claim["direction"] == "same" and claim.get("test") != "fixed":
        sys.exit(f"{path}: [claim] direction: 'same'; expected more or less, or test = fixed")
    return OPTIONAL | claim, "".join(part for part in parts if not part.startswith("[claim]"))


def run_claim(folder, name, claim, methods, seed, until=None):
    """The result file of the campaign FOLDER/NAME.ini with a seed; with a rule in until.txt beside it what has been
    decided."""
    settings = ["--set", "campaign.methods=" + ",".join(methods), "--set", f"campaign.seed={seed}"]
    scenarios = folder / (f"{name}.scenarios" if claim["barn"] else f"{name}-{seed}.scenarios")
    if claim["barn"] and not scenarios.exists():
        options = ["--worlds", claim["barn"], "--task", "trials"]
        call(BIN / "slalom-scenarios", "import", os.environ["BARN"], *options, "-o", scenarios)
    if claim["footprint"]:
        if not scenarios.exists():
            options = ["--seed", str(seed), "-j", JOBS, "--quiet"]
            call(BIN / "slalom-scenarios", "generate", "-c", folder / f"{name}.ini", "-o", scenarios, *options)
        settings += ["--set", "scenarios.generator=", "--set", f"robot.footprint={claim['footprint']}"]
    if scenarios.exists():
        settings += ["--set", f"scenarios.list={scenarios}"]
    common = [*settings, "-j", JOBS, "--quiet"]
    if until:
        call(BIN / "slalom-evaluate", folder / f"{name}.ini", "-o", folder / f"{name}-{seed}", *common, "--until", until)
        return folder / f"{name}-{seed}" / "runs.results"
    results = folder / f"{name}-{seed}.results"
    call(BIN / "slalom-simulate", "run", "-c", folder / f"{name}.ini", "-o", results, *common)
    return results


def verdict(direction, shown, same, beyond):
    """By the direction that has been shown, if one has, and whether the difference is too small to matter, whatever its
    sign, or is not."""
    if direction == "same":
        return "confirmed" if same else "refuted" if beyond else "undecided"
    if same:
        return "refuted: no relevant difference"
    return "undecided" if not shown else "confirmed" if shown == direction else "refuted"


def number(value):
    return "–" if value is None else f"{value:+.3g}"


def p_text(p):
    return "–" if p is None else "p < 0.0001" if p < 0.0001 else f"p = {p:.2g}"


def comparison(folder, name, claim, seed):
    metric, a, b = claim["compare"].replace(" ", "").split(",")
    until = f"compare({metric}, {b}, {a}) decided"
    if claim["relevant"]:
        until += f" within {claim['relevant']}"
    anytime = claim["test"] == "anytime"
    results = run_claim(folder, name, claim, [a, b], seed, until if anytime else None)
    relevant = ["--relevant", claim["relevant"]] if claim["relevant"] else []
    found = json.loads(call(BIN / "slalom-analyze", "compare", results, "--metric", metric, *relevant, "--json"))
    table = found["tables"][0]
    row = next(one for one in (dict(zip(table["columns"], row)) for row in table["rows"]))
    sign = 1 if row["a"] == a else -1  # the program orders methods by their names
    mean, *ends = (None if row[key] is None else sign * row[key] for key in ("difference", "difference.low", "difference.high"))
    low, high = ends if sign > 0 else reversed(ends)
    if anytime:
        answer = (results.parent / "until.txt").read_text()
        decided = re.search(r" is (better|worse) than ", answer)
        same, beyond = " differ by less than " in answer, False
        p = re.search(r"p = ([\d.]+)", answer)
        evidence = f"e-value {1 / float(p[1]):.3g}" if p else "not decided; the interval is that of a fixed number"
    else:
        decided = row["verdict"] in ("better", "worse", "different")
        limit = float(row["relevant"])
        same = row["verdict"] == "identical" or low is not None and -limit < low and high < limit
        beyond = low is not None and (limit < low or high < -limit)
        evidence = f"{p_text(row['p'])}, {row['test']}"
    shown = "" if not decided else "more" if mean > 0 else "less"
    found = verdict(claim["direction"], shown, same, beyond)
    if not anytime and found == "undecided":
        reasons = {"not confirmed": "ranks and means disagree"}
        evidence += ": " + ("by less or more than relevant" if decided else reasons.get(row["verdict"], row["verdict"]))
    interval = "" if low is None else f" [{number(low)}, {number(high)}]"
    effect = f"{metric}, {b} − {a}: {number(mean)}{interval}"
    return found, row["scenarios"], effect, evidence


def ranks(values):
    order = sorted(values)
    return [order.index(value) + (order.count(value) - 1) / 2 for value in values]


def rank_correlation(values):
    """Spearman's, with the places in the list."""
    return statistics.correlation(range(len(values)), ranks(values)) if len(set(values)) > 1 else 0


def correlation(folder, name, claim, seed):
    """The rank correlation over bins, its interval for other runs of the same bins, and the correlation that the true
    rates would have with such runs."""
    rows, metric, method = claim["correlate"].replace(" ", "").split(",")
    results = run_claim(folder, name, claim, [method], seed)
    bins = call(BIN / "slalom-analyze", "table", results, "--rows", rows, "--columns", metric, "--csv")
    bins = [row for row in csv.DictReader(io.StringIO(bins)) if int(row["n"]) > 1]
    if len(bins) < 3:
        sys.exit(f"{name}: {len(bins)} bins of {rows} with runs; expected at least 3")
    counts = [int(row["n"]) for row in bins]
    rates = [float(row["mean"]) for row in bins]
    rho = rank_correlation(rates)
    draw = random.Random(1)
    again = lambda: [sum(draw.random() < p for _ in range(n)) / n for p, n in zip(rates, counts)]
    drawn = sorted(rank_correlation(again()) for _ in range(1000))
    low, high = drawn[25], drawn[974]
    noise = statistics.mean(p * (1 - p) / (n - 1) for p, n in zip(rates, counts))
    spread = statistics.variance(rates)
    ceiling = max(0, 1 - noise / spread) ** 0.5 if spread > 0 else 0
    sign = {"more": 1, "less": -1}[claim["direction"]]
    near, far = (low, high) if sign > 0 else (-high, -low)
    least = float(claim["least"])
    # The noise of the rates lowers both ends of the interval: only the lower one is safe as it is.
    found = "confirmed" if near >= least else "refuted" if far < least * ceiling else "undecided"
    effect = f"rank correlation of {rows.split(':')[0]} and {metric}, {method}: {number(rho)} [{number(low)}, {number(high)}]"
    return found, sum(counts), effect, f"{len(bins)} bins; noise ceiling {ceiling:.2f}"


def judge(folder, name):
    """The claim, its verdict with all seeds, how many seeds have which, and the cells of the first seed. BARN's worlds
    depend on no seed."""
    claim, campaign = read_claim(CLAIMS / f"{name}.ini")
    if claim["barn"] and not os.environ.get("BARN"):
        return claim, "not run", "–", ("–", "–", "needs BARN")
    (folder / f"{name}.ini").write_text(campaign)
    rule = correlation if "correlate" in claim else comparison
    rows = [rule(folder, name, claim, seed) for seed in (SEEDS[:1] if claim["barn"] else SEEDS)]
    found = collections.Counter(row[0] for row in rows)
    verdict = rows[0][0] if len(found) == 1 else "undecided"
    of_seeds = "given worlds" if claim["barn"] else ", ".join(f"{count} {one}" for one, count in found.most_common())
    return claim, verdict, of_seeds, rows[0][1:]


def main():
    folder = folder_argument(__doc__)
    os.chdir(ROOT)  # files that claims name are relative to it
    known = sorted(path.stem for path in CLAIMS.glob("*.ini"))
    names = sys.argv[2:] or known
    for name in names:
        if name not in known:
            sys.exit(f"{name}: no such claim; expected one of {', '.join(known)}")
        read_claim(CLAIMS / f"{name}.ini")
    lines = ["| claim | says | verdict | seeds | scenarios | effect, 95 % | evidence |", "|---|---|---|---|---|---|---|"]
    for name in names:
        begin = time.time()
        claim, found, seeds, (count, effect, evidence) = judge(folder, name)
        print(f"{name}: {found}, {seeds}, {effect}, {evidence}, {time.time() - begin:.0f} s", file=sys.stderr)
        source = f"[{claim['source']}]({claim['url']})" if claim["url"] else claim["source"]
        says = " ".join(f"{claim['says']} {source}".split())
        cells = [f"[{name}](../../configs/claims/{name}.ini)", says, f"**{found}**", seeds, str(count), effect, evidence]
        lines.append("| " + " | ".join(cells) + " |")
    (folder / "claims.md").write_text("\n".join(lines) + "\n")
    print(folder / "claims.md")


if __name__ == "__main__":
    main()
