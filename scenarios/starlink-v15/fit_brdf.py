#!/usr/bin/env python3
"""Material records from the laboratory BRDFs of a Starlink v1.5.

    fit_brdf.py            from brdf.csv beside this file
    fit_brdf.py --table    only prints how the fit depends on where it begins

Rows are `surface,incidence_deg,scattering_deg,brdf_1_sr`: zenith angles phi_i and phi_o [deg], BRDF
[1/sr] at 532 nm, all in the plane of incidence; phi_o > 0 is forward. Fitted is what
Umbra's grey records hold, a Lambert term and a Beckmann lobe with Smith masking,

    f = rho/pi + F D(h) G1(i) G1(o) / (4 cos_i cos_o)
    D = exp(-tan^2 h / alpha^2) / (pi alpha^2 cos^4 h)
    G1 = 1/(1 + Lambda),  Lambda = (erf(a) - 1)/2 + exp(-a^2)/(2 a sqrt(pi)),  a = 1/(alpha tan)

(Walter et al. 2007, eqs 20, 25), by least squares of ln f in ln rho, ln F and alpha. Left out are
rows nearer to the mirror direction than FROM [deg] of the half angle h = |phi_i - phi_o|/2, where
both surfaces have a spike of a fraction of a degree that one lobe cannot follow as well, and rows
nearer to grazing than 85 deg. Only the standard library is used; materials/*.yaml are rewritten.
"""
import csv
import math
import os
import sys

FROM = 10.0        # [deg]; 98 % of the 800 observations are further out (README)
GRAZING = 85.0     # [deg]
SURFACES = (
    ("chassis", "starlink_chassis", "Nadir face of the Starlink v1.5 chassis."),
    ("array", "starlink_array", "Cell side of the Starlink v1.5 solar array."),
)


def read(path, surface):
    """[(phi_i, phi_o, brdf)], angles in degrees."""
    with open(path, newline="", encoding="utf-8") as file:
        return [(float(row["incidence_deg"]), float(row["scattering_deg"]), float(row["brdf_1_sr"]))
                for row in csv.DictReader(line for line in file if not line.startswith("#"))
                if row["surface"] == surface]


def masking(alpha, cos_theta):
    if cos_theta >= 1.0:
        return 1.0
    a = cos_theta / (alpha * math.sqrt(1.0 - cos_theta * cos_theta))
    return 1.0 / (1.0 - 0.5 * math.erfc(a) + math.exp(-a * a) / (2.0 * a * math.sqrt(math.pi)))


def lobe(alpha, phi_i, phi_o):
    """The lobe of F = 1 in the plane of incidence [1/sr]."""
    cos_i, cos_o = math.cos(math.radians(phi_i)), math.cos(math.radians(phi_o))
    tan2 = math.tan(math.radians(0.5 * (phi_i - phi_o))) ** 2
    facets = math.exp(-tan2 / alpha**2) * (1.0 + tan2) ** 2 / (math.pi * alpha**2)
    return facets * masking(alpha, cos_i) * masking(alpha, cos_o) / (4.0 * cos_i * cos_o)


def squares_at(x, rows, lobes):
    """Sum of squares of ln f, and the normal equations of its Gauss-Newton step."""
    a = [[0.0, 0.0], [0.0, 0.0]]
    b = [0.0, 0.0]
    squares = 0.0
    for (_, _, brdf), unit in zip(rows, lobes):
        part = (math.exp(x[0]) / math.pi, math.exp(x[1]) * unit)
        model = part[0] + part[1]
        r = math.log(brdf / model)
        slope = (part[0] / model, part[1] / model)
        squares += r * r
        for k in range(2):
            b[k] += slope[k] * r
            for j in range(2):
                a[k][j] += slope[k] * slope[j]
    return squares, a, b


