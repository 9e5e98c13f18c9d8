# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases with [[validate]] show what they say, from the case file to the verdicts: all of cases/, at
the reduced resolution of their tables [quick]."""

import glob
import json
import unittest

from harness import CASES, IC, SPH, Programs


class Cases(Programs):
    def test_every_verdict_is_ok(self):
        nVerdicts = 0
        for case in sorted(glob.glob(f"{CASES}/*.toml")):
            with open(case) as f:
                if "[[validate]]" not in f.read():
                    continue
            with self.subTest(case=case):
                self.ok(IC, "generate", case, "-o", "case.hdf", "--no-report", "--quick")
                out = self.ok(SPH, "run", "case.hdf", "-o", "out", "--anew")
                print(case, out[out.index("what the case"):], sep="\n")
                with open(self.path("out", "validation.json")) as f:
                    verdicts = [v["verdict"] for v in json.load(f)]
                # A quick run may end before a time that is asked for, but not before all.
                self.assertLessEqual(set(verdicts), {"ok", "not reached"})
                self.assertIn("ok", verdicts)
                nVerdicts += len(verdicts)
        self.assertGreaterEqual(nVerdicts, 20)  # the cases carry more


if __name__ == "__main__":
    unittest.main(verbosity=2)
