# SPDX-License-Identifier: GPL-3.0-or-later
"""Which kernels pair at how many neighbours in 3-D: shares of particles nearer than half of
(V/N)^(1/3) to another, after ten sound crossings from a random start. With PLENUM_FIGURES the whole
table, means over three seeds; else what fits into a minute."""

import math
import unittest

import figures
from harness import CASES, IC, SPH, Programs

NEIGHBOURS = (32, 48, 64, 80, 100, 200, 400)
# Shares by a program of its own (means over seeds).
ANOTHER = {"cubic_spline": (0, 0, .44, .81, .92, .96, .97),
         "wendland_c2_1d": (.37, .68, .80, .84, .87, .96, .96),
         "quintic_spline": (0, 0, 0, 0, 0, .09, .25),
         **{kernel: (0,) * 7 for kernel in
            ("wendland_c2", "wendland_c4", "wendland_c6", "convex", "core_triangle")}}
QUICK = {"cubic_spline": (48, 64, 100), "wendland_c2_1d": (32, 64), "quintic_spline": (64,),
         "wendland_c2": (64, 100), "convex": (64,)}
# Seeds scatter by some hundredths, most of all where pairing sets in.
SCATTER = .1
SPACING = 0.0935385  # d_ref of hcp with (V/N)^(1/3) = 1/12, of the case


class Pairing(Programs):
    def share(self, kernel, neighbours, seed):
        """Of the particles at t = 10 L/c."""
        import h5py
        import numpy
        length = (3 * neighbours / (32 * math.pi)) ** (1 / 3) / (12 * SPACING)
        self.ok(IC, "generate", f"{CASES}/pairing_3d.toml", "-q", "--no-report", "-o", "set.hdf",
                "--set", f"solver.kernel={kernel}", "--set", f"solver.smoothing_length={length}",
                "--set", f"fluid[0].seed={seed}")
        self.ok(SPH, "run", "set.hdf", "-q", "--anew", "-o", "out", "--set", "output.every=10")
        with h5py.File(self.path("out", "set_end.hdf")) as file:
            x = file["VTKHDF/Points"][:]
        nearest = numpy.full(len(x), numpy.inf)
        for k in range(len(x)):
            r = x - x[k]
            r -= numpy.round(r)  # the nearest image in the unit box
            squared = (r * r).sum(axis=1)
            squared[k] = numpy.inf
            nearest[k] = squared.min()
        return float((nearest < (0.5 / len(x) ** (1 / 3)) ** 2).mean())

    def test_shares(self):
        whole = bool(figures.FOLDER)
        seeds = (1, 2, 3) if whole else (1,)
        rows, curves = [("f.5 (another)", *map(str, NEIGHBOURS))], {}
        for kernel, another in ANOTHER.items():
            row, curve = [kernel], []
            for neighbours, expected in zip(NEIGHBOURS, another):
                if not whole and neighbours not in QUICK.get(kernel, ()):
                    row.append("-")
                    continue
                share = sum(self.share(kernel, neighbours, s) for s in seeds) / len(seeds)
                row.append(f"{share:.2f} ({expected:g})")
                curve.append((neighbours, share))
                self.assertAlmostEqual(share, expected, delta=SCATTER, msg=(kernel, neighbours))
            rows.append(row)
            if any(share > 0 for _, share in curve):
                curves[kernel] = curve
        figures.table("pairing_3d", rows)
        figures.chart("pairing_3d", "Pairs after ten sound crossings from a random start, 3-D",
                      ("neighbours within the support", "share of particles with nn < .5 (V/N)^(1/3)"),
                      {**curves, "the other five kernels": [(n, 0) for n in NEIGHBOURS]},
                      "set logscale x", "set xrange [28:450]", "set yrange [-.02:1]",
                      f"set xtics ({', '.join(map(str, NEIGHBOURS))})")


if __name__ == "__main__":
    unittest.main()
