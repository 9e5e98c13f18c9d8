# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases with [[validate]] show what they say, from the case file to the verdicts."""

import glob
import json
import os
import unittest

from harness import CASES, IC, SPH, Programs


# Cases that run for minutes, and settings with which they meet the same expectations sooner.
QUICKER = {
    "cad_vessel.toml": ["--set", "spacing=0.0083333333"],
    "dam_break_3d.toml": ["--set", "spacing=0.016"],
}


class Cases(Programs):
    def test_every_verdict_is_ok(self):
        nVerdicts = 0
        for case in sorted(glob.glob(f"{CASES}/*.toml")):
            with open(case) as f:
                if "[[validate]]" not in f.read():
                    continue
            with self.subTest(case=case):
                changes = QUICKER.get(os.path.basename(case), [])
                self.ok(IC, "generate", case, "-o", "case.hdf", "--no-report", *changes)
                out = self.ok(SPH, "run", "case.hdf", "-o", "out", "--strict")
                print(case, out[out.index("what the case"):], sep="\n")
                with open(self.path("out", "validation.json")) as f:
                    verdicts = [v["verdict"] for v in json.load(f)]
                self.assertEqual(set(verdicts), {"ok"})
                nVerdicts += len(verdicts)
        self.assertGreaterEqual(nVerdicts, 20)  # eight cases carry as many


if __name__ == "__main__":
    unittest.main(verbosity=2)
