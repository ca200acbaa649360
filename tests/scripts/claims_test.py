#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The ledger of claims, with short campaigns: claims_test.py SOURCE_FOLDER. SLALOM_BIN is the folder of the programs."""
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCES = pathlib.Path(sys.argv.pop(1)).resolve()
BIN = pathlib.Path(os.environ["SLALOM_BIN"])
CLAIMS = sorted((SOURCES / "configs/claims").glob("*.ini"))
# Each disc or box of `avoid` is across the straight path: who goes straight never arrives.
PLANTED = """[claim]
source = A. Author: A Title, 2000
says = Who turns away arrives where who goes straight collides.
compare = success, straight, around
direction = more
test = anytime

[campaign]
methods = straight, around

[scenarios]
generator = avoid
count = 100

[method.straight]
adapter = library
plugin = libslalom_go_to_goal.so

[method.around]
adapter = library
plugin = libslalom_follow_the_gap.so
"""


class Claims(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.results = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.results)

    def setUp(self):
        self.root = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.root)
        (self.root / "scripts").mkdir()
        (self.root / "configs/claims").mkdir(parents=True)
        for name in ("claims.py", "baseline_tables.py"):
            shutil.copy(SOURCES / "scripts" / name, self.root / "scripts")

    def judge(self, text, *names, out=None):
        (self.root / "configs/claims/planted.ini").write_text(text)
        command = [sys.executable, self.root / "scripts/claims.py", out or self.root / "out", *names]
        environment = {key: value for key, value in os.environ.items() if key != "BARN"}
        return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment)

    def row(self, text):
        """The row of a claim. Claims about the same campaign, also those of other tests, share its runs."""
        out = self.results / hashlib.sha256(text.partition("\n\n")[2].encode()).hexdigest()
        run = self.judge(text, out=out)
        self.assertEqual(run.returncode, 0, run.stderr)
        return (out / "claims.md").read_text().split("\n")[2]

    def test_a_claim_is_confirmed_and_its_contrary_refuted(self):
        row = self.row(PLANTED)
        self.assertIn("A. Author: A Title, 2000", row)
        self.assertRegex(row, r"\*\*confirmed\*\* \| 5 confirmed \| \d+ \| success, around − straight: \+[01][.\d]* \[.*\] \| e-value 2\d")
        self.assertIn("**refuted** |", self.row(PLANTED.replace("more", "less")))

    def test_a_fixed_number_of_scenarios_is_judged_by_the_test_of_the_pairs(self):
        self.assertRegex(self.row(PLANTED.replace("anytime", "fixed")), r"\*\*confirmed\*\* \| 5 confirmed \| 100 .* p < 0.0001, exact McNemar test")

    def test_methods_that_do_the_same_confirm_that_they_are_the_same_only(self):
        same = PLANTED.replace("follow_the_gap", "go_to_goal").replace("anytime", "fixed")
        self.assertIn("**refuted: no relevant difference** |", self.row(same))
        self.assertIn("**confirmed** |", self.row(same.replace("more", "same")))
        self.assertIn("**refuted** |", self.row(PLANTED.replace("anytime", "fixed").replace("more", "same")))

    def test_a_verdict_that_changes_with_the_seed_is_undecided(self):
        sys.path.insert(0, str(SOURCES / "scripts"))
        import claims

        claims.CLAIMS = self.root / "configs/claims"
        (claims.CLAIMS / "planted.ini").write_text(PLANTED)
        of_seed = ["confirmed"] * 4 + ["undecided"]
        claims.comparison = lambda folder, name, claim, seed: (of_seed[seed - claims.SEEDS[0]], seed, "effect", "evidence")
        _, verdict, seeds, cells = claims.judge(self.root, "planted")
        self.assertEqual((verdict, seeds), ("undecided", "4 confirmed, 1 undecided"))
        self.assertEqual(cells, (claims.SEEDS[0], "effect", "evidence"))
        of_seed[4] = "confirmed"
        self.assertEqual(claims.judge(self.root, "planted")[1:3], ("confirmed", "5 confirmed"))

    def test_a_difference_too_small_to_matter_is_none_whatever_its_sign(self):
        sys.path.insert(0, str(SOURCES / "scripts"))
        import claims

        for shown in ("more", "less", ""):
            self.assertEqual(claims.verdict("more", shown, True, False), "refuted: no relevant difference")

    def test_a_bad_claim_is_refused_with_what_was_expected(self):
        for text, message in (
            (PLANTED.replace("direction = more\n", ""), "[claim] direction: missing; expected more, less or same"),
            (PLANTED.replace("more", "better"), "[claim] direction: 'better'; expected more, less or same"),
            (PLANTED.replace("success, straight,", "success,"), "[claim] 'success, around'; expected METRIC, A, B"),
            (PLANTED.replace("says", "sayz"), "[claim] sayz: unknown key; expected one of"),
            (PLANTED.replace("more", "same"), "[claim] direction: 'same'; expected more or less, or test = fixed"),
            (PLANTED.replace("anytime", "always"), "[claim] test: 'always'; expected anytime or fixed"),
        ):
            run = self.judge(text)
            self.assertNotEqual(run.returncode, 0)
            self.assertIn("planted.ini: " + message, run.stderr)
        run = self.judge(PLANTED, "plantd")
        self.assertIn("plantd: no such claim; expected one of planted", run.stderr)

    def test_claims_about_data_that_are_not_there_are_not_run(self):
        self.assertIn("**not run** | – | – | – | needs BARN |", self.row(PLANTED.replace("test", "barn = 0-9\ntest", 1)))

    def test_each_claim_is_in_the_ledger_and_its_campaign_runs(self):
        page = (SOURCES / "docs/results/claims.md").read_text()
        self.assertGreaterEqual(len(CLAIMS), 15)
        listed = re.findall(r"^\| \[(\w+)\]\(\.\./\.\./configs/claims/\1\.ini\)", page, re.M)
        self.assertEqual(listed, [path.stem for path in CLAIMS])
        found = [page.count(f"| **{one}") for one in ("confirmed**", "refuted", "undecided**")]
        self.assertEqual(sum(found), len(CLAIMS))
        for name in ("README.md", "docs/results/claims.md", "docs/guide/validity.md"):
            told = re.search(r"(\d+) are confirmed\D+(\d+) refuted\D+(\d+) undecided", (SOURCES / name).read_text())
            self.assertEqual([int(one) for one in told.groups()], found, name)
        for path in CLAIMS:
            if "\nbarn " in path.read_text():
                continue
            campaign = self.root / path.name
            campaign.write_text(path.read_text().partition("\n\n")[2])
            command = [BIN / "slalom-simulate", "run", "-c", campaign, "-o", self.root / "runs.results", "--overwrite"]
            command += ["--set", "scenarios.count=1", "--set", "limits.run_wall_time=600", "--quiet"]
            run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=SOURCES)
            self.assertEqual((run.returncode, run.stderr), (0, ""), path)


unittest.main()
