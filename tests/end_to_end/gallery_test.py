# SPDX-License-Identifier: GPL-3.0-or-later
"""Every part of the gallery is filled right, or refused with the right remedy."""

import json
import math
import os
import re
import shutil
import sys
import unittest

import h5py
import numpy

MAKE_CAD = os.path.abspath(sys.argv.pop(4))

from harness import CASES, IC, Programs  # noqa: E402  (takes the other arguments)
from gallery_parts import (GALLERY, beyond_ball, beyond_box, beyond_gear, beyond_pipe,  # noqa: E402
                           beyond_slot, beyond_torus, gallery)

BLOCK = gallery.BLOCK
FORMULAS = {
    "plate": lambda x: beyond_box(x, *gallery.PLATE),
    "annulus": lambda x: beyond_pipe(x, *gallery.PIPE),
    "sphere": beyond_ball,
    "gear": lambda x: beyond_gear(x, *gallery.GEAR),
    "twisted_torus": lambda x: beyond_torus(x, *gallery.TORUS),
    "narrow_gap": lambda x: beyond_slot(x, *gallery.SLOT),
    "touching_bodies": lambda x: beyond_box(x, (0, 0, 0), (2 * BLOCK, BLOCK, BLOCK)),
    "inverted": beyond_ball,
    "incoherent": beyond_ball,
    "hole_mended": beyond_ball,
    "millimetres_moved": lambda x: beyond_box(x, (0, 0, 0), (BLOCK, BLOCK, BLOCK)),
}
# What check must say of them, at which severity; nothing of the others.
SAYS = {
    "plate": ("warning", "2 d_ref wide", "refine the spacing to 0.00133 m"),
    "narrow_gap": ("warning", "1.5 d_ref wide", "refine the spacing to 0.0005 m"),
    "inverted": ("note", "inside out", "normals that point outwards"),
    "incoherent": ("note", "triangles were turned", "orient all faces"),
    "hole_mended": ("note", "closed 1 hole", "look at the picture"),
}
# Refused: what, remedy.
REFUSED = {
    "touching": ("more than two triangles", "part bodies that touch along an edge"),
    "hole": ("not closed", "mend = { holes = true }"),
    "open_top": ("not closed", "close the holes in the meshing tool"),
    "millimetres_far": ("more than 2^31", "metres?"),
}
THIN = ("plate", "narrow_gap")  # less than 30 spacings somewhere: counts are off by the surface
# Facets may stand off the formula: in a STEP file by 1e-4 of the bounds' diagonal of 0.2 m; in the
# torus by the sagitta of a step, 0.08 m (2 pi / 192)^2 / 8, and by the turn of 2 pi / 192 across a
# facet of 5 mm, of which a diagonal of four corners that lie in no plane is off by a quarter.
FACETS = {"stl": 1e-12, "step": 2e-5, "twisted_torus": 1.1e-5 + 4.1e-5}
# Volume of the triangles in the file against what was meant. Coordinates of 3e4 m are rounded to
# 3.6e-12 m, that is 1e-10 of a side of 4 cm, and there are three of them.
VOLUMES = {"stl": 1e-12, "step": 5e-3, "millimetres_moved": 3e-10}
COARSER = ("annulus", "gear", "twisted_torus")  # generated at twice the spacing, to save minutes


