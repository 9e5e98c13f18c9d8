# SPDX-License-Identifier: GPL-3.0-or-later
"""Gases against exact solutions: errors by viscosity, by smoothing length and by number of
particles. Figures that others measured stand beside ours."""

import csv
import math
import subprocess
import unittest

import figures
from harness import IC, SPH, Programs

VISCOSITIES = {
    "none": None,
    "bulk": "{bulk={alpha=0.8}}",
    "von Neumann-Richtmyer": "{neumann_richtmyer={alpha=0.8}}",
    "tensor (.8, 0, .1)": "{tensor={alpha_1=0.8, alpha_2=0, beta=0.1}}",
    "tensor (.8, .5, .1)": "{tensor={alpha_1=0.8, alpha_2=0.5, beta=0.1}}",
    "linear combination": "{bulk={alpha=0.8}, neumann_richtmyer={alpha=0.8}}",
}
# Relative L1 of the density in the tube 4 : 1 and in two streams at Mach 2, by a program of its own
# for 1-D; velocity noise behind the shock.
ANOTHER = {"bulk": (.0059, .0043, .042, .218), "von Neumann-Richtmyer": (.0097, .042, .0165, .14),
         "tensor (.8, 0, .1)": (.0041, .0003, .0082, .023),
         "tensor (.8, .5, .1)": (.0041, .0003, .0037, .0036),
         "linear combination": (.0063, .0031, .0093, .037)}


# L1 of density and velocity in tests/functional/Hydro/Noh/Noh-planar-1d.py of github.com/LLNL/spheral:
# 100 particles from x = 0 to 1 before a mirror, quintic spline over 4.05 spacings, t = .6, mean over
# .05 <= x <= .35.
SPHERAL = {"SPH": (.0538, .0245), "CRKSPH": (.0506, .0077), "PSPH": (.0607, .0259),
           "GSPH": (.0484, .0226), "FSISPH": (.0803, .0260), "MFM": (.0874, .0365)}

PLANE_NOH = """
    dimension = 1
    spacing = {spacing}
    geometry = {{ all = {{ box = {{ lower = [-1], upper = [1] }} }} }}
    output = {{ every = 0.6 }}
    [[fluid]]
    region = "all"
    lattice = "uniform"
    density = 1
    internal_energy = 1e-6
    velocity_formula = ["-x/r"]
    [solver]
    equation_of_state = "ideal_gas"
    adiabatic_index = 1.6666666666666667
    kernel = "quintic_spline"
    smoothing_length = 2.025
    adaptive = {{ form = "grad_h" }}
    viscosity = {{ monaghan = {{ alpha = 1, beta = 1 }} }}
    integrator = "kick_drift_kick"
    end_time = 0.6
    """


