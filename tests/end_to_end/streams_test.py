# SPDX-License-Identifier: GPL-3.0-or-later
"""A tunnel that gas comes into and leaves, through the programs: what history.csv and the verdicts say
of it, and the bits of a run that goes on."""

import csv
import filecmp
import json
import os
import unittest

from harness import CASES, IC, SPH, Programs

class Streams(Programs):
    def setUp(self):
        super().setUp()
        self.ok(IC, "generate", f"{CASES}/blob_wind_tunnel_2d_open.toml", "-q", "--no-report",
                "--quick", "-o", "tunnel.hdf")

    def rows(self, folder):
        with open(self.path(folder, "history.csv")) as file:
            return [{key.split(" [")[0]: float(value) for key, value in row.items() if value}
                    for row in csv.DictReader(file)]

    def test_what_comes_in_and_leaves(self):
        out = self.ok(SPH, "info", "tunnel.hdf")
        self.assertIn("lower end of x: plane at -4.5 m, gas held for 1.5 m beyond it", out)
        self.assertIn("upper end of x: plane at 13 m, gas held for 2 m beyond it", out)
        code, _, err = self.start(SPH, "run", "tunnel.hdf", "-q", "--strict", "-o", "out")
        self.assertEqual((code, err), (0, ""))  # nor a warning: what left has not escaped
        rows = self.rows("out")
        first, last = rows[0], rows[-1]
        # A wind of 10 m^2/s times 2.7 and density 1, to the last column of particles of 2.5 kg.
        self.assertAlmostEqual(last["mass_in"], 27 * last["time"], delta=2.5)
        self.assertEqual(first["mass_in"], 0)
        for earlier, later in zip(rows, rows[1:]):
            self.assertGreater(later["mass_in"], earlier["mass_in"])
            self.assertGreater(later["mass_out"], earlier["mass_out"])
        # What the tunnel holds changes; what is left when that is taken off does not.
        self.assertGreater(abs(last["energy_total"] - first["energy_total"]), 1)
        self.assertAlmostEqual(last["energy_balance"], first["energy_balance"], delta=.01)
        self.assertEqual(last["escaped"], 0)
        self.assertRegex(self.ok(SPH, "info", "out/tunnel_end.hdf"), r"mass_in +1\d\d")
        with open(self.path("out", "validation.json")) as file:
            self.assertEqual({v["verdict"] for v in json.load(file)}, {"ok"})
        with open(self.path("out", "summary.json")) as file:
            # history.csv has twelve digits.
            self.assertAlmostEqual(json.load(file)["measures"]["mass_in"], last["mass_in"], delta=1e-9)

    def test_a_run_that_goes_on_has_the_same_bits(self):
        common = ("-q", "--set", "output.checkpoint_every=1.185")
        self.ok(SPH, "run", "tunnel.hdf", "-o", "whole", *common)
        self.ok(SPH, "run", "tunnel.hdf", "-o", "parts", *common, "--set", "solver.end_time=2.37")
        self.ok(SPH, "resume", "parts/tunnel_end.hdf", "-q", "--set", "solver.end_time=4.74")
        checkpoint = next(name for name in sorted(os.listdir(self.path("whole")))
                          if "_checkpoint_" in name)
        self.ok(SPH, "resume", f"whole/{checkpoint}", "-q", "-o", "again")

        def without_clock(folder):
            return [{k: v for k, v in row.items() if k != "wall_clock"} for row in self.rows(folder)]
        whole = self.path("whole", "tunnel_end.hdf")
        self.assertEqual(without_clock("whole"), without_clock("parts"))
        self.assertEqual(without_clock("whole")[-1], without_clock("again")[-1])
        for folder in ("parts", "again"):
            self.assertTrue(filecmp.cmp(whole, self.path(folder, "tunnel_end.hdf"), False), folder)


if __name__ == "__main__":
    unittest.main()
