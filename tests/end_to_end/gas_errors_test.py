# SPDX-License-Identifier: GPL-3.0-or-later
"""Gases that cannot be run get one line with key, value and remedy, and nothing is lost."""

import os
import unittest

from harness import CASES, IC, SPH, Programs


class GasErrors(Programs):
    def generate(self, case, *sets):
        return (IC, "generate", f"{CASES}/{case}.toml", "-q", "--no-report", "--quick", "-o",
                "gas.hdf", *(word for value in sets for word in ("--set", value)))

    def not_made(self, case, setting, *expected):
        self.refused(self.generate(case, setting), *expected)
        self.assertFalse(os.path.exists(self.path("gas.hdf")))

    def not_run(self, case, sets, *expected, code=1):
        self.ok(*self.generate(case, *sets))
        return self.refused((SPH, "run", "gas.hdf", "-q", "-o", "out"), *expected, code=code)

    def test_settings_out_of_range(self):
        self.not_made("noh", "solver.adiabatic_index=1", "adiabatic_index = 1", "(1, 10]")
        self.not_made("noh", "fluid[0].internal_energy=-1", "fluid[0].internal_energy = -1", "> 0")

    def test_boxes_and_blobs_that_do_not_fit(self):
        self.not_made("pairing_3d", "domain.upper=[0.2, 1, 1]", "pairing_3d.toml:",
                      "periodic axis x is 0.2 m long", "twice the kernel's support", "make it longer")
        self.not_made("blob_wind_tunnel_2d", "geometry.blob.disk.radius=6",
                      "blob_wind_tunnel_2d.toml:", 'fluid "blob"', "12 m long",
                      "make the region smaller")

    def test_densities_that_are_not_sums(self):
        self.not_run("noh", ["solver.density=continuity"], 'solver.density = "continuity"',
                     'set density = "summation"')
        self.assertFalse(os.path.exists(self.path("out", "history.csv")))

    def test_smoothing_lengths_that_do_not_converge(self):
        self.not_run("noh", ["solver.adaptive.max_iterations=1", "solver.adaptive.tolerance=1e-14"],
                     "particle ", "does not converge", "after 1 iterations",
                     "max_iterations", code=2)

    def test_an_energy_that_turns_negative_leaves_the_last_sound_state(self):
        self.not_run("sod", ["solver.time_step=0.02"], "particle ", "internal energy", "t = 0.02 s",
                     "solver.time_step=", "out/gas_failed.hdf", code=2)
        self.assertIn("0.02", self.ok(SPH, "info", self.path("out", "gas_failed.hdf")))


if __name__ == "__main__":
    unittest.main()