def fit_levels(alpha, rows):
    """ln rho, ln F and sum of squares of the best fit at one alpha, by Levenberg and Marquardt."""
    lobes = [lobe(alpha, i, o) for i, o, _ in rows]
    x, damping = (math.log(0.03), math.log(0.05)), 1e-3
    squares, a, b = squares_at(x, rows, lobes)
    for _ in range(500):
        m00, m11 = a[0][0] + damping, a[1][1] + damping
        det = m00 * m11 - a[0][1] * a[1][0]
        step = ((b[0] * m11 - b[1] * a[0][1]) / det, (m00 * b[1] - a[1][0] * b[0]) / det)
        shorter = min(1.0, 1.0 / max(abs(step[0]), abs(step[1]), 1e-300))  # a factor e at most
        tried = (x[0] + shorter * step[0], x[1] + shorter * step[1])
        after = squares_at(tried, rows, lobes)
        if after[0] <= squares:
            done = squares - after[0] <= 1e-12 * squares
            x, damping = tried, 0.1 * damping
            squares, a, b = after
            if done:
                return x[0], x[1], squares
        else:
            damping *= 10.0
            if damping > 1e12:  # no step helps any more
                return x[0], x[1], squares
    raise SystemExit("the fit did not converge")


def fit(rows):
    """rho, F, alpha and rms of ln f: golden section in alpha between 0.05 and 1."""
    def cost(t):
        return fit_levels(math.exp(t), rows)[2]

    grid = [math.log(0.05) + k * math.log(20.0) / 40 for k in range(41)]
    best = min(range(41), key=lambda k: cost(grid[k]))
    low, high = grid[max(0, best - 1)], grid[min(40, best + 1)]
    golden = 0.5 * (math.sqrt(5.0) - 1.0)
    while high - low > 1e-6:
        c, d = high - golden * (high - low), low + golden * (high - low)
        if cost(c) < cost(d):
            high = d
        else:
            low = c
    alpha = math.exp(0.5 * (low + high))
    rho, specular, squares = fit_levels(alpha, rows)
    return math.exp(rho), math.exp(specular), alpha, math.sqrt(squares / len(rows))


def chosen(rows, begin):
    return [r for r in rows if 0.5 * abs(r[0] - r[1]) >= begin and abs(r[1]) <= GRAZING]


RECORD = """\
# Made by fit_brdf.py from the laboratory BRDF; do not edit, fit again.
name: {name}
summary: >-
  {summary}
citation: >-
  Fit to the BRDF measured at 532 nm, Fankhauser, Tyson & Askari 2023 (AJ 166, 59; arXiv 2305.11123):
  {count} rows at half angles of {begin:g} deg and more, rms of ln f {rms:.3f}. The narrow mirror spike nearer to
  the specular direction is not in the lobe. Solar absorptance is what the two terms leave, emittance
  is assumed; neither acts on light in the VIS.
grey:
  solar_absorptance: {absorptance:.4f}
  emittance: 0.85
  vis_reflectance_diffuse: {rho:.6f}
  specular_reflectance: {specular:.6f}
  beckmann_alpha: {alpha:.6f}
"""


def main():
    table = sys.argv[1:] == ["--table"]
    if len(sys.argv) > 1 and not table:
        raise SystemExit(__doc__)
    here = os.path.dirname(os.path.abspath(__file__))
    print("surface           from   rows   rho_d      F          alpha    rms ln f")
    for surface, name, summary in SURFACES:
        rows = read(os.path.join(here, "brdf.csv"), surface)
        for begin in (3.0, 5.0, 8.0, 10.0, 15.0) if table else (FROM,):
            used = chosen(rows, begin)
            rho, specular, alpha, rms = fit(used)
            print(f"{name:17} {begin:4.0f}  {len(used):5d}   {rho:.6f}   {specular:.6f}   {alpha:.4f}"
                  f"   {rms:.3f}")
        if table:
            continue
        path = os.path.join(here, "materials", name + ".yaml")
        with open(path, "w", encoding="utf-8") as out:
            out.write(RECORD.format(name=name, summary=summary, count=len(used), begin=FROM, rms=rms,
                                    absorptance=1.0 - rho - specular, rho=rho, specular=specular,
                                    alpha=alpha))


if __name__ == "__main__":
    main()
