#!/usr/bin/env python3
"""The laboratory BRDFs as their authors fitted them, beside our fit.

    authors_brdf.py                       both fits against the rows of brdf.csv, and what the rows say of either
    authors_brdf.py --sky RESIDUALS       both for the 800 observations (residuals.csv of umbra compare)
    authors_brdf.py --write FOLDER        records starlink_chassis and starlink_array with tables of the authors' fit

Fankhauser, Tyson & Askari 2023 take Greynolds' binomial model (Proc. SPIE 9577, 2015) of one term in V; their numbers stand in
analysis/satellite_models/starlink_v1p5.py of their repository (MIT, LICENSE-data):

    log10 f = B0 + B1 D + 1/2 sum_k C_k log10(1 + 3^(k + l) D^2),  D = |beta - beta0|

with beta and beta0 the direction cosines along the surface of the reflected ray and of the mirrored one: the shape of the
lobe does not change with incidence (Harvey & Shack 1978). Ours, fit_brdf.py, depends on the half angle h, D = 2 cos d sin h
with d between the half vector and either direction. In the plane of incidence, where all rows are, both follow the rows;
out of it d is another at the same h, and they part.
"""
import csv
import datetime
import math
import os
import statistics
import sys

import fit_brdf
import tangent_height

SURFACES = {  # B, C, l; rho, F, alpha of materials/*.yaml
    "chassis": ((3.34, -98.085),
                (-999.999, 867.538, 1000., 1000., -731.248, 618.552, -294.054, 269.248, -144.853, 75.196), -5,
                (0.040500, 0.057311, 0.232834)),
    "array": ((0.534, -20.409), (-527.765, 1000., -676.579, 430.596, -175.806, 57.879), -3,
              (0.007723, 0.008369, 0.217058)),
}
SPIKE = 0.1            # D below which the table holds its value there: the spike is narrower than its steps
STEP, LAST = 2.5, 85.0  # of the table [deg]


def theirs(surface, d):
    """[1/sr] by D."""
    b, c, l, _ = SURFACES[surface]
    return 10 ** (b[0] + b[1] * d + 0.5 * sum(x * math.log10(1 + 3.0 ** (k + l) * d * d) for k, x in enumerate(c)))


def ours(surface, i, o, phi):
    """[1/sr] by polar angles and azimuth [rad], 0 forward."""
    rho, f, alpha = SURFACES[surface][3]
    tan2 = 1 / half(i, o, phi) ** 2 - 1
    facets = math.exp(-tan2 / alpha ** 2) * (1 + tan2) ** 2 / (math.pi * alpha ** 2)
    g = fit_brdf.masking(alpha, math.cos(i)) * fit_brdf.masking(alpha, math.cos(o))
    return rho / math.pi + f * facets * g / (4 * math.cos(i) * math.cos(o))


def offset(i, o, phi):
    """D."""
    return math.hypot(math.sin(o) * math.cos(phi) - math.sin(i), math.sin(o) * math.sin(phi))


def half(i, o, phi):
    """Cosine of the half angle."""
    up = math.cos(i) + math.cos(o)
    return up / math.hypot(up, offset(i, o, phi))


def rows_of(surface):
    """[(i, o, phi, brdf)] at half angles of 10 deg and more and to 85 deg, as fit_brdf.py takes them."""
    return [(math.radians(i), math.radians(abs(o)), 0.0 if o >= 0 else math.pi, f)
            for i, o, f in fit_brdf.read(os.path.join(os.path.dirname(os.path.abspath(__file__)), "brdf.csv"), surface)
            if f > 0 and abs(i - o) >= 2 * fit_brdf.FROM and abs(o) <= fit_brdf.GRAZING]


def rms(values):
    return math.sqrt(statistics.mean(v * v for v in values))


def at(curve, x):
    """Linear in a sorted [(x, y)]; None outside."""
    for (x0, y0), (x1, y1) in zip(curve, curve[1:]):
        if x0 <= x <= x1 and x1 > x0:
            return y0 + (x - x0) / (x1 - x0) * (y1 - y0)
    return None


def apart(rows, key, value, incidence):
    """ln of rows of one incidence over those of the others at the same key, on the same side of the mirror direction."""
    curves = {}
    for i, o, phi, f in rows:
        back = math.copysign(1, math.sin(i) - math.sin(o) * math.cos(phi))
        curves.setdefault((round(math.degrees(i), 1), back), []).append((key(i, o, phi), value(i, o, f)))
    out = {}
    for (i, back), curve in sorted(curves.items()):
        reference = sorted(curves.get((incidence, back), []))
        if i == incidence or len(reference) < 5:
            continue
        out.setdefault(i, []).extend(r - y for x, y in curve for r in [at(reference, x)] if r is not None)
    return out


