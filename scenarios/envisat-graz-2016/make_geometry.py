#!/usr/bin/env python3
"""Writes ENVISAT's outside as OBJ files into geometry/ beside this script.

Dimensions are public figures (ESA eoPortal, "Envisat": 26 m x 10 m x 5 m in orbit, bus about
10 m x 2.8 m x 2.1 m, solar array 14 m x 5 m of fourteen panels, ASAR antenna 10 m x 1.33 m);
what they leave open is assumed and marked so. Body frame: x along the bus, the array at -x; y along
the ASAR antenna; z completes it, ASAR looks to +z. Units: metres. Standard library only.
"""
import math
import pathlib

HERE = pathlib.Path(__file__).resolve().parent / "geometry"

BUS = (10.0, 2.8, 2.1)
PANELS, PANEL_LENGTH, PANEL_WIDTH, PANEL_GAP = 14, 1.0, 5.0, 0.02
BOOM_LENGTH, BOOM_WIDTH = 2.0, 0.3  # assumed: 26 m - 10 m - 14 m
ASAR = (1.33, 10.0, 0.15)           # thickness assumed
ASAR_X, ASAR_STANDOFF = 2.5, 0.25   # assumed place before the +z face
KA_RADIUS, KA_FOCUS = 0.45, 0.36    # Ka-band dish, assumed place on the -z face
RADIATOR_X = (-3.0, 0.0)            # radiators on the +-y faces, assumed


class Obj:
    """Vertices shared by position; faces counter-clockwise seen from outside (the front)."""

    def __init__(self):
        self.index, self.vertices, self.groups = {}, [], {}

    def vertex(self, p):
        key = tuple(round(c, 9) + 0.0 for c in p)
        if key not in self.index:
            self.vertices.append(key)
            self.index[key] = len(self.vertices)
        return self.index[key]

    def face(self, group, *points):
        self.groups.setdefault(group, []).append([self.vertex(p) for p in points])

    def write(self, name, remark):
        lines = [f"# {remark}", "# written by make_geometry.py; metres"]
        lines += ["v %.9g %.9g %.9g" % v for v in self.vertices]
        for group, faces in self.groups.items():
            lines.append(f"g {group}")
            lines += ["f " + " ".join(map(str, f)) for f in faces]
        (HERE / name).write_text("\n".join(lines) + "\n")


def box(obj, xs, ys, zs, group_of):
    """A closed box from the division points of its axes; group_of(normal, centre) names each cell."""
    axes = (xs, ys, zs)
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for sign in (-1, 1):
            level = axes[axis][-1 if sign > 0 else 0]
            for i in range(len(axes[u]) - 1):
                for j in range(len(axes[v]) - 1):
                    corners = [(axes[u][i], axes[v][j]), (axes[u][i + 1], axes[v][j]),
                               (axes[u][i + 1], axes[v][j + 1]), (axes[u][i], axes[v][j + 1])]
                    if sign < 0:
                        corners.reverse()
                    points = []
                    for a, b in corners:
                        p = [0.0, 0.0, 0.0]
                        p[axis], p[u], p[v] = level, a, b
                        points.append(p)
                    normal = [0, 0, 0]
                    normal[axis] = sign
                    centre = [sum(p[k] for p in points) / 4 for k in range(3)]
                    obj.face(group_of(normal, centre), *points)


def steps(low, high, n):
    return [low + (high - low) * i / n for i in range(n + 1)]


def bus():
    obj = Obj()

    def group(normal, centre):
        on_side = normal[1] != 0 and RADIATOR_X[0] < centre[0] < RADIATOR_X[1]
        return "radiator" if on_side else "mli"

    box(obj, steps(-BUS[0] / 2, BUS[0] / 2, 10), steps(-BUS[1] / 2, BUS[1] / 2, 3),
        steps(-BUS[2] / 2, BUS[2] / 2, 2), group)
    obj.write("bus.obj", "ENVISAT bus, closed box with radiators on the y faces")


def array():
    """Open sheets in the plane z = 0: the front (+z) carries the cells. x runs outward to -x."""
    obj = Obj()
    for i in range(PANELS):
        x1 = -i * PANEL_LENGTH - PANEL_GAP / 2
        x0 = -(i + 1) * PANEL_LENGTH + PANEL_GAP / 2
        ys = steps(-PANEL_WIDTH / 2, PANEL_WIDTH / 2, 5)
        for y0, y1 in zip(ys, ys[1:]):
            obj.face("panels", (x0, y0, 0), (x1, y0, 0), (x1, y1, 0), (x0, y1, 0))
    obj.write("array.obj", "ENVISAT solar array, fourteen panels, origin at its root")


def boom():
    obj = Obj()
    half = BOOM_WIDTH / 2
    box(obj, steps(-BOOM_LENGTH + 0.01, -0.01, 2), [-half, half], [-half, half], lambda n, c: "boom")
    obj.write("boom.obj", "boom between bus and array, origin at the bus")


def asar():
    obj = Obj()
    box(obj, steps(-ASAR[0] / 2, ASAR[0] / 2, 1), steps(-ASAR[1] / 2, ASAR[1] / 2, 8),
        [0.0, ASAR[2]], lambda n, c: "antenna" if n[2] > 0 else "cover")
    obj.write("asar.obj", "ASAR antenna, looks to +z, origin on its back")


def ka_antenna():
    """Paraboloid z = r^2 / (4 f), concave side (the front) to +z."""
    obj = Obj()
    rings, sectors = 3, 16

    def point(i, j):
        r, a = KA_RADIUS * i / rings, 2 * math.pi * j / sectors
        return (r * math.cos(a), r * math.sin(a), r * r / (4 * KA_FOCUS))

    for j in range(sectors):
        obj.face("dish", (0, 0, 0), point(1, j), point(1, j + 1))
        for i in range(1, rings):
            obj.face("dish", point(i, j), point(i + 1, j), point(i + 1, j + 1))
            obj.face("dish", point(i, j), point(i + 1, j + 1), point(i, j + 1))
    obj.write("ka_antenna.obj", "Ka-band antenna dish")


if __name__ == "__main__":
    HERE.mkdir(exist_ok=True)
    bus()
    array()
    boom()
    asar()
    ka_antenna()
