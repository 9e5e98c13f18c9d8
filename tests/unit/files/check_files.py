# SPDX-License-Identifier: GPL-3.0-or-later
"""check_files.py WRITE_SAMPLES FOLDER

Reads what the program WRITE_SAMPLES writes as strangers do: h5py looks for GADGET's and VTKHDF's
names, shapes, types and ranges; meshio reads every field of the .vtu back and finds the bits that
h5py finds in the particle file of the same particles.
"""

import pathlib
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import h5py
import meshio
import numpy as np

# name in the .vtu -> dataset of /PartType0
FIELDS = {
    "velocity": "Velocities", "mass": "Masses", "density": "Density", "pressure": "Pressure",
    "smoothing_length": "SmoothingLength", "internal_energy": "InternalEnergy",
    "id": "ParticleIDs", "material": "MaterialIDs", "wall": "WallIDs", "normal": "Normals",
    "wall_distance": "WallDistances", "reference_position": "ReferencePositions",
    "reference_normal": "ReferenceNormals", "acceleration": "Accelerations",
    "internal_energy_rate": "InternalEnergyRates", "velocity_divergence": "VelocityDivergences",
    "type": "ParticleTypes",
}
UNITS = {"Coordinates": "m", "Velocities": "m/s", "Masses": "kg", "Density": "kg/m^d",
         "SmoothingLength": "m", "InternalEnergy": "J/kg", "ParticleIDs": ""}


def same_bits(a, b):
    return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()


def check_gadget(file, name):
    header, gas = file["Header"].attrs, file["PartType0"]
    n = gas["Coordinates"].shape[0]
    assert header["Dimension"] == int(name[-2])
    for key in ("NumPart_Total", "NumPart_Total_HighWord", "NumPart_ThisFile", "MassTable"):
        assert header[key].shape == (6,), key
    assert list(header["NumPart_Total"]) == [n, 0, 0, 0, 0, 0]
    assert list(header["NumPart_ThisFile"]) == [n, 0, 0, 0, 0, 0]
    assert not header["NumPart_Total_HighWord"].any() and not header["MassTable"].any()
    assert header["Flag_Entropy_ICs"] == 0 and header["NumFilesPerSnapshot"] == 1
    assert header["Redshift"] == 0 and header["Time"] == 0.1 + 0.2
    box = header["BoxSize"]
    assert box.shape == (3,) and box.dtype == "f8" and (box > 0).all()
    assert gas["Coordinates"].dtype == "f8" and gas["Coordinates"].shape == (n, 3)
    assert (gas["Coordinates"][:] >= 0).all() and (gas["Coordinates"][:] < box).all()
    for unit in ("length", "mass", "time", "current", "temperature"):
        assert any(key.startswith(f"Unit {unit} in cgs (U_") for key in file["Units"].attrs), unit
    assert file["Units"].attrs["Unit length in cgs (U_L)"] == 100
    assert file["Units"].attrs["Unit mass in cgs (U_M)"] == 1000
    for key, unit in UNITS.items():
        assert gas[key].attrs["Unit"].decode() == unit, key
        assert gas[key].shape == ((n, 3) if key in ("Coordinates", "Velocities") else (n,)), key
        assert gas[key].dtype == ("u8" if key == "ParticleIDs" else "f8"), key
        assert gas[key].chunks is None, key
    assert len(np.unique(gas["ParticleIDs"][:])) == n
    walls = gas["ParticleTypes"][:] == 1
    ids = gas["ParticleIDs"][:]
    assert ids.min() == 1 and ids.max() == n
    assert not walls.any() or ids[walls].max() == walls.sum()  # walls are numbered first
    if "MaterialIDs" in gas:
        assert (gas["MaterialIDs"][:][walls] == -1).all() and (gas["WallIDs"][:][~walls] == -1).all()
        assert (gas["MaterialIDs"][:][~walls] >= 0).all() and (gas["WallIDs"][:][walls] >= 0).all()
        assert not gas["Normals"][:][~walls].any() and not gas["WallDistances"][:][~walls].any()
    assert gas["SmoothingLength"].attrs["KernelName"] == b"convex"
    assert gas["SmoothingLength"].attrs["SupportOverH"] == 2


