# SPDX-License-Identifier: GPL-3.0-or-later
"""`plenum-ic relax`: from a case, from a set, with what it leaves beside the file."""

import csv
import os
import unittest

import h5py
import numpy

from harness import IC, SPH, Programs

TANK = """
dimension = 2
spacing = 0.05
[geometry]
tank = { disk = { center = [0, 0], radius = 0.5 } }
[[fluid]]
region = "tank"
lattice = "random"
[[wall]]
outside = "tank"
"""


class Relax(Programs):
    def setUp(self):
        super().setUp()
        self.write("tank.toml", TANK)

    def positions(self, name):
        with h5py.File(self.path(name)) as file:
            return file["VTKHDF/Points"][:]

    def test_of_a_set_is_that_of_its_case(self):
        self.ok(IC, "generate", "tank.toml", "-q", "--no-report")
        self.ok(IC, "relax", "tank.hdf", "-q")
        self.ok(IC, "relax", "tank.toml", "-q", "-o", "whole.hdf")
        self.write("relaxed.toml", TANK + "[relax]\n")
        self.ok(IC, "generate", "relaxed.toml", "-q", "--no-report")
        for other in ("whole.hdf", "relaxed.hdf"):
            numpy.testing.assert_array_equal(self.positions("tank.relaxed.hdf"),
                                             self.positions(other))
        self.assertTrue(numpy.any(self.positions("tank.relaxed.hdf") != self.positions("tank.hdf")))
        self.ok(SPH, "run", "tank.relaxed.hdf", "-q", "-o", "run", "--set", "solver.end_time=0.01")
        self.ok(IC, "relax", os.path.join("run", "tank.relaxed_end.hdf"), "-q", "-o", "again.hdf")
        self.assertEqual(self.positions("again.hdf").shape, self.positions("tank.hdf").shape)

    def test_writes_the_scatter_of_every_iteration(self):
        self.ok(IC, "relax", "tank.toml", "-q", "--max-iterations", "5", "--method", "wvt")
        with open(self.path("tank.relaxation.csv")) as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([int(row["iteration"]) for row in rows], [0, 1, 2, 3, 4, 5])
        self.assertLess(float(rows[5]["scatter"]), float(rows[0]["scatter"]) / 2)

    def test_keeps_the_best_state_of_what_falls_short(self):
        command = [IC, "relax", "tank.toml", "-q", "--tolerance", "1e-7", "--max-iterations", "30"]
        code, _, err = self.start(*command)
        self.assertEqual(code, 1)
        self.assertIn("is not reached", err)
        self.assertTrue(len(self.positions("tank.hdf")) > 0)
        code, _, err = self.start(*command, "--set", "relax.may_fail=true", "-o", "allowed.hdf")
        self.assertEqual(code, 0)
        self.assertIn("is not reached", err)
        numpy.testing.assert_array_equal(self.positions("tank.hdf"), self.positions("allowed.hdf"))

    def test_refuses(self):
        self.ok(IC, "generate", "tank.toml", "-q", "--no-report")
        self.refused((IC, "relax", "tank.hdf", "--method", "sph"), "packing | wvt | lloyd")
        self.refused((IC, "relax", "tank.hdf", "-o", "tank.hdf"), "is the input")
        self.refused((IC, "relax", "tank.hdf", "--max-iterations", "0"), "max_iterations")


if __name__ == "__main__":
    unittest.main()