class Gas(Programs):
    def test_isothermal_shocks_by_viscosity(self):
        rows = [("viscosity", "tube: L1 rho", "another", "L1 v", "noise", "another", "width/h",
                 "streams: L1 rho", "another", "noise", "another")]
        found = {}
        for name, viscosity in VISCOSITIES.items():
            if viscosity is None:
                continue
            row = [name]
            for case, k in (("isothermal_shock", 0), ("colliding_streams", 2)):
                m = self.run_case(case, f"solver.viscosity={viscosity}",
                                  "solver.integrator=symplectic_euler")[0]["measures"]
                found[name, case] = m
                row += [m["l1_density"], ANOTHER[name][k]]
                if k == 0:
                    row.append(m["l1_velocity"])
                row += [m["velocity_noise"], ANOTHER[name][k + 1]]
                if k == 0:
                    row.append(m["shock_width"])
            rows.append(row)
        figures.table("isothermal_shock", rows)

        def l1(name, case="isothermal_shock"):
            return found[name, case]["l1_density"]
        for tensor in ("tensor (.8, 0, .1)", "tensor (.8, .5, .1)"):
            self.assertLessEqual(l1(tensor), .005)
            # The other program's window for the tube differs by some h: a tenth of its error.
            self.assertAlmostEqual(l1(tensor), ANOTHER[tensor][0], delta=.0004)
            # The combination and bulk are within a tenth of each other, in both programs.
            self.assertLess(l1(tensor), l1("bulk"))
            self.assertLess(l1("bulk"), l1("linear combination"))
            self.assertLess(l1("linear combination"), l1("von Neumann-Richtmyer"))
            # Streams: particles pass through each other at first, and what that leaves depends on the
            # step and on how kernels of two lengths are made one. The other program takes the
            # kernel of the mean length; with the mean of the two kernels, as here, it has .0131 to
            # .0145 for the first tensor and .0103 for the combination: their order is not compared.
            streams = "colliding_streams"
            self.assertLess(l1(tensor, streams), l1("von Neumann-Richtmyer", streams))
            self.assertLess(l1("linear combination", streams), l1("von Neumann-Richtmyer", streams))
            self.assertLess(l1("von Neumann-Richtmyer", streams), l1("bulk", streams))
            self.assertLess(l1("tensor (.8, .5, .1)", streams),
                            .6 * l1("linear combination", streams))
            noise = found[tensor, "isothermal_shock"]["velocity_noise"]
            richtmyer = found["von Neumann-Richtmyer", "isothermal_shock"]["velocity_noise"]
            self.assertGreater(richtmyer, 10 * noise)

    def test_sixteen_to_one(self):
        sixteen = ("fluid[0].density=16", "measures.riemann.left.density=16", "spacing=0.1",
                   "solver.integrator=symplectic_euler")
        forms = {"constant": ['solver.adaptive.form="constant"'], "from the mean density": [],
                 **{f"the same, at most {100 * share:g} % a step":
                    [f"solver.adaptive.change_limit={share}"] for share in (.03, .003)},
                 "from the own density, grad-h terms": ['solver.adaptive.form="grad_h"']}
        # The other program, with a tube long enough that nothing comes from its ends.
        another = {"constant": .0165, "from the mean density": .0026}
        rows = [("smoothing length, 16 : 1", "L1 rho", "another")]
        l1 = {}
        for name, form in forms.items():
            l1[name] = self.run_case("isothermal_shock", *sixteen, *form)[0]["measures"]["l1_density"]
            rows.append((name, l1[name], another.get(name, "-")))
        figures.table("smoothing_lengths", rows)
        for name, expected in another.items():
            # Kernels of two lengths are made one in another way there.
            self.assertAlmostEqual(l1[name], expected, delta=.1 * expected)
        # Measured 7.3 times as accurate.
        self.assertGreater(l1["constant"], 6 * l1["from the mean density"])

    # case: (sizes as d_ref, the least order from the first to the last, column). Shocks: .8 is asked.
    # In 3-D the blast's shell is thinner than h at such N, measured .31; the vortex loses its corner
    # to the viscosity, measured .64 (both docs/validation.md).
    CONVERGENCE = {
        "isothermal_shock": ((.1, .05, .025), .8, "l1_density"),
        "sod": ((.01, .005, .0025), .8, "l1_density"),
        "noh": ((.04, .02, .01), .8, "l1_density"),
        "sedov_2d": ((.01, .005, .0025), .8, "l1_density"),
        "sedov": ((.05, .025), .25, "l1_density"),
        "gresho": ((.04, .02, .01), .6, "l1_velocity"),
    }

    def test_convergence(self):
        rows = [("case", "N", "norm", "error", "order", "energy drift", "M updates/s")]
        curves = {}
        for case, (sizes, least, column) in self.CONVERGENCE.items():
            errors = []
            for size in sizes:
                more = ([f"fluid[0].energy_deposit.radius={3 * size}"] if case.startswith("sedov") else [])
                summary, columns = self.run_case(case, f"spacing={size}", *more)
                errors.append(summary["measures"][column])
                order = (math.log(errors[-2] / errors[-1]) / math.log(sizes[len(errors) - 2] / size)
                         if len(errors) > 1 else None)
                energies = columns["energy_total"]
                drift = max(abs(e / energies[0] - 1) for e in energies)
                n = summary["fluid_particles"]
                rows.append((case, str(n), column, errors[-1],
                             "-" if order is None else f"{order:.2f}",
                             "-" if case == "isothermal_shock" else f"{drift:.1e}",
                             f"{summary['updates_per_second'] / 1e6:.2f}"))
                curves.setdefault(case, []).append((n, errors[-1]))
                if case == "sod":
                    self.assertLess(drift, 1e-3)
            whole = math.log(errors[0] / errors[-1]) / math.log(sizes[0] / sizes[-1])
            self.assertGreaterEqual(whole, least, case)
        figures.table("gas_convergence", rows)
        figures.chart("gas_convergence", "Gases against exact solutions",
                      ("particles", "error"), curves, "set logscale xy")

    def test_noh_beside_another_code(self):
        """The plane problem in 1-D by the norm, the time and the numbers of another code's tests."""
        rows = [("Noh, 1-D, 100 particles on each side", "L1 rho", "L1 v")]
        rows += [(f"Spheral, {scheme}", *errors) for scheme, errors in SPHERAL.items()]
        found = []
        for n in (100, 200, 400):
            case = self.write("plane.toml", PLANE_NOH.format(spacing=1 / n))
            self.ok(IC, "generate", case, "-q", "--no-report", "-o", "plane.hdf")
            self.ok(SPH, "run", "plane.hdf", "-q", "--anew", "-o", "out")
            self.ok(IC, "export", self.path("out", "plane_end.hdf"), "-q", "-o", "end.csv")
            with open(self.path("end.csv")) as file:
                particles = list(csv.DictReader(file))
            errors = [mean_error(particles, "density [kg/m]", lambda x: 4 if x < .2 else 1),
                      mean_error(particles, "velocity_x [m/s]", lambda x: 0 if x < .2 else -1)]
            found.append(errors[0])
            rows.append((f"this program, {n}", *errors))
        figures.table("noh_beside_spheral", rows)
        # As the largest of the others: they limit the viscosity by the gradient of the velocity or
        # solve Riemann problems, [N]'s Pi does neither.
        self.assertLess(found[0], .09)
        for coarse, fine in zip(found, found[1:]):
            self.assertGreaterEqual(math.log2(coarse / fine), .8)

    def test_figure_three(self):
        """Density and velocity of the tube by viscosity, as figure 3 of [A]."""
        if not figures.FOLDER:
            self.skipTest("a figure only")
        panels = ""
        for name, viscosity in VISCOSITIES.items():
            without = ["viscosity"] if viscosity is None else []
            sets = [] if viscosity is None else [f"solver.viscosity={viscosity}"]
            self.run_case("isothermal_shock", *sets, without=without)
            panels += panel(name, profile(self.path("out", "set_end.hdf")))
        script = (f"set terminal pngcairo size 1000,1200 font 'DejaVu Sans,10' noenhanced\n"
                  f"set output '{figures.FOLDER}/isothermal_shock.png'\n"
                  "set multiplot layout 3,2 title 'Isothermal shock tube 4 : 1, t = 5'\n"
                  "set xrange [4:20]\nset yrange [-.3:4.5]\nset grid lc rgb '#dddddd' lt 1\n"
                  "set key top right\n" + exact_block() + panels + "unset multiplot\n")
        subprocess.run(["gnuplot"], input=script, text=True, check=True)


