# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad input gets one line that names file, key, value and remedy, and nothing is lost."""

import os
import resource
import signal
import subprocess
import unittest

import h5py
import numpy

from harness import CASES, IC, SPH, Programs

GAP = """
title = "gap"
dimension = 2
spacing = 0.01

[geometry]
shaft = { disk = { center = [0, 0], radius = 0.04 } }
housing = { disk = { center = [0, 0], radius = 0.10 } }
gap = { difference = ["housing", "shaft"] }

[[fluid]]
region = "gap"
lattice = "hexagonal"
density = 1.0

[[wall]]
region = "shaft"

[[wall]]
outside = "housing"

[solver]
kernel = "convex"
end_time = 0.01
time_step = 1e-4
"""


class CaseErrors(Programs):
    def generate(self, old="", new="", *expected):
        self.assertIn(old, GAP)
        case = self.write("gap.toml", GAP.replace(old, new))
        self.refused((IC, "generate", case, "-o", "gap.hdf"), *expected)
        self.assertFalse(os.path.exists(self.path("gap.hdf")))

    def test_the_case_itself_is_sound(self):
        case = self.write("gap.toml", GAP)
        self.ok(IC, "generate", case, "-o", "gap.hdf")
        self.ok(SPH, "run", "gap.hdf", "-o", "out")

    def test_misspelt_key(self):
        self.generate('kernel = "convex"', 'kernl = "convex"', "gap.toml:23", "kernl", "'kernel'")
        self.generate("spacing = 0.01", "spacing = 0.01\nspaceing = 1", "gap.toml:5", "'spacing'")
        self.generate('lattice = "hexagonal"', 'latice = "hexagonal"', "gap.toml:13", "'lattice'")
        self.generate("radius = 0.04", "radios = 0.04", "gap.toml:7", "'radius'")

    def test_unknown_choice(self):
        self.generate('"convex"', '"konvex"', "gap.toml:23", "konvex", '"convex"')
        self.generate('"hexagonal"', '"hexagon"', "gap.toml:13", "hexagonal")

    def test_wrong_type(self):
        self.generate("spacing = 0.01", 'spacing = "fine"', "gap.toml:4", "a number")
        self.generate("density = 1.0", "density = [1]", "gap.toml:14", "a number")

    def test_value_out_of_range(self):
        self.generate("spacing = 0.01", "spacing = -1", "gap.toml:4", "spacing = -1", "> 0")
        self.generate("spacing = 0.01", "spacing = nan", "gap.toml:4", "finite")
        self.generate("dimension = 2", "dimension = 4", "gap.toml:3", "[1, 3]")
        self.generate("time_step = 1e-4", "time_step = 0", "gap.toml:25", "> 0")

    def test_missing_key(self):
        self.generate("spacing = 0.01\n", "", "spacing", "missing")
        self.generate(", radius = 0.04", "", "gap.toml:7", "radius")

    def test_not_toml(self):
        self.generate('title = "gap"', 'title = "gap', "gap.toml:2", "TOML")

    def test_unknown_region(self):
        self.generate('region = "gap"', 'region = "gab"', "gap.toml:12", "gab", "gap")

    def test_missing_mesh(self):
        self.generate("gap = { difference", 'part = { file = "no.stl" }\ngap = { difference')
        self.generate('gap = { difference = ["housing", "shaft"] }', 'gap = { file = "no.wkt" }',
                      "gap.toml:9", "no.wkt")

    def test_wrong_dimension(self):
        self.generate("center = [0, 0], radius = 0.10", "center = [0, 0, 0], radius = 0.10",
                      "gap.toml:8", "dimensions")

    def test_fluid_in_a_wall(self):
        self.generate('region = "gap"', 'region = "housing"', "gap.toml", "wall")

    def test_region_thinner_than_the_spacing(self):
        self.generate("spacing = 0.01", "spacing = 0.2", "gap.toml")

    def test_missing_case(self):
        self.refused((IC, "generate", "nowhere.toml"), "nowhere.toml", "no such case file")

    def test_particle_file_instead_of_a_case(self):
        self.ok(IC, "generate", f"{CASES}/gas_box.toml", "-o", "box.hdf")
        self.refused((IC, "generate", "box.hdf"), "box.hdf", "case file (TOML)")

    def test_no_folder_to_write_to(self):
        case = self.write("gap.toml", GAP)
        self.refused((IC, "generate", case, "-o", "no/gap.hdf"), "no/gap.hdf", code=2)


