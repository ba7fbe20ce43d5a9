#!/usr/bin/env python3
"""Writes FUNcube-1's outside as satellite.obj beside this script.

A 1U CubeSat by the CubeSat Design Specification: 100 x 100 x 113.5 mm, a rail of 8.5 mm at each of the
four edges along z. What lies between the rails is a panel; the rails are the frame, in the open. The
end panels are taken flush with the ends of the rails. Units: metres. Standard library only.
"""
import pathlib

HALF, INNER, HEIGHT = 0.050, 0.050 - 0.0085, 0.1135  # edge of the body, of its panels; along z


def ring(z):
    """The outline of an end, counter-clockwise from +z: its 12 corners and where rails end."""
    corners = []
    for k in range(4):
        turn = [(1, 0, 0, 1), (0, -1, 1, 0), (-1, 0, 0, -1), (0, 1, -1, 0)][k]
        for px, py in ((HALF, -INNER), (HALF, INNER), (HALF, HALF)):
            corners.append((turn[0] * px + turn[1] * py, turn[2] * px + turn[3] * py, z))
    return corners


def main():
    bottom, top = ring(-HEIGHT / 2), ring(HEIGHT / 2)
    vertices, groups = [], {}

    def vertex(p):
        if p not in vertices:
            vertices.append(p)
        return vertices.index(p) + 1

    def face(group, corners):
        groups.setdefault(group, []).append([vertex(p) for p in corners])

    for k in range(12):
        side = ("+x", "+y", "-x", "-y")[k // 3] if k % 3 == 0 else "rails"
        n = (k + 1) % 12
        face(side, [bottom[k], bottom[n], top[n], top[k]])
    for z, name, order in ((HEIGHT / 2, "+z", 1), (-HEIGHT / 2, "-z", -1)):
        inner = [(sx * INNER, sy * INNER, z) for sx, sy in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
        edge = ring(z)
        cross = []
        for k in range(4):
            cross += [edge[3 * k], edge[3 * k + 1], inner[k]]
            face("rails", [edge[3 * k + 1], edge[3 * k + 2], edge[(3 * k + 3) % 12], inner[k]][::order])
        face(name, cross[::order])

    with open(pathlib.Path(__file__).resolve().parent / "satellite.obj", "w", encoding="utf-8") as out:
        out.write("# FUNcube-1, made by make_geometry.py. Metres.\n")
        for p in vertices:
            out.write("v %.5f %.5f %.5f\n" % p)
        for name, faces in groups.items():
            out.write("g %s\n" % name)
            for corners in faces:
                out.write("f %s\n" % " ".join(str(i) for i in corners))


if __name__ == "__main__":
    main()
