# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of cases/gallery, and how far beyond their surfaces places lie, by formulas."""

import importlib.util
import math
import os
import sys

import numpy

from harness import CASES

GALLERY = os.path.join(CASES, "gallery")
spec = importlib.util.spec_from_file_location("make_gallery",
                                              os.path.join(GALLERY, "make_gallery.py"))
gallery = importlib.util.module_from_spec(spec)
sys.dont_write_bytecode = True
spec.loader.exec_module(gallery)

# Beyond the surface of a formula; negative inside. One array of coordinates in, one out.


def beyond_box(x, lower, upper):
    return numpy.max(numpy.maximum(numpy.array(lower) - x, x - numpy.array(upper)), axis=1)


def beyond_pipe(x, inner, outer, height):
    r = numpy.hypot(x[:, 0], x[:, 1])
    return numpy.max((inner - r, r - outer, -x[:, 2], x[:, 2] - height), axis=0)


def beyond_ball(x):
    return numpy.linalg.norm(x, axis=1) - gallery.BALL


def beyond_polygon(x, outline):
    """Signed distance to a polygon in the plane."""
    distance = numpy.full(len(x), numpy.inf)
    inside = numpy.zeros(len(x), dtype=bool)
    for (ax, ay), (bx, by) in zip(outline, outline[1:] + outline[:1]):
        ux, uy = x[:, 0] - ax, x[:, 1] - ay
        vx, vy = bx - ax, by - ay
        t = numpy.clip((ux * vx + uy * vy) / (vx * vx + vy * vy), 0, 1)
        distance = numpy.minimum(distance, numpy.hypot(ux - t * vx, uy - t * vy))
        if ay != by:
            inside ^= ((x[:, 1] < ay) != (x[:, 1] < by)) & (ux < uy * vx / vy)
    return numpy.where(inside, -distance, distance)


def beyond_gear(x, teeth, root, tip, height):
    plane = beyond_polygon(x, gallery.gear_outline(teeth, root, tip))
    return numpy.max((plane, -x[:, 2], x[:, 2] - height), axis=0)


def beyond_torus(x, radius, half):
    u = numpy.arctan2(x[:, 1], x[:, 0])
    p, q = numpy.hypot(x[:, 0], x[:, 1]) - radius, x[:, 2]
    a = numpy.cos(u) * p + numpy.sin(u) * q
    b = -numpy.sin(u) * p + numpy.cos(u) * q
    return numpy.max((abs(a) - half, abs(b) - half), axis=0)


def beyond_slot(x, width, height):
    left = beyond_box(x, (-0.045, -0.02, 0), (-0.005, 0.02, height))
    right = beyond_box(x, (0.005, -0.02, 0), (0.045, 0.02, height))
    slot = beyond_box(x, (-0.005, -width / 2, 0), (0.005, width / 2, height))
    return numpy.min((left, right, slot), axis=0)
