# SPDX-License-Identifier: GPL-3.0-or-later
"""A tank that starts hydrostatic stays at rest; one that starts with a constant density falls."""

import csv
import math
import os
import unittest

import figures
from harness import CASES, IC, SPH, Programs

CASE = os.path.join(CASES, "initial_conditions", "tank_at_rest.toml")
WAVE = math.sqrt(9.81 * 0.8)  # sqrt(g H) of the case [m/s]
AT_REST = 0.01  # of sqrt(g H): what users may ask of a set
# With a constant density the water at the surface falls freely, by g t, until the pressure wave from
# the floor has come, after .02 s and more: 7 % of sqrt(g H).
FALLS = 0.05

STARTS = {
    "hydrostatic": lambda text: text,
    "constant density": lambda text: "\n".join(
        line for line in text.splitlines() if not line.startswith("hydrostatic")),
}
SETS = {
    "relaxed, conformal walls": lambda text: text,
    "hexagonal, walls that continue it": lambda text: text.replace("[relax]\n", "").replace(
        "method      = \"conformal\"\n", ""),
}


class AtRest(Programs):
    def speeds(self, text):
        """[(time [s], fastest particle over sqrt(g H)), ...]"""
        self.write("tank.toml", text)
        self.ok(IC, "generate", "tank.toml", "-q", "--no-report")
        self.ok(SPH, "run", "tank.hdf", "-q", "-o", "run")
        with open(self.path("run", "history.csv")) as file:
            return [(float(row["time [s]"]), float(row["max_speed [m/s]"]) / WAVE)
                    for row in csv.DictReader(file)]

    def test_only_if_it_starts_hydrostatic(self):
        with open(CASE) as file:
            case = file.read()
        rows = [("start", "set", "fastest, % of sqrt(g H)", "at [s]")]
        curves = {}
        for start, change in STARTS.items():
            for of, make in SETS.items():
                speeds = self.speeds(change(make(case)))
                self.assertAlmostEqual(speeds[-1][0], 0.1)
                time, fastest = max(speeds, key=lambda point: point[1])
                rows.append((start, of, 100 * fastest, time))
                curves[f"{start}; {of}"] = [(t, 100 * v) for t, v in speeds if v > 0]
                if start == "hydrostatic":
                    self.assertLess(fastest, AT_REST, of)
                else:
                    self.assertGreater(fastest, FALLS, of)
        figures.table("at_rest", rows)
        figures.chart("at_rest", "Fastest particle of a tank that should be at rest",
                      ("time [s]", "speed [% of sqrt(g H)]"), curves,
                      "set logscale y", "set yrange [0.01:30]",
                      "set arrow from 0,1 to 0.1,1 nohead lc rgb '#999999' dt 2")


if __name__ == "__main__":
    unittest.main()
