# SPDX-License-Identifier: GPL-3.0-or-later
"""Gases that cannot be run get one line with key, value and remedy, and nothing is lost."""

import os
import unittest

from harness import CASES, IC, SPH, Programs


class GasErrors(Programs):
    def generate(self, case, *sets):
        return (IC, "generate", f"{CASES}/{case}.toml", "-q", "--no-report", "--quick", "-o",
                "gas.hdf", *(word for value in sets for word in ("--set", value)))

    def not_made(self, case, setting, *expected):
        self.refused(self.generate(case, setting), *expected)
        self.assertFalse(os.path.exists(self.path("gas.hdf")))

    def not_run(self, case, sets, *expected, code=1):
        self.ok(*self.generate(case, *sets))
        return self.refused((SPH, "run", "gas.hdf", "-q", "-o", "out"), *expected, code=code)

    def test_settings_out_of_range(self):
        self.not_made("noh", "solver.adiabatic_index=1", "adiabatic_index = 1", "(1, 10]")
        self.not_made("noh", "fluid[0].internal_energy=-1", "fluid[0].internal_energy = -1", "> 0")

    def test_boxes_and_blobs_that_do_not_fit(self):
        self.not_made("pairing_3d", "domain.upper=[0.2, 1, 1]", "pairing_3d.toml:",
                      "periodic axis x is 0.2 m long", "twice the kernel's support", "make it longer")
        self.not_made("blob_wind_tunnel_2d", "geometry.blob.disk.radius=6",
                      "blob_wind_tunnel_2d.toml:", 'fluid "blob"', "12 m long",
                      "make the region smaller")

    def test_densities_that_are_not_sums(self):
        self.not_made("noh", "solver.density=continuity", "solver.density", '"continuity"',
                      'does not go with', 'set density = "summation"')

    def test_settings_that_do_not_go_together(self):
        """Both programs refuse them, before anything is written."""
        for setting, *expected in (
                ("solver.collisions={}", "solver.collisions", "is for liquids"),
                ("solver.viscosity.tensor={}", "solver.viscosity", "several artificial viscosities"),
                ("solver.self_term_correction=true", "solver.self_term_correction", "in 2-D"),
                ("solver.wall_pressure=extrapolated", "solver.wall_pressure", '"initial" or "zero"'),
                ("solver.tait_exponent=7", "solver.tait_exponent", "has no effect", "leave it out"),
                ("solver.sound_speed=7", "solver.sound_speed", "has no effect"),
                ("solver.adaptive.change_limit=0.1", "solver.adaptive.change_limit", "no effect"),
                ("solver.smoothing_length=0.7", "solver.smoothing_length", "too small", "above 0.746")):
            self.not_made("noh", setting, *expected)
            self.ok(*self.generate("noh"))
            self.refused((SPH, "run", "gas.hdf", "-q", "-o", "out", "--set", setting), *expected)
            self.assertFalse(os.path.exists(self.path("out", "history.csv")))
            os.remove(self.path("gas.hdf"))
        self.not_made("isothermal_shock", "solver.adiabatic_index=1.4", "has no effect")
        self.not_made("isothermal_shock", "solver.conductivity={}", "only an ideal gas has")

    def test_gas_that_outgrows_its_box(self):
        """Smoothing lengths of a gas that thins out are larger than the periodic box has room for."""
        case = self.write("thin.toml", """
            dimension = 1
            spacing = 0.05
            domain = { lower = [-1], upper = [1], periodic = ["x"] }
            output = { every = 1 }
            [[fluid]]
            density = 1
            internal_energy = 0.01
            velocity_formula = ["8*x"]
            [solver]
            equation_of_state = "ideal_gas"
            integrator = "kick_drift_kick"
            smoothing_length = 4
            adaptive = {}
            viscosity = { monaghan = { alpha = 1, beta = 2 } }
            end_time = 5
            """)
        self.ok(IC, "generate", case, "-q", "--no-report", "-o", "gas.hdf")
        line = self.refused((SPH, "run", "gas.hdf", "-q", "-o", "out"), "periodic axis x",
                            "twice the kernel's support", "out/gas_failed.hdf", code=2)
        self.assertRegex(line, r"at t = 0\.\d+ s, step \d+: ")

    def test_cuts_beside_the_set(self):
        self.ok(*self.generate("sod_3d"))
        self.refused((IC, "preview", "gas.hdf", "--slice", "y=99", "--smooth", "-q"),
                     "--slice y=99", "reaches from")
        os.remove(self.path("gas.hdf"))
        self.not_made("sedov_2d", "fluid[0].energy_deposit.point=[5, 5]",
                      "fluid[0].energy_deposit.point", "outside of the domain")

    def test_smoothing_lengths_that_do_not_converge(self):
        self.not_run("noh", ["solver.adaptive.max_iterations=1", "solver.adaptive.tolerance=1e-14"],
                     "particle ", "does not converge", "after 1 iterations",
                     "max_iterations", code=2)

    def test_an_energy_that_turns_negative_leaves_the_last_sound_state(self):
        self.not_run("sod", ["solver.time_step=0.02"], "particle ", "internal energy", "t = 0.02 s",
                     "solver.time_step=", "out/gas_failed.hdf", code=2)
        self.assertIn("t = 0.02 s", self.ok(SPH, "info", self.path("out", "gas_failed.hdf")))

    def tunnel(self, *sets, edit=None):
        """The command that makes the open wind tunnel, with its text changed by edit(text)."""
        with open(f"{CASES}/blob_wind_tunnel_2d_open.toml") as file:
            text = file.read()
        case = self.write("tunnel.toml", edit(text) if edit else text)
        return (IC, "generate", case, "-q", "--no-report", "--quick", "-o", "gas.hdf",
                *(word for value in sets for word in ("--set", value)))

    def no_stream(self, sets, *expected, edit=None, code=1):
        self.ok(*self.tunnel(*sets, edit=edit))
        line = self.refused((SPH, "run", "gas.hdf", "-q", "-o", "out"), *expected, code=code)
        if code == 1:
            self.assertFalse(os.path.exists(self.path("out", "history.csv")), line)
        return line

    def test_an_inflow_that_meets_a_wall(self):
        def with_post(lower):
            """A post of 1 m by 2 m in the tunnel."""
            wind = 'wind   = { difference = ["tunnel", "blob"] }'
            post = f"post = {{ box = {{ lower = [{lower}, -1], upper = [{lower + 1}, 1] }} }}\n"
            return lambda text: text.replace(
                wind, post + wind.replace('"blob"', '"blob", "post"')).replace(
                "\n[solver]", '\n[[wall]]\nname = "grid"\nregion = "post"\n\n[solver]')
        for lower, where in ((-5.2, "beyond the plane"), (-4, "m from the plane")):
            self.no_stream([], "tunnel.toml: [[solver.inflow]]", "at = -4.5", 'side = "lower"',
                           'meets wall "grid"', where, "keep walls 1.4", "away from the plane",
                           edit=with_post(lower))
        self.no_stream([], "tunnel.toml: [[solver.outflow]]", "at = 13", 'meets wall "grid"',
                       edit=with_post(11.5))

    def test_planes_where_there_is_no_stream(self):
        self.no_stream(["solver.inflow[0].at=-40"], "tunnel.toml: [[solver.inflow]]", "at = -40",
                       "outside of the fluid", "from -5.9", "to 14.9", "move the plane")
        self.no_stream(["solver.inflow[0].length=1"], "[[solver.inflow]]", "length = 1 m",
                       "less than twice the kernel's support, 1.49", "set length")
        self.no_stream(["solver.inflow[0].length=2"], "[[solver.inflow]]", "length = 2 m",
                       "reaches only 1.4", "or make length shorter")
        self.no_stream(["solver.inflow[0].at=-4.4", "solver.inflow[0].length=1.6"],
                       "[[solver.inflow]]", "whole periods", "set length = 1.")
        self.no_stream(["fluid[1].velocity=[-2.7, 0]"], "[[solver.inflow]]", "does not come in",
                       "-2.7 m/s", "give the [[fluid]] there a velocity")
        self.no_stream(['domain.periodic=["x", "y"]'], "[[solver.inflow]]", "periodic axis x",
                       "domain.periodic")

    def test_streams_that_cannot_be(self):
        self.no_stream(["solver.integrator=symplectic_euler"], "solver.inflow", "kick_drift_kick")
        line = self.refused(self.tunnel(edit=lambda text: text.replace('side   = "lower"',
                                                                       'axis = "z"')),
                            "inflow[0].axis", "a 2-D case has no axis z")
        self.assertRegex(line, r"tunnel\.toml:\d+:")
        self.refused(self.tunnel("solver.inflow[0].length=-1"), "length = -1", "> 0")
        self.refused(self.tunnel("solver.inflow[0].depth=1"), "depth", "unknown key")

    def test_gas_that_flows_back_stops_the_run(self):
        """A cloud that bursts in a slow wind throws gas against it."""
        line = self.no_stream(["fluid[1].velocity=[0.2, 0]", "fluid[0].pressure=60"], "particle ",
                              "flows back out through the inflow at x = -4.5 m",
                              "move the plane further away", "out/gas_failed.hdf", code=2)
        self.assertRegex(line, r"at t = [\d.]+ s, step \d+: particle .* with [\d.]+ m/s")


if __name__ == "__main__":
    unittest.main()
