# SPDX-License-Identifier: GPL-3.0-or-later
"""Sets made here are initial conditions of SWIFT, tables and .vtu files; positions come back in."""

import base64
import csv
import struct
import unittest
import zlib

import h5py
import meshio
import numpy

from harness import CASES, IC, Programs

TANK = """
dimension = 2
spacing = 0.1
[geometry]
tank = { box = { lower = [-0.5, 0.25], upper = [0.5, 1.25] } }
[[fluid]]
region = "tank"
density = 1000.0
LATTICE
[[wall]]
outside = "tank"
"""

BOX = """
dimension = 3
spacing = 0.25
domain = { lower = [0, 0, 0], upper = [2, 2, 2], periodic = ["x", "y", "z"] }
fluid = [{ name = "gas", density = 1.5, FLUID }]
"""

# What SWIFT and GADGET ask of /PartType0: name -> (kind and size of the numbers, columns).
REQUIRED = {"Coordinates": ("f8", 3), "Velocities": ("f8", 3), "Masses": ("f8", 1),
            "SmoothingLength": ("f8", 1), "InternalEnergy": ("f8", 1), "Density": ("f8", 1),
            "ParticleIDs": ("u8", 1)}


class Sets(Programs):
    def generate(self, text, name="set.hdf"):
        self.ok(IC, "generate", self.write("set.toml", text), "-o", name, "--no-report")
        return self.path(name)

    def tank(self, name="set.hdf"):
        return self.generate(TANK.replace("LATTICE", 'lattice = "square"'), name)

    def imported(self, positions, name="imported.hdf"):
        """Scene positions of the fluid of a tank that is filled from a file."""
        self.generate(TANK.replace("LATTICE", f"positions = {positions}"), name)
        with h5py.File(self.path(name)) as file:
            return file["VTKHDF/Points"][:file["Plenum"].attrs["NumberOfFluids"]]

    def refuse(self, positions, *expected, case=TANK.replace("LATTICE", "positions = FILE")):
        path = self.write("bad.toml", case.replace("FILE", positions))
        return self.refused((IC, "generate", path, "-o", "bad.hdf"), *expected)


class InitialConditionsOfSwift(Sets):
    def check(self, path, dimension):
        with h5py.File(path) as file:
            header, gas = file["Header"].attrs, file["PartType0"]
            n = len(gas["Coordinates"])
            self.assertGreater(n, 0)
            self.check_header(header, n, dimension)
            self.check_units(file["Units"].attrs)
            for name, (kind, columns) in REQUIRED.items():
                self.assertEqual(gas[name].dtype, numpy.dtype(kind), name)
                self.assertEqual(gas[name].shape, (n, 3) if columns == 3 else (n,), name)
                self.assertTrue(numpy.isfinite(gas[name][:].astype(float)).all(), name)
            self.check_coordinates(gas["Coordinates"][:], header["BoxSize"], dimension)
            self.check_numbers(gas["ParticleIDs"][:], gas["ParticleTypes"][:] == 1)
            for name in ("Masses", "SmoothingLength", "Density"):
                self.assertTrue((gas[name][:] > 0).all(), name)
            self.assertTrue((gas["InternalEnergy"][:] >= 0).all())
            self.assertTrue((gas["Velocities"][:, dimension:] == 0).all())
            h = gas["SmoothingLength"].attrs  # SWIFT's h is another one: ours must say what it is
            self.assertTrue(h["KernelName"].decode())
            self.assertEqual(h["SupportOverH"], 2)
            support = 2 * gas["SmoothingLength"][:].max()
            self.assertTrue((2 * support <= header["BoxSize"][:dimension]).all(),
                            "a particle would meet two images of a neighbour")

    def check_header(self, header, n, dimension):
        self.assertEqual(header["Dimension"], dimension)
        for name in ("NumPart_Total", "NumPart_ThisFile"):
            self.assertEqual(header[name].dtype.kind, "u" if name == "NumPart_Total" else "i")
            self.assertEqual(list(header[name]), [n, 0, 0, 0, 0, 0], name)
        self.assertEqual(header["NumPart_Total"].dtype.itemsize, 4)  # the rest is in the HighWord
        for name in ("NumPart_Total_HighWord", "MassTable"):
            self.assertEqual(list(header[name]), [0] * 6, name)
        self.assertEqual(header["BoxSize"].shape, (3,))
        self.assertEqual(header["BoxSize"].dtype, numpy.dtype("f8"))
        self.assertTrue((header["BoxSize"] > 0).all())
        for name, value in (("Flag_Entropy_ICs", 0), ("NumFilesPerSnapshot", 1), ("Time", 0),
                            ("Redshift", 0)):
            self.assertEqual(header[name], value, name)

    def check_units(self, units):
        """SI in cgs, under the names that SWIFT looks for."""
        self.assertEqual({name: units[name] for name in units},
                         {"Unit length in cgs (U_L)": 100, "Unit mass in cgs (U_M)": 1000,
                          "Unit time in cgs (U_t)": 1, "Unit current in cgs (U_I)": 1,
                          "Unit temperature in cgs (U_T)": 1})

    def check_coordinates(self, x, box, dimension):
        self.assertTrue((x >= 0).all() and (x < box).all())
        self.assertTrue((x[:, dimension:] == 0).all())
        self.assertEqual(len(numpy.unique(x, axis=0)), len(x), "two particles at one place")

    def check_numbers(self, ids, is_wall):
        self.assertEqual(sorted(ids), list(range(1, len(ids) + 1)))
        self.assertEqual(set(ids[is_wall]), set(range(1, is_wall.sum() + 1)), "walls come first")

    def test_a_tank_with_walls_that_is_shifted(self):
        self.check(self.tank(), 2)

    def test_a_periodic_box(self):
        path = self.generate(BOX.replace("FLUID", 'lattice = "cubic"'))
        self.check(path, 3)
        with h5py.File(path) as file:
            self.assertEqual(list(file["Header"].attrs["BoxSize"]), [2, 2, 2])
            # 8^3 particles of density 1.5 in 2^3 m^3, in SI: a sum of 512 equal numbers, 1e-13 each
            self.assertAlmostEqual(file["PartType0/Masses"][:].sum(), 12, delta=1e-10)

    def test_scenes_of_the_project(self):
        for case in ("gas_box", "rotating_shaft", "hydrostatic_tank"):
            self.ok(IC, "generate", f"{CASES}/{case}.toml", "-o", f"{case}.hdf", "--no-report")
            self.check(self.path(f"{case}.hdf"), 2)


