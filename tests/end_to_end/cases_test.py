# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases with [[validate]] show what they say, from the case file to the verdicts."""

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
                self.ok(IC, "generate", case, "-o", "case.hdf", "--no-report")
                out = self.ok(SPH, "run", "case.hdf", "-o", "out", "--strict")
                print(case, out[out.index("what the case"):], sep="\n")
                with open(self.path("out", "validation.json")) as f:
                    verdicts = [v["verdict"] for v in json.load(f)]
                self.assertEqual(set(verdicts), {"ok"})
                nVerdicts += len(verdicts)
        self.assertGreaterEqual(nVerdicts, 10)  # three cases carry as many


if __name__ == "__main__":
    unittest.main(verbosity=2)
