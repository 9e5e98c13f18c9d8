#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the parts of the gallery, simple to nasty, into FOLDER/parts (cases/gallery/parts).

    cases/gallery/make_gallery.py [--make-cad build/release/geometry/plenum-make-cad] [FOLDER]

Geometry comes from formulas. Every part is written as ASCII STL; with --make-cad, those that CAD can
say exactly become STEP files, too. All lengths in metres, but for millimetres_far.stl.
"""

import argparse
import math
import os
import subprocess

HERE = os.path.dirname(os.path.abspath(__file__))


# --- pieces of geometry: lists of triangles, corners counter-clockwise seen from outside ----------

def ear_clipped(polygon):
    """Triangles (numbers of corners) of a simple polygon that runs counter-clockwise."""
    def turn(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    left, triangles = list(range(len(polygon))), []
    while len(left) > 3:
        for k in range(len(left)):
            i, j, l = left[k - 1], left[k], left[(k + 1) % len(left)]
            a, b, c = polygon[i], polygon[j], polygon[l]
            if turn(a, b, c) <= 0:
                continue
            inside = (p for p in left if p not in (i, j, l)
                      and min(turn(a, b, polygon[p]), turn(b, c, polygon[p]),
                              turn(c, a, polygon[p])) >= 0)
            if next(inside, None) is None:
                triangles.append((i, j, l))
                del left[k]
                break
        else:
            raise ValueError("the polygon crosses itself")
    return triangles + [tuple(left)]


def band(first, second):
    """Triangles between two closed loops with as many corners; `first` below, seen from outside."""
    n, triangles = len(first), []
    for k in range(n):
        a, b, c, d = first[k], first[(k + 1) % n], second[(k + 1) % n], second[k]
        triangles += [(a, b, c), (a, c, d)]
    return triangles


def extruded(polygon, height):
    low, high = ([(x, y, z) for x, y in polygon] for z in (0.0, height))
    faces = ear_clipped(polygon)
    return ([(low[a], low[c], low[b]) for a, b, c in faces]
            + [(high[a], high[b], high[c]) for a, b, c in faces] + band(low, high))


def box(lower, upper):
    (a, b, c), (x, y, z) = lower, upper
    return [tuple((p, q, r + c) for p, q, r in t)
            for t in extruded([(a, b), (x, b), (x, y), (a, y)], z - c)]


def circle(radius, n, turn=0.0):
    return [(radius * math.cos(2 * math.pi * (k + turn) / n),
             radius * math.sin(2 * math.pi * (k + turn) / n)) for k in range(n)]


def pipe(inner, outer, height, n):
    loops = [[(x, y, z) for x, y in circle(r, n)]
             for r, z in ((inner, 0.0), (outer, 0.0), (outer, height), (inner, height))]
    return [t for k in range(4) for t in band(loops[k], loops[(k + 1) % 4])]


def ball(radius, n):
    """n rings of 2 n corners, and the poles."""
    rings = []
    for i in range(1, n):
        angle = math.pi * i / n - math.pi / 2
        rings.append([(x, y, radius * math.sin(angle))
                      for x, y in circle(radius * math.cos(angle), 2 * n)])
    south, north = (0.0, 0.0, -radius), (0.0, 0.0, radius)
    triangles = [t for k in range(n - 2) for t in band(rings[k], rings[k + 1])]
    for k in range(2 * n):
        triangles.append((south, rings[0][(k + 1) % (2 * n)], rings[0][k]))
        triangles.append((north, rings[-1][k], rings[-1][(k + 1) % (2 * n)]))
    return triangles


def twisted_torus(radius, half_side, n, per_side):
    """A square, carried round a circle while it turns once."""
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    square = [tuple(p + (q - p) * s / per_side for p, q in zip(corners[k], corners[(k + 1) % 4]))
              for k in range(4) for s in range(per_side)]
    loops = []
    for i in range(n):
        u = 2 * math.pi * i / n
        c, s = half_side * math.cos(u), half_side * math.sin(u)
        section = [(c * a - s * b, s * a + c * b) for a, b in square]
        loops.append([((radius + a) * math.cos(u), (radius + a) * math.sin(u), b)
                      for a, b in section])
    return [t for i in range(n) for t in band(loops[(i + 1) % n], loops[i])]


def gear_outline(teeth, root, tip):
    outline = []
    for k in range(teeth):
        for r, share in ((root, 0.0), (root, 0.4), (tip, 0.5), (tip, 0.9)):
            angle = 2 * math.pi * (k + share) / teeth
            outline.append((r * math.cos(angle), r * math.sin(angle)))
    return outline


def slot_outline(width):
    """Two chambers of 40 mm, joined by a slot of 10 mm of this width."""
    a, b, w = 0.02, 0.005, width / 2
    return [(-b - 2 * a, -a), (-b, -a), (-b, -w), (b, -w), (b, -a), (b + 2 * a, -a),
            (b + 2 * a, a), (b, a), (b, w), (-b, w), (-b, a), (-b - 2 * a, a)]


def inverted(triangles):
    return [(a, c, b) for a, b, c in triangles]


def moved(triangles, scale, shift):
    return [tuple(tuple(scale * x + d for x, d in zip(p, shift)) for p in t) for t in triangles]


def volume(triangles):
    """By the divergence theorem, about a corner of the part [m^3]."""
    o = triangles[0][0]

    def sixfold(t):
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = ([x - y for x, y in zip(p, o)] for p in t)
        return ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
    return math.fsum(map(sixfold, triangles)) / 6


# --- the same for gmsh's CAD kernel ----------------------------------------------------------------

def prism_script(polygon, height):
    n = len(polygon)
    lines = ['SetFactory("OpenCASCADE");']
    lines += [f"Point({k + 1}) = {{{x!r}, {y!r}, 0}};" for k, (x, y) in enumerate(polygon)]
    lines += [f"Line({k + 1}) = {{{k + 1}, {(k + 1) % n + 1}}};" for k in range(n)]
    lines += [f"Curve Loop(1) = {{1:{n}}};", "Plane Surface(1) = {1};",
              f"Extrude {{0, 0, {height}}} {{ Surface{{1}}; }}"]
    return "\n".join(lines) + "\n"


def script(*lines):
    return "\n".join(('SetFactory("OpenCASCADE");',) + lines) + "\n"


# --- the gallery -----------------------------------------------------------------------------------

PLATE = ((0.0, 0.0, 0.0), (0.1, 0.1, 0.004))
PIPE = (0.03, 0.07, 0.04)      # inner and outer radius, height
BALL = 0.05                    # radius
GEAR = (12, 0.04, 0.05, 0.04)  # teeth, radius at the root and at the tip, height
TORUS = (0.06, 0.02)           # radius of the circle, half the square's side
SLOT = (0.0015, 0.03)          # width, height
BLOCK = 0.04                   # side
FAR = (30000.0, 30000.0, 30000.0)


def parts():
    """Triangles of all parts by name."""
    sphere = ball(BALL, 48)
    block = box((0, 0, 0), (BLOCK,) * 3)
    beside = box((BLOCK, BLOCK, 0), (2 * BLOCK, 2 * BLOCK, BLOCK))  # meets `block` along an edge
    open_block = [t for t in extruded(circle(BALL, 24), BLOCK) if not is_top_patch(t)]
    return {
        "plate": box(*PLATE),
        "annulus": pipe(*PIPE, 192),
        "sphere": sphere,
        "gear": extruded(gear_outline(*GEAR[:3]), GEAR[3]),
        "twisted_torus": twisted_torus(*TORUS, 192, 8),
        "narrow_gap": extruded(slot_outline(SLOT[0]), SLOT[1]),
        "touching": block + beside,
        "touching_first": block,
        "touching_second": box((BLOCK, 0, 0), (2 * BLOCK, BLOCK, BLOCK)),
        "inverted": inverted(sphere),
        "incoherent": [(t[0], t[2], t[1]) if k % 7 == 3 else t for k, t in enumerate(sphere)],
        "hole": sphere[2:],
        "open_top": open_block,
        "millimetres_far": moved(block, 1000.0, [1000 * x for x in FAR]),
    }


def is_top_patch(triangle):
    return all(p[2] == BLOCK for p in triangle)


def scripts():
    """What gmsh's CAD kernel makes STEP files of."""
    (x, y, z), (a, b, c) = PLATE
    inner, outer, height = PIPE
    return {
        "plate": script(f"Box(1) = {{{x}, {y}, {z}, {a}, {b}, {c}}};"),
        "annulus": script(f"Cylinder(1) = {{0, 0, 0, 0, 0, {height}, {outer}}};",
                          f"Cylinder(2) = {{0, 0, 0, 0, 0, {height}, {inner}}};",
                          "BooleanDifference{ Volume{1}; Delete; }{ Volume{2}; Delete; }"),
        "sphere": script(f"Sphere(1) = {{0, 0, 0, {BALL}}};"),
        "gear": prism_script(gear_outline(*GEAR[:3]), GEAR[3]),
        "narrow_gap": prism_script(slot_outline(SLOT[0]), SLOT[1]),
    }


def write_stl(path, triangles):
    with open(path, "w") as out:
        out.write(f"solid {os.path.basename(path)}\n")
        for t in triangles:
            out.write("facet normal 0 0 0\nouter loop\n")
            out.writelines(f"vertex {x!r} {y!r} {z!r}\n" for x, y, z in t)
            out.write("endloop\nendfacet\n")
        out.write("endsolid\n")


def make(folder, make_cad=None):
    target = os.path.join(folder, "parts")
    os.makedirs(target, exist_ok=True)
    for name, triangles in parts().items():
        write_stl(os.path.join(target, name + ".stl"), triangles)
    for name, text in scripts().items() if make_cad else ():
        path = os.path.join(target, name)
        with open(path + ".geo", "w") as out:
            out.write(text)
        subprocess.run((make_cad, "--step", path + ".geo", path + ".step"), check=True)


if __name__ == "__main__":
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("folder", nargs="?", default=HERE, metavar="FOLDER")
    arguments.add_argument("--make-cad", metavar="PROGRAM", help="plenum-make-cad, for STEP files")
    given = arguments.parse_args()
    make(given.folder, given.make_cad)