class RunErrors(Programs):
    def setUp(self):
        super().setUp()
        self.ok(IC, "generate", self.write("gap.toml", GAP), "-o", "gap.hdf")

    def run_refused(self, changes, *expected, code=1):
        sets = [part for change in changes for part in ("--set", change)]
        return self.refused((SPH, "run", "gap.hdf", "-o", "out", "--quiet", *sets), *expected,
                            code=code)

    def test_walls_thinner_than_the_support(self):
        message = self.run_refused(["solver.smoothing_length=2"], 'wall "shaft"', "1 layer",
                                   "smoothing_length")
        self.assertIn("housing", message)

    def test_key_that_came_too_late(self):
        self.run_refused(["spacing=0.1"], "spacing", "plenum-ic generate")
        self.run_refused(["solver.kernl=convex"], "kernl", "'kernel'")
        self.run_refused(["solver.kernel"], "key=value")

    def test_field_that_is_not_modelled(self):
        self.run_refused(["output.picture=internal_energy"], "output.picture", "does not model")
        self.run_refused(["output.picture=velocty"], "velocity")
        self.run_refused(["output.look.along=y"], "output.look", "3-D")
        self.run_refused(["output.look.at=0"], "output.look", "3-D")

    def test_measures_that_the_scene_cannot_have(self):
        self.run_refused(['measures.probe=[{name="p",point=[3,0]}]'], "gap.hdf",
                         'measures.probe[0] "p"', "outside of the scene")
        self.run_refused(['measures.gauge=[{name="h",point=[0]}]'], "measures.gauge[0]",
                         "solver.gravity")
        self.run_refused(['measures.volume=[{name="step",lower=[0,0],upper=[1,1]}]'],
                         'called "step"')
        self.run_refused(["measures.front.material=water"], "measures.front.material",
                         "no such fluid")

    def test_expectations_that_mean_nothing(self):
        self.run_refused(['validate=[{quantity="lefft",at_most=0}]'], "validate[0].quantity",
                         'did you mean "left"?')
        self.run_refused(['validate=[{quantity="left",expected=0}]'], "tolerance")
        self.refused((IC, "generate", "gap.toml", "--set", 'validate=[{quantity="left",to=1}]'),
                     "unknown key 'to'")

    def test_missing_and_foreign_files(self):
        self.refused((SPH, "run", "nowhere.hdf"), "nowhere.hdf")
        self.refused((SPH, "run", "gap.toml"), "gap.toml", "plenum-ic")
        with h5py.File(self.path("other.hdf"), "w") as f:
            f["x"] = 1
        self.refused((SPH, "run", "other.hdf"), "other.hdf")

    def test_truncated_file(self):
        size = os.path.getsize(self.path("gap.hdf"))
        for share in (0.1, 0.5, 0.99):
            with open(self.path("gap.hdf"), "rb") as f:
                self.write("cut.hdf", "")
                with open(self.path("cut.hdf"), "wb") as cut:
                    cut.write(f.read(int(share * size)))
            self.refused((SPH, "run", "cut.hdf"), "cut.hdf")

    def test_a_position_that_is_no_number(self):
        for value in (numpy.nan, numpy.inf, -1e30):
            with h5py.File(self.path("gap.hdf"), "r+") as f:
                number = f["PartType0/ParticleIDs"][7]
                for name in ("PartType0/Coordinates", "VTKHDF/Points"):
                    f[name][7, 1] = value
            self.refused((SPH, "run", "gap.hdf", "-o", "out", "--quiet"), "gap.hdf: ", "position",
                         str(number), "generate the particle file")
            self.assertFalse(os.path.exists(self.path("out")))

    def test_another_version(self):
        with h5py.File(self.path("gap.hdf"), "r+") as f:
            name = next(k for k in f["Plenum"].attrs if "ersion" in k)
            f["Plenum"].attrs.modify(name, 999)
        self.refused((SPH, "run", "gap.hdf"), "gap.hdf", "999")

    def test_a_run_that_blows_up_keeps_its_last_state(self):
        with h5py.File(self.path("gap.hdf"), "r+") as f:
            f["PartType0/Velocities"][0] = [1e200, 0, 0]  # its square overflows in the viscosity
        self.run_refused(["solver.viscosity={monaghan={alpha=1,beta=1}}"],
                         "particle", "t = ", "time step", "gap_failed.hdf", code=2)
        with h5py.File(self.path("out", "gap_failed.hdf")) as f:
            self.assertTrue(numpy.isfinite(f["PartType0/Coordinates"][...]).all())
        self.assertTrue(os.path.exists(self.path("out", "gap_0000.vtu")))

    def test_physics_that_do_not_go_together(self):
        self.run_refused(["solver.density_diffusion={}"], "density_diffusion", "continuity")

    def test_a_step_above_its_limit(self):
        self.run_refused(["solver.time_step=1"], "solver.time_step = 1 s", "limit", "leave")
        self.assertFalse(os.path.exists(self.path("out")))

    def test_a_particle_that_is_too_fast(self):
        with h5py.File(self.path("gap.hdf"), "r+") as f:
            f["PartType0/Velocities"][0] = [1000, 0, 0]
        self.run_refused([], "particle", " m/s is above", "speed_limit", "t = 0", "gap_failed.hdf", code=2)

    def test_a_full_disk_leaves_the_last_checkpoint_whole(self):
        def few_bytes():  # a file may be no larger; writing more fails as on a full disk
            size = os.path.getsize(self.path("out", "gap_checkpoint_000000064.hdf"))
            resource.setrlimit(resource.RLIMIT_FSIZE, (size // 2, size // 2))
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        self.ok(SPH, "run", "gap.hdf", "-o", "out", "-q", "--set", "solver.time_step=1e-5",
                "--set", "solver.end_time=6.4e-4", "--set", "output.every=1")
        end = self.path("out", "gap_end.hdf")
        os.rename(end, self.path("out", "gap_checkpoint_000000064.hdf"))
        done = subprocess.run([SPH, "resume", "out", "-q", "--set", "solver.end_time=0.01",
                               "--set", "output.checkpoint_every=0.002"], cwd=self.folder,
                              capture_output=True, text=True, preexec_fn=few_bytes)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("gap_checkpoint_", done.stderr)
        self.assertIn("the last checkpoint is", done.stderr)
        self.ok(SPH, "resume", "out", "-q", "--set", "solver.end_time=0.001")

    def test_no_folder_to_write_to(self):
        self.write("file", "")
        self.refused((SPH, "run", "gap.hdf", "-o", "file/out", "--quiet"), "file/out", code=2)


class CommandLines(Programs):
    def test_help(self):
        for program in (IC, SPH):
            self.assertIn("Exit code", self.ok(program, "--help"))
            self.assertIn("0.1.0", self.ok(program, "--version"))

    def test_wrong_command(self):
        for program in (IC, SPH):
            code, _, err = self.start(program, "fly")
            self.assertEqual(code, 1)
            self.assertIn("fly", err)
            self.assertEqual(self.start(program)[0], 1)


if __name__ == "__main__":
    unittest.main(verbosity=2)