class Export(Sets):
    def test_vtu_has_what_the_particle_file_has(self):
        with h5py.File(self.tank()) as file:
            self.ok(IC, "export", "set.hdf", "-o", "set.vtu")
            mesh = meshio.read(self.path("set.vtu"))
            numpy.testing.assert_array_equal(mesh.points, file["VTKHDF/Points"][:])
            numpy.testing.assert_array_equal(mesh.point_data["type"],
                                             file["PartType0/ParticleTypes"][:])
            numpy.testing.assert_array_equal(mesh.point_data["density"],
                                             file["PartType0/Density"][:])

    def test_csv_has_the_same_bits_with_units(self):
        with h5py.File(self.tank()) as file:
            self.assertIn("particles", self.ok(IC, "export", "set.hdf", "-o", "set.csv"))
            with open(self.path("set.csv"), newline="") as text:
                head, *rows = list(csv.reader(text))
            self.assertEqual(head[:4],
                             ["position_x [m]", "position_y [m]", "velocity_x [m/s]",
                              "velocity_y [m/s]"])
            self.assertIn("density [kg/m^2]", head)
            self.assertIn("pressure [Pa m]", head)
            columns = dict(zip(head, zip(*rows)))
            gas, n = file["PartType0"], len(rows)
            self.assertEqual(n, len(gas["Masses"]))
            for name, values in (("position_x [m]", file["VTKHDF/Points"][:, 0]),
                                 ("mass [kg]", gas["Masses"][:]), ("id", gas["ParticleIDs"][:]),
                                 ("normal_y", gas["Normals"][:, 1]),
                                 ("type", gas["ParticleTypes"][:])):
                read = numpy.array([float(cell) for cell in columns[name]])
                numpy.testing.assert_array_equal(read, values.astype(float), name)
            self.assertIn("1", columns["type"])

    def test_other_endings_and_inputs_are_refused(self):
        self.tank()
        self.refused((IC, "export", "set.hdf", "-o", "set.vtk"), "set.vtk", ".vtu or .csv")
        self.refused((IC, "export", "set.toml", "-o", "set.vtu"), "set.toml")
        self.refused((IC, "export", "set.hdf", "-o", "no/set.csv"), "no/set.csv", code=2)


