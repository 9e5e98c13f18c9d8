# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs that are stopped at random moments, by SIGINT and by SIGKILL, and resumed: the last particle
file and the rows of history.csv have the same bits as those of a run that was never stopped."""

import filecmp
import pathlib
import random
import re
import signal
import subprocess
import time
import unittest
import xml.etree.ElementTree as ElementTree

from harness import CASES, IC, SPH, Programs

SHORT = ["--set", "solver.end_time=0.25", "--set", "output.checkpoint_every=0.02",
         "--set", "output.history_every=0.007", "--set", "measures.loads=true"]


def rows(folder):
    """history.csv without the time that it took."""
    lines = (folder / "history.csv").read_text().splitlines()
    k = lines[0].split(",").index("wall_clock [s]")
    return [cells[:k] + cells[k + 1:] for cells in (line.split(",") for line in lines)]


def checkpoints(folder):
    return list(folder.glob("*_checkpoint_*.hdf"))


class Resume(Programs):
    def setUp(self):
        super().setUp()
        self.particles = pathlib.Path(self.path("dam.hdf"))
        self.ok(IC, "generate", f"{CASES}/dam_break_single.toml", "-o", str(self.particles))

    def begin(self, folder):
        return subprocess.Popen([SPH, "run", self.particles, "-o", folder, "-q", *SHORT],
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def stop(self, folder, kill, seconds):
        """Whether the run was stopped before its end, and after its first checkpoint."""
        run = self.begin(folder)
        time.sleep(seconds)
        while run.poll() is None and not checkpoints(folder):
            time.sleep(0.01)
        run.send_signal(kill)
        code = run.wait()
        if code == 0:
            return False
        self.assertEqual(code, 130 if kill == signal.SIGINT else -signal.SIGKILL)
        return True

    def test_same_bits_as_a_run_that_was_never_stopped(self):
        whole = pathlib.Path(self.path("whole"))
        start = time.time()
        self.ok(SPH, "run", str(self.particles), "-o", str(whole), "-q", *SHORT)
        length = time.time() - start
        seed = random.randrange(1 << 30)
        moments, stops = random.Random(seed), 0
        print(f"  a run takes {length:.1f} s; seed {seed}")
        for k, kill in enumerate([signal.SIGINT] * 3 + [signal.SIGKILL] * 3):
            share = moments.uniform(0.1, 0.7)
            folder = pathlib.Path(self.path(f"stopped_{k}"))
            if self.stop(folder, kill, share * length):
                stops += 1
                self.ok(SPH, "resume", str(folder), "-q")
            what = f"{kill.name} at {share:.2f} of the run, seed {seed}"
            self.assertTrue(filecmp.cmp(whole / "dam_end.hdf", folder / "dam_end.hdf", False), what)
            self.assertEqual(rows(whole), rows(folder), what)
            self.assertEqual(sorted(p.name for p in whole.glob("*.vtu")),
                             sorted(p.name for p in folder.glob("*.vtu")), what)
            self.assertEqual((whole / "dam.pvd").read_text(), (folder / "dam.pvd").read_text())
            print(f"  {what}: same bits")
        self.assertGreaterEqual(stops, 4, "most runs must have been stopped before their end")

    def test_what_is_refused(self):
        folder = pathlib.Path(self.path("killed"))
        self.refused((SPH, "resume", str(self.particles)), "no checkpoint", "plenum-sph run")
        self.refused((SPH, "resume", self.folder), "holds no checkpoint", "checkpoint_every")
        run = self.begin(folder)
        while not checkpoints(folder):
            time.sleep(0.01)
        run.kill()
        run.wait()
        # It is not written over, and nobody makes another run of it.
        self.refused((SPH, "run", str(self.particles), "-o", str(folder)), "resume", "--anew")
        self.refused((SPH, "resume", str(folder), "--set", "solver.kernel=convex"),
                     "keeps its physics", "plenum-sph run")
        self.ok(SPH, "run", str(self.particles), "-o", str(folder), "-q", "--anew",
                "--set", "solver.end_time=0.01")

    def test_an_end_goes_on_to_a_later_time(self):
        folder = pathlib.Path(self.path("run"))
        self.ok(SPH, "run", str(self.particles), "-o", str(folder), "-q",
                "--set", "solver.end_time=0.02")
        # Other columns have no place in history.csv, and what the run goes on from stays.
        end = str(folder / "dam_end.hdf")
        self.refused((SPH, "resume", end, "--set", "solver.end_time=0.03", "--set", "measures.order=false"),
                     "history.csv", "other columns", "--output")
        self.assertEqual(rows(folder)[-1][0], "0.02")
        run = subprocess.Popen([SPH, "resume", end, "-q", "--set", "solver.end_time=10"])
        time.sleep(0.5)
        run.kill()
        run.wait()
        self.ok(SPH, "resume", end, "-q", "--set", "solver.end_time=0.03")
        self.assertEqual(rows(folder)[-1][0], "0.03")

    def test_vtu_files_keep_their_times_when_the_interval_changes(self):
        folder = pathlib.Path(self.path("run"))
        self.ok(SPH, "run", str(self.particles), "-o", str(folder), "-q",
                "--set", "solver.end_time=0.02", "--set", "output.every=0.01")
        end = str(folder / "dam_end.hdf")
        self.ok(SPH, "resume", end, "-q", "--set", "solver.end_time=0.03",
                "--set", "output.every=0.0025")
        series = ElementTree.parse(folder / "dam.pvd").getroot().iter("DataSet")
        times = [(float(entry.get("timestep")), entry.get("file")) for entry in series]
        expected = [0, 0.01, 0.02, 0.0225, 0.025, 0.0275, 0.03]
        self.assertEqual(len(times), len(expected))
        for k, (time, name) in enumerate(times):
            self.assertAlmostEqual(time, expected[k], delta=1e-9)
            self.assertEqual(name, f"dam_{k:04}.vtu")
            head = (folder / name).read_bytes()[:2000]
            written = re.search(rb'Name="TimeValue"[^>]*>\s*([-+.e\d]+)', head)
            self.assertIsNotNone(written, head)
            self.assertEqual(float(written.group(1)), time)
        # Without the series nobody knows the times of the files; they are not removed.
        (folder / "dam.pvd").unlink()
        self.refused((SPH, "resume", end, "--set", "solver.end_time=0.04"), "dam.pvd", "--output")
        self.assertTrue((folder / "dam_0000.vtu").exists())


if __name__ == "__main__":
    unittest.main()
