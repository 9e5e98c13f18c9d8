# SPDX-License-Identifier: GPL-3.0-or-later
"""From a case to files that others read."""

import csv
import glob
import json
import os
import signal
import subprocess
import time
import unittest
import xml.etree.ElementTree as ElementTree

import h5py
import meshio
import numpy

from harness import CASES, IC, SPH, Programs


class Scenes(Programs):
    def run_shaft(self, *changes):
        self.ok(IC, "generate", f"{CASES}/rotating_shaft.toml", "-o", "shaft.hdf")
        sets = [part for change in changes for part in ("--set", change)]
        return self.ok(SPH, "run", "shaft.hdf", "-o", "out", *sets)

    def test_a_run_leaves_everything_that_it_names(self):
        out = self.run_shaft("solver.end_time=0.02")
        for name in ("shaft.pvd", "history.csv", "summary.json", "first.png", "last.png",
                     "shaft_end.hdf", "shaft_0000.vtu", "shaft_0002.vtu"):
            self.assertGreater(os.path.getsize(self.path("out", name)), 0, name)
        self.assertIn("ParaView", out)
        self.assertIn("not modelled", out)
        self.assertEqual(glob.glob(self.path("out", "*.tmp")), [])

        with open(self.path("out", "history.csv")) as f:
            rows = list(csv.DictReader(f))
        self.assertEqual([float(r["time [s]"]) for r in rows], [0, 0.01, 0.02])
        with open(self.path("out", "summary.json")) as f:
            summary = json.load(f)
        self.assertEqual(summary["fluid_particles"], 1212)
        for name in ("nn_min", "nn_mean", "f.1", "f.5", "f.85", "void1", "psi6", "left"):
            self.assertIn(name, summary["measures"])
        self.assertAlmostEqual(summary["measures"]["nn_min"], float(rows[-1]["nn_min [d_ref]"]), 9)

    def test_a_run_is_compared_with_what_its_case_says(self):
        asked = ('validate=[{quantity="max_speed", time=0.013, at_most=100},'
                 '{quantity="left", at_least=1, source="nowhere"},'
                 '{quantity="void1", time=9, at_most=1}]')
        out = self.run_shaft("solver.end_time=0.02", asked)
        for text in ("max_speed at 0.013 s", "<= 100", "ok", "FAILED", "not reached", "nowhere"):
            self.assertIn(text, out)
        with open(self.path("out", "validation.json")) as f:
            verdicts = json.load(f)
        self.assertEqual([v["verdict"] for v in verdicts], ["ok", "FAILED", "not reached"])
        self.assertIsNone(verdicts[2]["measured"])
        with open(self.path("out", "history.csv")) as f:  # a row exactly at the time named
            self.assertEqual([float(r["time [s]"]) for r in csv.DictReader(f)],
                             [0, 0.01, 0.013, 0.02])
        command = (SPH, "run", "shaft.hdf", "-q", "--strict", "--set", "solver.end_time=0.001")
        self.assertEqual(self.start(*command, "--set", asked)[0], 2)
        self.ok(*command, "--set", 'validate=[{quantity="left", at_most=0}]')

    def test_a_run_without_expectations_leaves_no_verdicts_of_an_earlier_one(self):
        self.run_shaft("solver.end_time=0.001")
        self.assertTrue(os.path.exists(self.path("out", "validation.json")))
        self.run_shaft("solver.end_time=0.001", "validate=[]")
        self.assertFalse(os.path.exists(self.path("out", "validation.json")))

    def test_measures_that_the_case_names(self):
        self.run_shaft("solver.end_time=0.001", "validate=[]", "measures.order=false",
                       'measures.probe=[{name="p1",point=[0.07,0]},{name="p2",point=[0,0]}]',
                       'measures.volume=[{name="right",lower=[0,-1],upper=[1,1]}]')
        with open(self.path("out", "history.csv")) as f:
            row = list(csv.DictReader(f))[-1]
        self.assertNotIn("void1", row)
        self.assertGreater(float(row["p1_velocity_y [m/s]"]), -1)
        self.assertEqual(row["p2_pressure [Pa m]"], "")  # inside the shaft
        self.assertAlmostEqual(float(row["right [m^2]"]), 3.14159 * (0.1**2 - 0.04**2) / 2, 3)
        with open(self.path("out", "summary.json")) as f:
            summary = json.load(f)
        self.assertIsNone(summary["measures"]["p2_pressure"])
        self.assertEqual(summary["units"]["right"], "m^2")
        self.ok(SPH, "info", "out/shaft_end.hdf")  # an empty figure spoils no file

    def test_meshio_reads_every_state_as_the_end_file_has_it(self):
        self.run_shaft("solver.end_time=0.02")
        series = ElementTree.parse(self.path("out", "shaft.pvd")).getroot().iter("DataSet")
        files = [(float(d.get("timestep")), d.get("file")) for d in series]
        self.assertEqual([t for t, _ in files], [0, 0.01, 0.02])
        mesh = [meshio.read(self.path("out", name)) for _, name in files][-1]
        with h5py.File(self.path("out", "shaft_end.hdf")) as end:
            part = end["PartType0"]
            numpy.testing.assert_array_equal(mesh.points, end["VTKHDF/Points"][...])
            for vtu, gadget in (("velocity", "Velocities"), ("density", "Density"),
                                ("mass", "Masses"), ("id", "ParticleIDs")):
                numpy.testing.assert_array_equal(mesh.point_data[vtu], part[gadget][...])
            self.assertEqual(end["Header"].attrs["NumPart_Total"][0], 1212 + 871)

    def test_the_end_state_is_a_particle_file_to_go_on_from(self):
        self.run_shaft("solver.end_time=0.01")
        self.ok(SPH, "run", "out/shaft_end.hdf", "-o", "more", "--set", "solver.end_time=0.02")
        self.assertIn("t = 0.01 s", self.ok(SPH, "info", "out/shaft_end.hdf"))

    def test_one_and_two_threads_give_the_same_file(self):
        self.ok(IC, "generate", f"{CASES}/gas_box.toml", "-o", "box.hdf")
        states = []
        for threads in ("1", "2"):
            self.ok(SPH, "run", "box.hdf", "-o", threads, "-j", threads,
                    "--set", "solver.end_time=0.1")
            with h5py.File(self.path(threads, "box_end.hdf")) as f:
                states.append({k: v[...] for k, v in f["PartType0"].items()})
        for name in states[0]:
            numpy.testing.assert_array_equal(states[0][name], states[1][name], name)

    def test_a_killed_run_leaves_no_half_file(self):
        self.ok(IC, "generate", f"{CASES}/rotating_shaft.toml", "-o", "shaft.hdf")
        process = subprocess.Popen(
            (SPH, "run", "shaft.hdf", "-o", "out", "--quiet", "--set", "output.every=1e-4"),
            cwd=self.folder)
        deadline = time.monotonic() + 120
        while len(glob.glob(self.path("out", "shaft_*.vtu"))) < 4:
            self.assertLess(time.monotonic(), deadline, "the run writes nothing")
            time.sleep(0.05)
        process.send_signal(signal.SIGKILL)
        process.wait()
        files = sorted(glob.glob(self.path("out", "shaft_*.vtu")))
        self.assertGreater(len(files), 2)
        for file in files:
            self.assertEqual(len(meshio.read(file).points), 1212 + 871)
        with open(self.path("out", "history.csv")) as f:
            self.assertTrue(f.read().endswith("\n"))

    def test_a_second_run_replaces_the_first(self):
        self.run_shaft("solver.end_time=0.03")
        self.run_shaft("solver.end_time=0.01")
        self.assertEqual(len(glob.glob(self.path("out", "shaft_0*.vtu"))), 2)


if __name__ == "__main__":
    unittest.main(verbosity=2)