class Import(Sets):
    """Sets of this and of other programs as places for a fluid."""

    def setUp(self):
        super().setUp()
        with h5py.File(self.tank()) as file:
            self.n = int(file["Plenum"].attrs["NumberOfFluids"])
            self.points = file["VTKHDF/Points"][:self.n]
            self.walls = len(file["VTKHDF/Points"]) - self.n
        self.assertEqual(self.n, 100)

    def test_what_we_export_comes_back_bit_by_bit_without_walls(self):
        self.ok(IC, "export", "set.hdf", "-o", "set.vtu")
        self.ok(IC, "export", "set.hdf", "-o", "set.csv")
        for name in ("set.vtu", "set.csv", "set.hdf"):
            with self.subTest(name):
                read = self.imported(f'{{ file = "{name}" }}')
                numpy.testing.assert_array_equal(read, self.points)
        text = TANK.replace("LATTICE", 'positions = { file = "set.vtu" }')
        _, _, err = self.start(IC, "generate", self.write("warn.toml", text), "-o", "warn.hdf")
        self.assertIn(f"{self.walls} wall particles", err)

    def test_mass_is_the_regions(self):
        self.imported('{ file = "set.hdf" }')
        with h5py.File(self.path("imported.hdf")) as file:
            # 1000 kg/m^2 in 1 m^2 over 100 particles, each rounded once: a few 1e-15 of 10
            numpy.testing.assert_allclose(file["PartType0/Masses"][:self.n], 10, rtol=1e-14)

    def test_meshio_in_every_encoding(self):
        cells = [("vertex", numpy.arange(self.n).reshape(-1, 1))]
        for kind in ("f8", "f4"):
            mesh = meshio.Mesh(self.points.astype(kind), cells)
            for options in ({"binary": False}, {"binary": True, "compression": None},
                            {"binary": True, "compression": "zlib"}):
                with self.subTest(kind=kind, **options):
                    meshio.vtu.write(self.path("m.vtu"), mesh, **options)
                    read = self.imported('{ file = "m.vtu" }')
                    # meshio's text has 12 digits: half of the last one of numbers from 1 to 10
                    numpy.testing.assert_allclose(read, self.points.astype(kind), rtol=0,
                                                  atol=0 if options["binary"] else 5e-12)
        meshio.vtu.write(self.path("m.vtu"), mesh, binary=True, compression="lzma")
        self.refuse('{ file = "m.vtu" }', "m.vtu", "vtkLZMADataCompressor", "zlib")

    def vtu(self, header, blocks, encoding="base64"):
        """A .vtu as ParaView writes it: appended, of two pieces, short blocks of zlib."""
        word = {4: "I", 8: "Q"}[header]
        arrays, elements = b"", ""
        for part in (self.points[:30], self.points[30:]):
            data = part.astype("f4").tobytes()
            if blocks:
                cut = [data[k:k + blocks] for k in range(0, len(data), blocks)]
                packed = [zlib.compress(block) for block in cut]
                head = struct.pack(f"<{3 + len(cut)}{word}", len(cut), blocks, len(data) % blocks,
                                   *map(len, packed))
            else:
                head, packed = struct.pack(f"<{word}", len(data)), [data]
            offset, body = len(arrays), b"".join(packed)
            if encoding == "raw":
                arrays += head + body
            else:
                arrays += base64.b64encode(head) + base64.b64encode(body)
            elements += f"""<Piece NumberOfPoints="{len(part)}" NumberOfCells='0'>
              <!-- a comment with <tags> --><PointData Scalars="a > b"></PointData>
              <Points><DataArray type="Float32" Name="Points" NumberOfComponents="3"
                format="appended" offset="{offset}" /></Points></Piece>"""
        compressor = 'compressor="vtkZLibDataCompressor"' if blocks else ""
        with open(self.path("p.vtu"), "wb") as f:
            f.write(f"""<?xml version="1.0"?><VTKFile type="UnstructuredGrid" version="1.0"
              byte_order="LittleEndian" header_type="UInt{8 * header}" {compressor}>
              <UnstructuredGrid>{elements}</UnstructuredGrid>
              <AppendedData encoding="{encoding}">\n _""".encode())
            f.write(arrays + b"</AppendedData></VTKFile>")
        return '{ file = "p.vtu" }'

    def test_appended_data_as_paraview_writes_them(self):
        for header in (4, 8):
            for blocks in (0, 100, 120, 1 << 15):  # 100 leaves a short last block, 120 fits the 30
                for encoding in ("raw", "base64"):
                    with self.subTest(header=header, blocks=blocks, encoding=encoding):
                        read = self.imported(self.vtu(header, blocks, encoding))
                        numpy.testing.assert_array_equal(read, self.points.astype("f4"))

    def test_damaged_vtu(self):
        self.vtu(8, 100, "raw")
        with open(self.path("p.vtu"), "rb") as f:
            whole = f.read()
        for length in (30, len(whole) // 2, len(whole) - 100):
            with open(self.path("p.vtu"), "wb") as f:
                f.write(whole[:length])
            self.refuse('{ file = "p.vtu" }', "p.vtu", "export")
        for old, new, expected in ((b"LittleEndian", b"BigEndian", "big-endian"),
                                   (b'"30"', b'"9999999"', "29999997 values"),
                                   (b'"raw"', b'"odd"', "odd"),
                                   (b"UnstructuredGrid\" v", b"PolyData\" v", "PolyData"),
                                   (b"Float32", b"String", "String")):
            with open(self.path("p.vtu"), "wb") as f:
                f.write(whole.replace(old, new, 1))
            self.refuse('{ file = "p.vtu" }', "p.vtu", expected)

    def gadget(self, unit=None, scale=1.0, parameters=None):
        with h5py.File(self.path("g.hdf5"), "w") as file:
            gas = file.create_group("PartType0")
            gas.create_dataset("Coordinates", data=self.points * scale, compression="gzip")
            if unit:
                # SWIFT's snapshots have lists of one number
                file.create_group("Units").attrs["Unit length in cgs (U_L)"] = numpy.array([unit])
            if parameters:
                file.create_group("Parameters").attrs["UnitLength_in_cm"] = parameters

    def test_gadget_and_swift_in_their_unit_of_length(self):
        kilometres = {"unit": 1e5, "scale": 1e-3}
        for options in ({}, {"unit": 100.0}, kilometres, {"parameters": 1e5, "scale": 1e-3}):
            with self.subTest(**options):
                self.gadget(**options)
                # two products: two roundings of numbers below 2
                numpy.testing.assert_allclose(self.imported('{ file = "g.hdf5" }'), self.points,
                                              rtol=0, atol=5e-16)

    def test_one_file_of_several_and_others_are_refused(self):
        self.gadget()
        with h5py.File(self.path("g.hdf5"), "a") as file:
            file.create_group("Header").attrs["NumFilesPerSnapshot"] = 4
        self.refuse('{ file = "g.hdf5" }', "g.hdf5", "4 files")
        with h5py.File(self.path("other.hdf5"), "w") as file:
            file["PartType1/Coordinates"] = self.points
        self.refuse('{ file = "other.hdf5" }', "other.hdf5", "/PartType0")
        self.refuse('{ file = "nowhere.hdf5" }', "nowhere.hdf5", "no such file")
        self.refuse('{ file = "set.toml" }', "bad.toml:9", ".vtu, .csv")

    def test_csv_of_others(self):
        rows = "".join(f"{x!r};{y!r};7\n" for x, y in self.points[:, :2].tolist())
        for head in ("", "# a remark\n", "X [m];Y [m];what\n", '"Points:0";"Points:1";"p"\n'):
            with self.subTest(head):
                self.write("t.csv", head + rows)
                read = self.imported('{ file = "t.csv" }')
                numpy.testing.assert_array_equal(read, self.points)

    def test_scale_and_translation(self):
        numpy.savetxt(self.path("mm.csv"), 1000 * (self.points[:, :2] + [2, -1]), fmt="%.17g",
                      delimiter=",")
        read = self.imported('{ file = "mm.csv", scale = 0.001, translate = [-2, 1] }')
        # a sum, two products and a sum, each rounded, of numbers below 4
        numpy.testing.assert_allclose(read, self.points, rtol=0, atol=4e-15)
        line = self.refuse('{ file = "mm.csv" }', "bad.toml:9", "mm.csv",
                           '100 of 100 points lie outside of the region of fluid "tank"',
                           "the furthest at (2450, -700)", "scale")
        self.assertIn("from (1550, -700) to (2450, 200)", line)


if __name__ == "__main__":
    unittest.main()
