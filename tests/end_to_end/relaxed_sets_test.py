# SPDX-License-Identifier: GPL-3.0-or-later
"""How even relaxed sets are: boxes, balls and gears, from random starts and from lattices."""

import json
import os
import unittest

import h5py
import numpy

import figures
from gallery_parts import beyond_ball, beyond_gear, beyond_polygon, gallery
from harness import IC, Programs

# What users may ask of a set: standard deviation of the density over its mean.
INSIDE = {64: 0.005, 100: 0.003, "1.5 d_ref": 0.005}
AT_WALLS = 0.01
# Closest packings have so many neighbours within 2h: (4 pi/3)(2h)^3 sqrt(2).
SMOOTHING_LENGTH = {64: 1.1053, 100: 1.2825, "1.5 d_ref": 1.5}

GEAR = gallery.GEAR
OUTLINE = gallery.gear_outline(*GEAR[:3])
BOX = ("[domain]\nlower = {lower}\nupper = {upper}\nperiodic = {axes}\n", None)
WALL = '[[wall]]\noutside = "part"\nmethod = "conformal"\n'
# name: dimension, spacing, geometry or domain, what is beyond the surface
PARTS = {
    "box": (3, 0.05, BOX[0].format(lower=[0, 0, 0], upper=[1, 1, 1], axes=["x", "y", "z"]), None),
    "ball": (3, 0.004, f"[geometry]\npart = {{ ball = {{ center = [0, 0, 0], "
             f"radius = {gallery.BALL} }} }}\n", beyond_ball),
    "gear": (3, 0.0025, '[geometry]\npart = { file = "gear.stl" }\n',
             lambda x: beyond_gear(x, *GEAR)),
    "square": (2, 0.02, BOX[0].format(lower=[0, 0], upper=[1, 1], axes=["x", "y"]), None),
    "disk": (2, 0.001, f"[geometry]\npart = {{ disk = {{ center = [0, 0], "
             f"radius = {gallery.BALL} }} }}\n", lambda x: beyond_ball(x[:, :2])),
    "flat gear": (2, 0.001, "[geometry]\npart = { polygon = { points = "
                  f"{[list(p) for p in OUTLINE]} }} }}\n", lambda x: beyond_polygon(x, OUTLINE)),
}
# A perfect lattice in a periodic box has nothing to relax: noise of a fifth of a spacing.
LATTICES = {"box": 'lattice = "hcp"\njitter = 0.2', "square": 'lattice = "hexagonal"\njitter = 0.2',
            "ball": 'lattice = "hcp"', "gear": 'lattice = "hcp"',
            "disk": 'lattice = "hexagonal"', "flat gear": 'lattice = "hexagonal"'}
STARTS = {"random": lambda part: 'lattice = "random"', "lattice": LATTICES.get}


def case(part, neighbours, start):
    dimension, spacing, place, beyond = PARTS[part]
    region = 'region = "part"\n' if beyond else ""
    return (f"dimension = {dimension}\nspacing = {spacing}\n{place}"
            f"[[fluid]]\nname = \"fluid\"\nmass = \"exact\"\n{region}{STARTS[start](part)}\n"
            f"{WALL if beyond else ''}[solver]\nkernel = \"wendland_c2\"\n"
            f"smoothing_length = {SMOOTHING_LENGTH[neighbours]}\n[relax]\n")


class RelaxedSets(Programs):
    def setUp(self):
        super().setUp()
        gallery.write_stl(self.path("gear.stl"), gallery.parts()["gear"])

    def relaxed(self, part, neighbours, start):
        """The report card's places, iterations, and particles outside of the part."""
        self.write("set.toml", case(part, neighbours, start))
        self.ok(IC, "generate", "set.toml", "-q")
        with open(self.path("set.report.json")) as file:
            report = json.load(file)
        with open(self.path("set.relaxation.csv")) as file:
            iterations = sum(1 for _ in file) - 2
        n = report["fluid_particles"]
        with h5py.File(self.path("set.hdf")) as file:
            positions = file["VTKHDF/Points"][:n]
            self.assertEqual(file["Plenum"].attrs["NumberOfFluids"], n)
        beyond = PARTS[part][3]
        n_outside = int(numpy.sum(beyond(positions) > 0)) if beyond else 0
        self.assertEqual(report["overlaps"], 0)
        return n, report["places"], iterations, n_outside

    def test_are_even_and_inside(self):
        rows = [("part", "neighbours", "start", "particles", "iterations", "inside %", "worst %",
                 "at walls %", "worst %", "outside")]
        cases = [(part, neighbours, start) for part in PARTS for start in STARTS
                 for neighbours in ((64, 100) if PARTS[part][0] == 3 else ("1.5 d_ref",))]
        for part, neighbours, start in cases:
            with self.subTest(part=part, neighbours=neighbours, start=start):
                n, places, iterations, n_outside = self.relaxed(part, neighbours, start)
                walls = places.get("at walls")
                rows.append((part, str(neighbours), start, str(n), str(iterations),
                             100 * places["inside"]["density_scatter"], 100 * places["inside"]["density_worst"],
                             100 * walls["density_scatter"] if walls else "",
                             100 * walls["density_worst"] if walls else "", str(n_outside)))
                self.assertLessEqual(places["inside"]["density_scatter"], INSIDE[neighbours])
                self.assertEqual(walls is None, PARTS[part][3] is None)
                if walls:
                    self.assertLessEqual(walls["density_scatter"], AT_WALLS)
                self.assertEqual(n_outside, 0)
        figures.table("relaxed_sets", rows)


if __name__ == "__main__":
    unittest.main()