def check_vtkhdf(file, name):
    vtk, gas = file["VTKHDF"], file["PartType0"]
    n = gas["Coordinates"].shape[0]
    assert list(vtk.attrs["Version"]) == [1, 0] and vtk.attrs["Version"].dtype == "i8"
    assert vtk.attrs["Type"] == b"UnstructuredGrid"
    assert vtk.attrs.get_id("Type").get_type().get_cset() == h5py.h5t.CSET_ASCII
    for key in ("NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"):
        assert vtk[key].shape == (1,) and vtk[key].dtype == "i8" and vtk[key][0] == n
    assert (vtk["Connectivity"][:] == np.arange(n)).all()
    assert (vtk["Offsets"][:] == np.arange(n + 1)).all()
    assert vtk["Types"].dtype == "u1" and (vtk["Types"][:] == 1).all()
    for key, dataset in vtk["PointData"].items():
        assert dataset == gas[key], f"{key} is not the same object in /PartType0"
    assert set(vtk["PointData"]) == set(gas) - {"Coordinates"}
    shifted = name.startswith(("shifted", "periodic", "blocks"))
    assert (vtk["Points"] == gas["Coordinates"]) != shifted, "a copy only where it is needed"
    if name.startswith("shifted"):
        shift = file["Plenum"].attrs["Shift"]
        # one rounding of a sum of numbers below 2e4: half a unit in the last place is 1.8e-12
        assert np.abs(vtk["Points"][:] + shift - gas["Coordinates"][:]).max() <= 2e-12


def check_plenum(file):
    plenum = file["Plenum"]
    assert plenum.attrs["SchemaVersion"] == 1
    assert plenum.attrs["CaseName"] == b"cases/sample.toml"
    assert len(plenum["CaseText"].asstr()[()]) > 100000
    assert list(plenum["Walls/Name"].asstr()) == ["shaft", "housing"]
    assert list(plenum["Walls/Layers"]) == [3, 4]
    assert plenum["Walls/Thickness"][1] == 4 / 3
    assert list(plenum["Materials/Name"].asstr()) == ["water", "air"]
    assert plenum["Container/Counts"].compression == "gzip"


def check_vtu(path, file):
    mesh = meshio.read(path)
    n = file["PartType0/Coordinates"].shape[0]
    assert [block.type for block in mesh.cells] == ["vertex"]
    assert (mesh.cells[0].data.ravel() == np.arange(n)).all()
    assert same_bits(mesh.points, file["VTKHDF/Points"][:])
    real = {name.decode() for name in file["Plenum"].attrs["Fields"]} - {"position"} | {"type"}
    assert set(mesh.point_data) == real, set(mesh.point_data) ^ real
    for name, values in mesh.point_data.items():
        assert same_bits(values, file["PartType0"][FIELDS[name]][:]), name
    assert float(np.ravel(mesh.field_data["TimeValue"])[0]) == 0.1 + 0.2


def check_pvd(path):
    sets = ElementTree.parse(path).getroot().findall("Collection/DataSet")
    assert [float(s.get("timestep")) for s in sets] == [0.5 * k for k in range(len(sets))]
    for entry in sets:
        assert "/" not in entry.get("file") and (path.parent / entry.get("file")).is_file()
    return len(sets)


def main():
    folder = pathlib.Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    subprocess.run([sys.argv[1], str(folder)], check=True)
    names = sorted(path.stem for path in folder.glob("*.hdf"))
    assert len(names) == 11
    assert check_pvd(folder / "samples.pvd") == len(names)
    assert not list(folder.glob("*.tmp"))
    for name in names:
        with h5py.File(folder / f"{name}.hdf") as file:
            check_gadget(file, name)
            check_vtkhdf(file, name)
            check_plenum(file)
            check_vtu(folder / f"{name}.vtu", file)
        print(name, "ok")


main()
