#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The study of failures: failures_test.py SOURCE_FOLDER. SLALOM_BIN is the folder of the programs."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCES = pathlib.Path(sys.argv.pop(1)).resolve()
BIN = pathlib.Path(os.environ["SLALOM_BIN"])
sys.path.insert(0, str(SOURCES / "scripts/studies"))
import failures  # noqa: E402

# A goal 5 m ahead; a disc in front of it, a square beside the way.
TASK = ([5, 0], [[3, 0, 0.5]], [[[1, 1], [2, 1], [2, 2], [1, 2]]])


def samples(x, y, v, w, clearance, seconds=20):
    """A run that ends at (x, y), where it moves with v and turns with w."""
    return [{"t": t, "x": x + v * (t - seconds), "y": y, "v": v, "w": w, "clearance": clearance} for t in range(seconds + 1)]


class Failures(unittest.TestCase):
    def classified(self, outcome, *run):
        return failures.class_of(outcome, samples(*run), 0.25, TASK)

    def test_the_last_seconds_decide_the_class(self):
        self.assertEqual(self.classified("collision", 2.2, 0, 1, 0, 0), "collides")
        self.assertEqual(self.classified("method_error", 0, 0, 0, 0, 1), "other")
        self.assertEqual(self.classified("stuck", 0, 0, 0, 0.5, 1), "turns in place")
        self.assertEqual(self.classified("stuck", 0, 0, 0, 0, 1), "open")
        self.assertEqual(self.classified("stuck", 2.1, 0, 0, 0, 0.15), "blocked", "the disc hides the goal")
        self.assertEqual(self.classified("timeout", 0, 0, 1, 0, 1), "wanders")
        self.assertEqual(self.classified("stuck", 4.2, 0, 0, 0, 0.4), "visible goal")

    def test_a_line_is_free_where_a_disc_of_the_radius_passes(self):
        free = lambda a, b, radius=0.25: failures.line_is_free(a, b, radius, *TASK[1:])
        self.assertTrue(free([0, 0], [2.2, 0]))
        self.assertFalse(free([0, 0], [5, 0]))
        self.assertTrue(free([0, 0.7], [2.5, 0.7]))
        self.assertFalse(free([0, 0.8], [2.5, 0.8]), "0.2 m beside the square")
        self.assertTrue(free([0, 0.8], [2.5, 0.8], 0.15))

    def test_a_campaign_has_a_row_for_each_method_and_pictures(self):
        with tempfile.TemporaryDirectory() as folder:
            work = pathlib.Path(folder)
            (work / "c.ini").write_text(
                "[campaign]\nmethods = go, gap\n[scenarios]\ngenerator = avoid\ncount = 3\n"
                "[method.go]\nadapter = library\nplugin = libslalom_go_to_goal.so\n"
                "[method.gap]\nadapter = library\nplugin = libslalom_follow_the_gap.so\n")
            run = lambda *command: subprocess.run(command, check=True, cwd=work, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            run(BIN / "slalom-scenarios", "generate", "-c", "c.ini", "-n", "3", "-o", "c.scenarios", "--quiet")
            run(BIN / "slalom-simulate", "run", "-c", "c.ini", "--scenarios", "c.scenarios", "-o", "c.results", "--quiet")
            rows = run(sys.executable, SOURCES / "scripts/studies/failures.py", "c.results", "c.scenarios", "out").stdout.split("\n")
            self.assertEqual(rows[2], "| gap | 0 | 0 | 0 | 0 | 0 | 0 | 0 | 0 |")
            self.assertEqual(rows[3], "| go | 3 | 0 | 0 | 0 | 0 | 3 | 0 | 0 |")
            self.assertEqual(len(list((work / "out").glob("go-collides-*.svg"))), 3)


unittest.main()