def by_rows():
    for surface in SURFACES:
        rows = rows_of(surface)
        print("%s: %d rows, rms of ln f: theirs %.3f, ours %.3f" % (
            surface, len(rows), rms([math.log(f / theirs(surface, offset(i, o, p))) for i, o, p, f in rows]),
            rms([math.log(f / ours(surface, i, o, p)) for i, o, p, f in rows])))
        for i in sorted({r[0] for r in rows}):
            mine = [r for r in rows if r[0] == i]
            print("  incidence %4.1f deg, %3d rows: measured - model in the mean [mag]: theirs %+.2f, ours %+.2f" % (
                math.degrees(i), len(mine),
                -1.0857 * statistics.mean(math.log(f / theirs(surface, offset(i, o, p))) for i, o, p, f in mine),
                -1.0857 * statistics.mean(math.log(f / ours(surface, i, o, p)) for i, o, p, f in mine)))
        for what, key, value in (
                ("f at the same D", offset, lambda i, o, f: math.log(f)),
                ("f cos_i cos_o at the same h", half, lambda i, o, f: math.log(f * math.cos(i) * math.cos(o)))):
            for i, v in apart(rows, key, value, 75.0).items():
                print("  75 deg over %4.1f deg, %-27s: %3d rows, %+.2f in the mean, rms %.2f of ln" % (
                    i, what, len(v), statistics.mean(v), rms(v)))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(a):
    n = math.sqrt(dot(a, a))
    return tuple(x / n for x in a)


def places(path):
    """(surface, i, o, phi) of the observations that see the lit side of a surface."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    station = tangent_height.satellite(0, 90, 0.0)
    for row in rows:
        time = datetime.datetime.fromisoformat(row["time_utc"].replace("Z", "+00:00"))
        p = tangent_height.satellite(float(row["azimuth_deg"]), float(row["elevation_deg"]), 1e3 * float(row["range_km"]))
        sun, down = tangent_height.sun(time), unit(tuple(-x for x in p))
        observer = unit(tuple(a - b for a, b in zip(station, p)))
        along = unit(tuple(a - dot(sun, down) * b for a, b in zip(sun, down)))
        for surface, normal in (("chassis", down), ("array", along)):
            ci, co = dot(sun, normal), dot(observer, normal)
            if ci > 0 and co > 0:
                forward = (ci * co - dot(sun, observer)) / math.sqrt(max(1e-12, (1 - ci * ci) * (1 - co * co)))
                yield surface, math.acos(ci), math.acos(co), math.acos(max(-1.0, min(1.0, forward)))


def by_sky(path):
    for surface in SURFACES:
        seen = [p[1:] for p in places(path) if p[0] == surface]
        for low, high in ((0, 15), (15, 30), (30, 60), (60, 90), (90, 181)):
            of = [p for p in seen if low <= math.degrees(p[2]) < high]
            if not of:
                continue
            d = [-2.5 * math.log10(theirs(surface, offset(*p)) / ours(surface, *p)) for p in of]
            print("%-8s azimuth %3d to %3d deg: %3d observations, incidence %.0f, half angle %.0f deg: "
                  "theirs - ours %+.2f mag, scatter %.2f" % (
                      surface, low, min(high, 180), len(of), math.degrees(statistics.median(p[0] for p in of)),
                      math.degrees(statistics.median(math.acos(half(*p)) for p in of)),
                      statistics.median(d), statistics.pstdev(d)))
        d = [-2.5 * math.log10(theirs(surface, offset(*p)) / ours(surface, *p)) for p in seen]
        print("%-8s all: %d, theirs - ours %+.2f mag in the mean, rms %.2f" % (surface, len(d), statistics.mean(d), rms(d)))


RECORD = """# Made by authors_brdf.py: a table of the published fit, not a measurement.
name: starlink_%s
summary: >-
  %s
citation: >-
  Binomial model fitted by Fankhauser, Tyson & Askari 2023 (AJ 166, 59; arXiv 2305.11123) to their BRDF at 532 nm; within
  D = %g of the mirror direction held at its value there. Emissivity is assumed.
reflectance: {wavelength_um: [0.3, 2.5, 2.6, 30], diffuse: [0, 0, 0.15, 0.15], specular: [1, 1, 0, 0]}
lobe: {kind: measured, file: %s.csv}
"""


def write(folder):
    os.makedirs(folder, exist_ok=True)
    n = round(LAST / STEP) + 1
    for surface, name, summary in fit_brdf.SURFACES:
        with open(os.path.join(folder, surface + ".csv"), "w", encoding="utf-8") as file:
            file.write("incidence_deg,scattering_deg,azimuth_deg,brdf_1_sr\n")
            for a in range(n):
                for b in range(n):
                    for k in range(round(180 / STEP) + 1):
                        d = offset(*(math.radians(STEP * x) for x in (a, b, k)))
                        file.write("%g,%g,%g,%.6g\n" % (STEP * a, STEP * b, STEP * k, theirs(surface, max(d, SPIKE))))
        with open(os.path.join(folder, name + ".yaml"), "w", encoding="utf-8") as file:
            file.write(RECORD % (surface, summary, SPIKE, surface))


if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[1] == "--write":
        write(sys.argv[2])
    elif len(sys.argv) == 3 and sys.argv[1] == "--sky":
        by_sky(sys.argv[2])
    elif len(sys.argv) == 1:
        by_rows()
    else:
        sys.exit(__doc__)