def mean_error(particles, column, exact, lower=.05, upper=.35):
    """The mean of |value - exact(x)| over lower <= x <= upper; a particle stands for the way to the
    middles between it and its neighbours."""
    points = sorted((float(p["position_x [m]"]), float(p[column])) for p in particles)
    total = length = 0
    for (before, _), (x, value), (after, _) in zip(points, points[1:], points[2:]):
        left, right = (min(max(y, lower), upper) for y in ((before + x) / 2, (x + after) / 2))
        total += (right - left) * abs(value - exact(x))
        length += right - left
    return total / length


def profile(path):
    """(x, density, velocity) of the particles in the published half of the tube."""
    import h5py
    with h5py.File(path) as file:
        x = file["VTKHDF/Points"][:, 0]
        half = (x > 4) & (x < 20)
        return sorted(zip(x[half], file["PartType0/Density"][:][half],
                          file["PartType0/Velocities"][:, 0][half]))


def exact_block():
    """The exact solution at t = 5: rarefaction, plateau, shock."""
    rho, v, shock, t = 1.9865, .6999, 1.4094, 5.0
    places = [4 + .02 * k for k in range(801)]
    lines = ""
    for x in places:
        xi = (x - 12) / t
        if xi < -1:
            state = (4, 0)
        elif xi < v - 1:
            state = (4 * math.exp(-(xi + 1)), xi + 1)
        else:
            state = (rho, v) if xi < shock else (1, 0)
        lines += f"{x} {state[0]} {state[1]}\n"
    return f"$exact << EOD\n{lines}EOD\n"


def panel(name, points):
    label = name.replace(" ", "").translate(str.maketrans("", "", "(),.-"))
    block = f"$p{label} << EOD\n" + "".join(f"{x} {r} {v}\n" for x, r, v in points) + "EOD\n"
    return block + (f"set title '{name}'\n"
                    f"plot $exact using 1:2 with lines lc rgb '#999999' title 'exact', "
                    f"$exact using 1:3 with lines lc rgb '#999999' notitle, "
                    f"$p{label} using 1:2 with points pt 7 ps .3 lc rgb '#0b5394' title 'density', "
                    f"$p{label} using 1:3 with points pt 7 ps .3 lc rgb '#b45f06' title 'velocity'\n")


if __name__ == "__main__":
    unittest.main()
