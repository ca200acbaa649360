#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the 500 test cases of CrowdNav (circle crossing, five people) as scenarios: crowdnav-500.py FOLDER

    slalom-scenarios import FOLDER/*.scenario.yaml -o crowdnav-500.scenarios

Chen, Liu, Kreiss and Alahi: Crowd-robot interaction (ICRA 2019); crowd_sim/envs/crowd_sim.py of vita-epfl/CrowdNav. Case k
has the seed 1000 + k of numpy's legacy generator. Sine and cosine round correctly, so that starts are equal to the bit on
all machines. For the hash see docs/reference/testbeds.md: slalom-scenarios list crowdnav-500.scenarios --hash"""
import math
import pathlib
import random
import sys
from decimal import Decimal, localcontext

CASES, PEOPLE, FIRST_SEED = 500, 5, 1000
CIRCLE, RADIUS, SPEED, GAP = 4.0, 0.3, 1.0, 0.2  # m, m/s
HALF_SIDE = 12  # m, so far away that walls do not matter
ROBOT = [(0.0, -CIRCLE), (0.0, CIRCLE)]  # start and goal


def numpy_random(seed):
    """Its random() gives the numbers of numpy.random.seed(seed), which begins otherwise than Python's seed()."""
    state = [seed]
    for i in range(1, 624):
        state.append((1812433253 * (state[-1] ^ (state[-1] >> 30)) + i) & 0xFFFFFFFF)
    generator = random.Random()
    generator.setstate((3, (*state, 624), None))
    return generator


def cos_sin(angle):
    """Of an angle from 0 to 2 pi, as series of 60 digits."""
    with localcontext() as context:
        context.prec = 60
        sums, term, i = [Decimal(0), Decimal(0)], Decimal(1), 0
        while i < 10 or abs(term) > Decimal(10) ** -50:
            sums[i % 2] += -term if i % 4 >= 2 else term
            i += 1
            term = term * Decimal(angle) / i
        return float(sums[0]), float(sums[1])


def people(case):
    """Starts; goals are opposite to them."""
    generator = numpy_random(FIRST_SEED + case)
    places, starts = list(ROBOT), []
    while len(starts) < PEOPLE:
        cos, sin = cos_sin(generator.random() * math.pi * 2)
        noise = [(generator.random() - 0.5) * SPEED for _ in range(2)]
        x, y = CIRCLE * cos + noise[0], CIRCLE * sin + noise[1]
        if any(math.sqrt((x - a) ** 2 + (y - b) ** 2) < 2 * RADIUS + GAP for a, b in places):
            continue
        starts.append((x, y))
        places += [(x, y), (-x, -y)]
    return starts


def scenario(case):
    lines = [f"name: crowdnav_{case:03}", "representation: continuous",
             f"bounds: [{-HALF_SIDE}, {-HALF_SIDE}, {HALF_SIDE}, {HALF_SIDE}]",
             f"start: [{ROBOT[0][0]!r}, {ROBOT[0][1]!r}, {math.pi / 2!r}]", f"goal: [{ROBOT[1][0]!r}, {ROBOT[1][1]!r}]",
             "people:"]
    for i, (x, y) in enumerate(people(case)):
        lines += [f"  - id: person_{i}", f"    radius: {RADIUS}", f"    speed: {SPEED}", f"    start: [{x!r}, {y!r}]",
                  f"    route: [[{-x!r}, {-y!r}]]"]
    return "\n".join(lines + ["discs: []", "polygons: []", ""])


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        print(__doc__, file=sys.stdout if sys.argv[1:] in (["-h"], ["--help"]) else sys.stderr)
        return 0 if sys.argv[1:] in (["-h"], ["--help"]) else 2
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for case in range(CASES):
        (folder / f"crowdnav_{case:03}.scenario.yaml").write_text(scenario(case), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
