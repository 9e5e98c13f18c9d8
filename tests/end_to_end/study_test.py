# SPDX-License-Identifier: GPL-3.0-or-later
"""plenum-study as a user meets it: studies that are interrupted, that fail in part, that are refused,
and their report in a browser."""

import csv
import glob
import json
import os
import re
import shutil
import signal
import subprocess
import time
import unittest

from harness import CASES, IC, SPH, Programs

STUDY = os.path.join(os.path.dirname(IC), "..", "studies", "plenum-study")
TANK = f"{CASES}/hydrostatic_tank.toml"
CHROMIUM = shutil.which("chromium")


class Studies(Programs):
    def accuracy(self, *options):
        return (STUDY, "accuracy", TANK, "--quick", "-o", "study", *options)

    def rows(self):
        with open(self.path("study", "results.csv")) as file:
            return list(csv.DictReader(file))

    def outcomes(self):
        return sorted(glob.glob(self.path("study", "runs", "*", "outcome.json")))

    def test_a_grid_becomes_table_charts_page_and_advice(self):
        out = self.ok(*self.accuracy("--vary", "kernel=convex,wendland_c2_1d", "--vary", "h=1.5,2",
                                     "--set", "domain.upper=[0.24,1]",
                                     "--set", "geometry.column.box.upper=[0.24,1]", "--within", "1.3",
                                     "--compare", "kernel=convex,h=2", "kernel=wendland_c2_1d,h=1.5"))
        rows = self.rows()
        self.assertEqual([(r["kernel"], r["h"]) for r in rows],
                         [("convex", "1.5"), ("convex", "2"), ("wendland_c2_1d", "1.5"),
                          ("wendland_c2_1d", "2")])
        # The closed form does not depend on the spacing; the sway of coarse columns adds .03 points.
        for row, expected in zip(rows, (2.750, 1.181, 1.316, .484)):
            self.assertAlmostEqual(float(row["pressure_gradient_error:mean"]), expected, delta=.08)
            self.assertGreater(float(row["cpu in steps [s]"]), 0)
            self.assertGreater(float(row["interactions [1/s]"]), 1e5)
            self.assertGreater(float(row["peak memory [bytes]"]), 1e6)
        for name in ("error_cost.svg", "error_cost.png", "closed_form.svg", "closed_form.png",
                     "report.html"):
            self.assertGreater(os.path.getsize(self.path("study", name)), 2000, name)
        self.assertRegex(out, r"The cheapest setting within 1\.3 %: ")
        self.assertRegex(out, r"is cheaper at equal error")

    def test_runs_are_made_once(self):
        self.ok(*self.accuracy("--vary", "h=1.5"))
        first = os.path.getmtime(self.outcomes()[0])
        _, _, err = self.start(*self.accuracy("--vary", "h=1.3,1.5"))
        self.assertEqual(len(self.outcomes()), 2)
        self.assertIn(first, [os.path.getmtime(f) for f in self.outcomes()])
        self.assertIn("100 %", err)  # of the one that was new
        self.assertNotIn("smoothing_length=1.5", err)

    def test_of_repeats_the_least_counts(self):
        command = self.accuracy("--vary", "h=1.2", "--repeats", "3")
        self.ok(*command)
        taken = self.rows()[0]["folder"]
        self.assertEqual(len(self.outcomes()), 3)
        for name in self.outcomes():  # now the one that was taken takes longest
            with open(name) as file:
                outcome = json.load(file)
            outcome["cost"]["step_cpu_seconds"] = 3 if taken in name else 1
            with open(name, "w") as file:
                json.dump(outcome, file)
        self.ok(*command)
        self.assertEqual([float(row["cpu in steps [s]"]) for row in self.rows()], [1])

    @unittest.skipIf(os.cpu_count() < 2, "one core")
    def test_threads_are_timed_by_the_clock(self):
        out = self.ok(*self.accuracy("--vary", "threads=1,2"))
        with open(self.path("study", "report.html")) as file:
            self.assertTrue("time of the steps by the clock [s]" in file.read())
        least = min(float(row["wall clock in steps [s]"]) for row in self.rows())
        self.assertIn(f", {least:.3g} s;", out)

    def test_a_killed_study_goes_on(self):
        command = self.accuracy("--vary", "h=1.2,1.3,1.4,1.5")
        study = subprocess.Popen(command, cwd=self.folder, stdout=subprocess.DEVNULL,
                                 stderr=subprocess.DEVNULL)
        while len(self.outcomes()) < 2:
            self.assertIsNone(study.poll())
            time.sleep(.01)
        study.send_signal(signal.SIGKILL)
        study.wait()
        done = {f: os.path.getmtime(f) for f in self.outcomes()}
        self.assertLess(len(done), 4)
        self.ok(*command)
        self.assertEqual(len(self.outcomes()), 4)
        self.assertEqual(len(self.rows()), 4)
        for file, when in done.items():
            self.assertEqual(os.path.getmtime(file), when)

    def test_a_folder_is_of_one_study_at_a_time(self):
        study = subprocess.Popen(self.accuracy("--vary", "h=1.2,1.3,1.4"), cwd=self.folder,
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while not self.outcomes():
            self.assertIsNone(study.poll())
            time.sleep(.01)
        self.refused(self.accuracy("--vary", "h=1.5"), "another study", "-o")
        self.assertEqual(study.wait(), 0)
        self.assertEqual(len(self.outcomes()), 3)

    def test_a_run_that_fails_is_a_result(self):
        # A speed limit of a hundred-thousandth of c: the column's sway is faster.
        out = self.ok(*self.accuracy("--vary", "solver.speed_limit=1e-5,5"))
        failed, fine = self.rows()
        self.assertIn("speed_limit", failed["failure"])
        self.assertGreaterEqual(float(failed["failed at [s]"]), 0)
        self.assertEqual(fine["failure"], "")
        self.assertIn("1 of 2 runs failed", out)

    def programs(self, first):
        """A folder of programs whose plenum-sph does `first`, a line of the shell, the first time."""
        os.mkdir(self.path("programs"))
        os.symlink(os.path.abspath(IC), self.path("programs", "plenum-ic"))
        with open(self.path("programs", "plenum-sph"), "w") as script:
            script.write(f"#!/bin/sh\n"
                         f"if mkdir '{self.path('first')}' 2> /dev/null; then {first}; fi\n"
                         f"exec '{os.path.abspath(SPH)}' \"$@\"\n")
        os.chmod(self.path("programs", "plenum-sph"), 0o755)
        return ("--programs", self.path("programs"))

    def test_a_run_that_the_system_kills_does_not_end_the_study(self):
        command = self.accuracy("--vary", "h=1.2,1.3", *self.programs("kill -9 $$"))
        self.assertIn("1 of 2 runs failed", self.ok(*command))
        self.assertIn("likely out of memory", self.rows()[0]["failure"])
        self.assertEqual(self.rows()[1]["failure"], "")
        self.ok(*command)  # it has another chance
        self.assertEqual([row["failure"] for row in self.rows()], ["", ""])

    def test_a_full_disk_is_no_result(self):
        full = "echo 'plenum-sph: run_end.hdf: cannot be written: No space left on device' >&2; exit 2"
        command = self.accuracy("--vary", "h=1.2,1.3", *self.programs(full))
        code, _, err = self.start(*command)
        self.assertEqual(code, 2)
        self.assertIn("No space left on device; the study goes on from here", err)
        self.assertEqual(self.outcomes(), [])
        self.ok(*command)
        self.assertEqual([row["failure"] for row in self.rows()], ["", ""])

    def test_a_case_that_changes_during_a_study_makes_no_results(self):
        shutil.copy(TANK, self.path("tank.toml"))
        change = f"sed -i 's/^sound_speed.*/sound_speed = 25.0/' '{self.path('tank.toml')}'"
        command = (STUDY, "accuracy", "tank.toml", "--quick", "-o", "study", "--vary", "h=1.2,1.3",
                   *self.programs(change))
        code, _, err = self.start(*command)
        self.assertEqual(code, 2)
        self.assertIn("tank.toml: the case, or a program, has changed since the study began", err)
        self.assertEqual(self.outcomes(), [])
        self.ok(*command)
        self.assertEqual(len(self.outcomes()), 2)

    def test_what_cannot_be_used_is_refused_before_anything_runs(self):
        for options, expected in (
                (("--vary", "kernl=convex"), "did you mean kernel?"),
                (("--vary", "h=1.5", "--quantity", "max_speed"), "pressure_gradient_error:mean_abs"),
                (("--vary", "h"), "KEY=VALUE"),
                (("--vary", "threads=1,100000"), "of this machine"),
                (("--vary", "h=1.5", "--compare", "h=1.5", "h=9"), "h=9 is none of 1.5"),
                (("--vary", "h=1.5", "--programs", "/nowhere"), "--programs")):
            self.refused(self.accuracy(*options), expected)
        for vary, expected in (("kernel=convex,convx", "convx"), ("h=1.5,-1", "smoothing_length"),
                               ("precision=mixed,half", "half")):
            code, _, err = self.start(*self.accuracy("--vary", vary))
            self.assertEqual(code, 1)
            self.assertIn("nothing was run", err)
            self.assertIn(expected, err)
        self.assertEqual(self.outcomes(), [])

    def test_the_minimal_case_is_that_of_the_whole_grid(self):
        axes = ("--vary", "kernel=cubic_spline,wendland_c2", "--vary", "h=1.2,2", "--vary",
                "spacing=0.08,0.04,0.02,0.01")
        self.ok(STUDY, "accuracy", f"{CASES}/sod.toml", "-o", "study", *axes)
        rows = self.rows()
        error = "error of l1_density"
        # A cost that noise cannot reorder: steps times particles.
        cost = lambda row: int(row["steps"]) * int(row["fluid particles"])
        within = [r for r in rows if float(r[error]) <= .04]
        out = self.ok(STUDY, "minimal", f"{CASES}/sod.toml", "--error", ".04", "-o", "less", *axes)
        found = re.search(r"The cheapest setting within 0\.04: (\S+), h = (\S+) d_ref, spacing (\S+):",
                          out)
        self.assertIsNotNone(found, out)
        row = next(r for r in within if (r["kernel"], r["h"], r["spacing"]) == found.groups())
        self.assertLessEqual(cost(row), 1.5 * min(map(cost, within)))
        with open(self.path("less", "tried.csv")) as file:
            tried = list(csv.DictReader(file))
        self.assertLessEqual(sum(map(cost, tried)), sum(map(cost, rows)) / 3)
        # What it printed is a case.
        self.ok(IC, "generate", "less/sod_minimal.toml", "-q", "--no-report", "-o", "set.hdf")

    def test_kernels_pair_where_their_transform_says(self):
        self.ok(STUDY, "stability", "pairing", "--kernels", "cubic_spline,wendland_c2",
                "--smoothing-length", "2", "--seeds", "1", "-o", "maps")
        with open(self.path("maps", "pairing_2d.csv")) as file:
            share = {row["kernel"]: float(row["f.5"]) for row in csv.DictReader(file)}
        self.assertGreater(share["cubic_spline"], .9)
        self.assertEqual(share["wendland_c2"], 0)
        self.assertIn("5.69", self.ok(STUDY, "stability", "transforms", "-o", "maps"))
        for name in ("pairing_2d.png", "transforms.csv", "transforms_3d.svg"):
            self.assertTrue(os.path.exists(self.path("maps", name)), name)

    @unittest.skipUnless(CHROMIUM, "no chromium here: the report was not looked at in a browser")
    def test_a_browser_shows_the_report(self):
        self.ok(*self.accuracy("--vary", "kernel=convex,wendland_c2_1d", "--vary", "h=1.3,1.5"))
        with open(self.path("study", "report.html")) as file:
            html = file.read()
        # What the page draws, said by the page itself once it stands.
        probe = """<script>addEventListener("load", () => {
          const boxes = [...document.querySelectorAll("svg")].map(s => s.getBoundingClientRect());
          const said = document.createElement("p"); said.id = "probe";
          said.textContent = "svgs " + boxes.filter(b => b.width > 300 && b.height > 150).length +
            " tips " + [...document.querySelectorAll("svg title")].filter(
              t => t.textContent.includes("d_ref")).length +
            " images " + [...document.images].filter(i => i.naturalWidth > 100).length +
            " rows " + document.querySelectorAll("tbody tr").length;
          document.body.append(said); });</script>"""
        self.write("probe.html", html.replace("</body>", probe + "</body>"))
        page = self.browse("probe.html#sort=-3", "--dump-dom", "--virtual-time-budget=5000")
        said = re.search(r'<p id="probe">svgs (\d+) tips (\d+) images (\d+) rows (\d+)', page)
        self.assertIsNotNone(said, page[-500:])
        svgs, tips, images, rows = map(int, said.groups())
        self.assertEqual((svgs, rows), (2, 4))
        self.assertGreaterEqual(tips, 4)
        self.assertGreaterEqual(images, 1)
        body = page[page.index("<tbody>"):]
        errors = [float(re.findall(r"<td[^>]*>([^<]*)</td>", row)[2])
                  for row in re.findall(r"<tr>(.*?)</tr>", body, re.S)]
        self.assertEqual(errors, sorted(errors, reverse=True))
        self.assertIn('aria-sort="descending"', page)

    def browse(self, page, *options):
        done = subprocess.run([CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu",
                               f"--user-data-dir={self.path('browser')}", *options,
                               f"file://{self.folder}/{page}"],
                              capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotRegex(done.stderr, "(?i)uncaught|SyntaxError")
        return done.stdout


if __name__ == "__main__":
    unittest.main(verbosity=2)
