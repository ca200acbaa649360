#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Statistics and labels of the scripts that make tables: baseline_tables_test.py SOURCE_FOLDER."""
import contextlib
import io
import pathlib
import random
import statistics
import sys
import unittest
import unittest.mock

sys.path.insert(0, str(pathlib.Path(sys.argv.pop(1)).resolve() / "scripts"))

from baseline_tables import folder_argument, kendall_tau, label_rows, noise_ceiling

RATES = [0.95, 0.9, 0.8, 0.7, 0.65, 0.6, 0.5, 0.4]


def campaign(name, rates, draw):
    return {f"{name}_{i}": [draw.random() < rate for rate in rates] for i in range(100)}


def totals(outcomes):
    return [sum(column) for column in zip(*outcomes.values())]


class NoiseCeiling(unittest.TestCase):
    def test_tau_is_that_of_pairs(self):
        self.assertEqual(kendall_tau([1, 2, 3], [4, 5, 6]), 1)
        self.assertEqual(kendall_tau([1, 2, 3], [6, 5, 4]), -1)
        self.assertAlmostEqual(kendall_tau([1, 2, 3], [4, 6, 5]), 1 / 3)
        self.assertAlmostEqual(kendall_tau([1, 1, 2], [1, 2, 3]), 2 / 6**0.5)  # 2 untied pairs of 3, and 3
        self.assertEqual(kendall_tau([1, 1], [1, 2]), 0)

    def test_is_near_the_tau_of_campaigns_with_the_same_true_order(self):
        draw = random.Random(2)
        halved = [rate / 2 for rate in RATES]
        truth = [kendall_tau(totals(campaign("a", RATES, draw)), totals(campaign("b", halved, draw)))
                 for _ in range(200)]
        found = [noise_ceiling(campaign("a", RATES, draw), campaign("b", halved, draw), 60) for _ in range(20)]
        self.assertAlmostEqual(statistics.mean(mean for mean, _ in found), statistics.mean(truth), delta=0.06)
        self.assertAlmostEqual(statistics.mean(low for _, low in found), sorted(truth)[10], delta=0.1)

    def test_does_not_depend_on_which_method_has_which_rank(self):
        draw = random.Random(3)
        first, other = campaign("a", RATES, draw), campaign("b", RATES, draw)
        turned = {scenario: row[::-1] for scenario, row in other.items()}
        self.assertEqual(noise_ceiling(first, other, 20), noise_ceiling(first, turned, 20))

    def test_is_one_for_the_same_outcomes_in_the_same_scenarios(self):
        outcomes = campaign("a", RATES, random.Random(4))
        self.assertAlmostEqual(noise_ceiling(outcomes, outcomes, 20)[1], 1)


class Labels(unittest.TestCase):
    def test_name_who_calls_a_class_of_mrpt_in_rows_only(self):
        markdown = "nd in a sentence\n| method | nd |\n|---|---|\n| nd | 1 |\n| nd_plus | 2 |\n"
        self.assertEqual(label_rows(markdown), markdown.replace("| nd | 1", "| CHolonomicND (Slalom's adapter) | 1"))


class Arguments(unittest.TestCase):
    def test_an_option_is_no_folder(self):
        for arguments, code in ((["--help"], None), (["folder", "--help"], None), (["-o"], "usage"), ([], "usage")):
            with unittest.mock.patch.object(sys, "argv", ["script", *arguments]), contextlib.redirect_stdout(io.StringIO()):
                with self.assertRaises(SystemExit) as ended:
                    folder_argument("usage")
            self.assertEqual(ended.exception.code, code)


unittest.main()