class Gallery(Programs):
    @classmethod
    def setUpClass(cls):
        cls.parts = gallery.parts()

    def setUp(self):
        super().setUp()
        for name in os.listdir(GALLERY):
            if name.endswith(".toml"):
                shutil.copy(os.path.join(GALLERY, name), self.folder)

    def check(self, name, *sets):
        """(exit code, the findings and all else as check's JSON has them)"""
        code, out, err = self.start(IC, "check", name + ".toml", "--json", "check.json", *sets)
        self.assertEqual(err, "", f"{name}: {err}")
        with open(self.path("check.json")) as f:
            found = json.load(f)
        for finding in found["findings"]:
            self.assertTrue(finding["what"] and finding["remedy"], finding)
            self.assertIn(finding["what"], out)
        return code, found

    def expect_filled(self, name, ending, volume):
        part = ("--set", f"geometry.part.file=parts/{name}.step") if ending == "step" else ()
        code, found = self.check(name, *part)
        self.assertEqual(code, 0, found)
        said = [(f["severity"], f["what"], f["remedy"]) for f in found["findings"]]
        self.assertEqual(len(said), 1 if name in SAYS else 0, said)
        for severity, what, remedy in said:
            self.assertEqual(severity, SAYS[name][0])
            self.assertIn(SAYS[name][1], what)
            self.assertIn(SAYS[name][2], remedy)
        spacing = self.spacing(name)
        count = found["estimate"]["fluid_particles"]
        if name not in THIN:
            expected = volume * math.sqrt(2) / spacing**3  # closest packing has cells of d^3/sqrt(2)
            self.assertLess(abs(count / expected - 1), 0.01, (name, count, expected))

        if name in COARSER:
            part += ("--set", f"spacing={2 * spacing}")
        printed = self.ok(IC, "generate", name + ".toml", "-o", "made.hdf", *part)
        deviations = re.findall(r"mass over density x volume, minus 1: (\S+)", printed)
        self.assertTrue(deviations)
        for deviation in deviations:  # sums of 1e5 masses that are each rounded to 1e-16
            self.assertLess(abs(float(deviation)), 1e-12)
        with h5py.File(self.path("made.hdf")) as f:
            masses, x = f["PartType0/Masses"][...], f["VTKHDF/Points"][...]
        if name not in COARSER:
            self.assertEqual(len(masses), count)
        self.assertLess(abs(math.fsum(masses) / (1000 * volume) - 1),
                        VOLUMES.get(name, VOLUMES[ending]))
        beyond = FORMULAS[name](x).max()
        self.assertLess(beyond, FACETS.get(name, FACETS[ending]), "a particle is outside")

    def spacing(self, name):
        with open(os.path.join(GALLERY, name + ".toml")) as f:
            return next(float(line.split("=")[1]) for line in f if line.startswith("spacing"))

    def volume(self, name):
        """Of the triangles in the part's file, exactly as the case means them."""
        if name == "touching_bodies":
            return sum(gallery.volume(self.parts[k]) for k in ("touching_first", "touching_second"))
        if name == "hole_mended":  # the hole's four corners are closed from their mean
            return self.volume_of_mended_hole()
        name = {"millimetres_moved": "millimetres_far", "incoherent": "sphere"}.get(name, name)
        scale = 1e-9 if name == "millimetres_far" else 1
        return abs(gallery.volume(self.parts[name])) * scale

    def volume_of_mended_hole(self):
        (a, b, c), (_, _, d) = self.parts["sphere"][:2]
        middle = tuple(sum(p) / 4 for p in zip(a, b, c, d))
        loop = (a, b, c, d)
        lid = [(loop[k], loop[(k + 1) % 4], middle) for k in range(4)]
        return gallery.volume(self.parts["hole"] + lid)

    def test_every_case_is_here(self):
        cases = {name[:-5] for name in os.listdir(GALLERY) if name.endswith(".toml")}
        self.assertEqual(cases, set(FORMULAS) | set(REFUSED))

    def test_refused(self):
        gallery.make(self.folder)
        for name, (what, remedy) in REFUSED.items():
            with self.subTest(name):
                code, found = self.check(name)
                errors = [f for f in found["findings"] if f["severity"] == "error"]
                self.assertEqual((code, found["sound"], len(errors)), (1, False, 1), found)
                self.assertIn(what, errors[0]["what"])
                self.assertIn(remedy, errors[0]["remedy"])
                said = self.refused((IC, "generate", name + ".toml", "-o", "x.hdf"), what, remedy)
                self.assertIn(errors[0]["what"] + "; " + errors[0]["remedy"], said)  # the same words
                self.assertFalse(os.path.exists(self.path("x.hdf")))

    def test_millimetres_and_distance_have_remedies(self):
        gallery.make(self.folder)
        _, found = self.check("millimetres_far")
        remedies = [f["remedy"] for f in found["findings"] if f["severity"] == "warning"]
        self.assertEqual(len(remedies), 2)
        self.assertIn("scale = 0.001", remedies[0])
        _, found = self.check("millimetres_far", "--set", "geometry.part.scale=0.001")
        warnings = [f for f in found["findings"] if f["severity"] == "warning"]
        self.assertEqual(len(warnings), 1, found)
        self.assertIn("translate = [-30000", warnings[0]["remedy"])

    def test_filled_from_stl(self):
        gallery.make(self.folder)
        for name in FORMULAS:
            with self.subTest(name):
                self.expect_filled(name, "stl", self.volume(name))

    def test_filled_from_step(self):
        gallery.make(self.folder, MAKE_CAD)
        inner, outer, height = gallery.PIPE
        volumes = {"annulus": math.pi * (outer**2 - inner**2) * height,
                   "sphere": 4 / 3 * math.pi * gallery.BALL**3}
        for name in gallery.scripts():
            with self.subTest(name):
                self.expect_filled(name, "step", volumes.get(name) or self.volume(name))


class SeveralFaults(Programs):
    def test_all_are_found_at_once(self):
        gallery.make(self.folder)
        with open(self.path("parts", "cut.stl"), "wb") as f:  # binary, and not all there
            f.write(b"\0" * 80 + (1000).to_bytes(4, "little") + b"\0" * 500)
        open(self.path("parts", "empty.stl"), "w").close()
        with open(self.path("parts", "huge.stl"), "wb") as f:
            f.truncate(1 << 43)  # 8 TiB, none of it on the disk
        files = ("cut", "empty", "huge", "hole", "plate")
        case = self.write("faults.toml", "dimension = 3\nspacing = 0.002\n[geometry]\n" + "".join(
            f'{name} = {{ file = "parts/{name}.stl" }}\n' for name in files)
            + 'both = { union = ["cut", "plate"] }\n[[fluid]]\nregion = "both"\n'
              '[[fluid]]\nregion = "plat"\n[[wall]]\noutside = "hole"\nlayers = 3\n')
        code, out, _ = self.start(IC, "check", case, "--json", "check.json")
        self.assertEqual(code, 1)
        with open(self.path("check.json")) as f:
            found = json.load(f)["findings"]
        expected = ("truncated", "is empty", "is too large", "not closed", "no region of that name")
        self.assertEqual(len(found), len(expected), out)
        for finding, text in zip(found, expected):
            self.assertIn(text, finding["what"])
            self.assertTrue(finding["remedy"])
        self.refused((IC, "generate", case), "truncated", "3 more errors")  # of the regions

    def test_a_case_that_is_none(self):
        self.assertEqual(self.start(IC, "check", "nowhere.toml")[0], 1)
        self.assertEqual(self.start(IC, "check", self.write("bad.toml", "spacing = "))[0], 1)

    def test_a_place_for_the_findings_that_is_none(self):
        case = os.path.join(CASES, "rotating_shaft.toml")
        self.assertEqual(self.start(IC, "check", case, "--json", "no/check.json")[0], 2)


if __name__ == "__main__":
    unittest.main(verbosity=2)
