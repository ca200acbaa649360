#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Each option of a number, of each verb of each program, with what is no number: option_values_test.py PROGRAM..."""
import re
import subprocess
import sys
import unittest

PROGRAMS = sys.argv[1:]


def run(*command):
    return subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True)


def commands(program):
    """The program with each of its verbs, or alone, and the help."""
    text = run(program, "--help").stdout
    verbs = re.findall(r"^  ([a-z][\w-]*) ", text.partition("Subcommands:")[2], re.M)
    for command in [[program, verb] for verb in verbs] or [[program]]:
        yield command, run(*command, "--help").stdout


class OptionValues(unittest.TestCase):
    def test_what_is_no_number_is_named_with_what_was_expected(self):
        count = 0
        for program in PROGRAMS:
            for command, text in commands(program):
                for option, kind in re.findall(r"(--[a-z-]+) (INT|UINT|FLOAT|NUMBER)\b", text):
                    for value in ("x", "1e999"):
                        answer = run(*command, option, value)
                        count += 1
                        with self.subTest(command=[*command, option, value]):
                            self.assertEqual(answer.returncode, 2)
                            self.assertRegex(answer.stderr, rf"{option}: '{value}' is not valid; expected an? ")
                            self.assertNotRegex(answer.stderr, r"[0-9]{21}|(slalom-\w+): \1| is no |std::")
        self.assertGreater(count, 100)


unittest.main(argv=sys.argv[:1])
