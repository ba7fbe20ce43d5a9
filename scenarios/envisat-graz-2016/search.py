#!/usr/bin/env python3
"""Searches spin sense, phase, array angle and nutation of ENVISAT for what the published study says of its light curve:

  A  the array carries most of the LWIR: its share over the pass is above one half
  B  the last part of the pass is lower because the array is not seen: over the last LAST seconds the mean LWIR is below that
     of the time before, and what the array adds has fallen by more than everything else together, though it has grown warmer

Every attitude is a run of the program, steps of 10 s, the inside as one node, looser tolerances: 6 s on one core. Writes a line
per attitude; those that stand in the file already are not run again. Standard library only.

  python3 scenarios/envisat-graz-2016/search.py -o search.csv                      288 attitudes, half an hour
  python3 scenarios/envisat-graz-2016/search.py -o search.csv --senses 1 --phase 165 180 195 210 --array 20 25 30 35 40
  python3 scenarios/envisat-graz-2016/search.py -o search.csv --senses 1 --phase 180 --array 30 --nutation 20:0 20:90
"""
import argparse
import concurrent.futures
import csv
import math
import os
import pathlib
import shutil
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
LAST = (100, 150, 200)  # seconds at the end that may be meant by "the last part"
ARRAY = ("cell_silicon", "cfrp")
CHEAP = ["thermal.facets=''", "time.step_s=10", "thermal.step_s=10", "thermal.accuracy_K=0.2",
         "thermal.exchange_patches=64", "thermal.view_factor_rays=512", "parts.bus.interior.conductivity_W_m_K=0",
         "bands.vis.bins=4", "bands.lwir.bins=8", "optics.samples=4"]
C1, C2 = 1.191042972e-16, 1.438776877e-2  # 2 h c^2 [W m^2/sr], h c/k [m K]


def black_body(temperature):
    """Radiance of a black body in 8-12 um [W/m^2/sr], midpoint rule."""
    step, total = 0.05e-6, 0.0
    for i in range(80):
        wavelength = 8e-6 + (i + 0.5) * step
        total += step * C1 / wavelength**5 / math.expm1(C2 / (wavelength * temperature))
    return total


def light_curve(folder):
    """LWIR of the array and of the rest [W/sr], and the array's apparent area [m^2]: what it emits over B of its mean."""
    part, emitted = {}, {}
    with open(folder / "materials.csv", newline="") as f:
        for row in csv.DictReader(f):
            if row["band"] != "lwir":
                continue
            time, array = row["time_utc"], row["material"] in ARRAY
            total = sum(float(row[k]) for k in ("sun", "earth", "emitted", "interreflected", "other"))
            part.setdefault(time, [0.0, 0.0])[0 if array else 1] += total
            if array:
                emitted[time] = emitted.get(time, 0.0) + float(row["emitted"])
    with open(folder / "temperatures.csv", newline="") as f:
        mean = {row["time_utc"]: float(row["solar_array.mean_K"]) for row in csv.DictReader(f)}
    return [(a, rest, emitted[time] / black_body(mean[time])) for time, (a, rest) in sorted(part.items())]


def judge(curve, last):
    """Means of array, rest and apparent area before the last seconds and in them."""
    n = round(last / 10)
    return [[sum(column) / len(column) for column in zip(*piece)] for piece in (curve[:-n], curve[-n:])]


def summary(curve):
    array, rest = sum(c[0] for c in curve), sum(c[1] for c in curve)
    out = {"share": array / (array + rest), "mean_W_sr": (array + rest) / len(curve)}
    for last in LAST:
        before, end = judge(curve, last)
        fall = before[0] - end[0]
        out[f"ratio_{last}"] = (end[0] + end[1]) / (before[0] + before[1])
        out[f"area_before_{last}_m2"], out[f"area_last_{last}_m2"] = before[2], end[2]
        hidden = end[2] < before[2] and fall > abs(before[1] - end[1])
        out[f"lower_{last}"] = int(out[f"ratio_{last}"] < 1.0 and hidden)
    return out


def run(umbra, attitude, extra=()):
    sense, phase, angle, nutation, nutation_phase, ratio = attitude
    folder = pathlib.Path(tempfile.mkdtemp(prefix="umbra-search-"))
    spin = "attitude.0.spin."
    sets = CHEAP + [f"{spin}period_s={213.0 * sense:g}", f"{spin}phase_deg={phase:g}",
                    f"parts.solar_array.joint.angle_deg={angle:g}"]
    if nutation > 0.0:
        sets += [f"{spin}nutation_deg={nutation:g}", f"{spin}nutation_phase_deg={nutation_phase:g}",
                 f"{spin}inertia_ratio={ratio:g}"]
    command = [umbra, "run", str(HERE), "--no-plots", "--force", "--threads", "1", "--out", str(folder)]
    for s in sets + list(extra):
        command += ["--set", s]
    try:
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            raise SystemExit(done.stderr.strip())
        return light_curve(folder)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def attitudes(options):
    """sense, phase [deg], array angle [deg], nutation [deg], its phase [deg], inertia ratio"""
    tips = [tuple(float(v) for v in text.split(":")) for text in options.nutation] or [(0.0, 0.0)]
    for tip in tips:
        for sense in options.senses:
            for phase in options.phase or [360.0 * i / options.phases for i in range(options.phases)]:
                for angle in options.array or [360.0 * i / options.angles for i in range(options.angles)]:
                    yield (sense, phase, angle, *tip, options.inertia_ratio)


KEYS = ("sense", "phase_deg", "array_deg", "nutation_deg", "nutation_phase_deg", "inertia_ratio")


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("-o", dest="out", default="search.csv")
    p.add_argument("--umbra", default=shutil.which("umbra") or "build/umbra")
    p.add_argument("--phases", type=int, default=12, help="of the spin at 20:33:00, evenly over a turn")
    p.add_argument("--angles", type=int, default=12, help="of the array, evenly over a turn")
    p.add_argument("--phase", type=float, nargs="*", metavar="DEG", help="these in place of --phases even ones")
    p.add_argument("--array", type=float, nargs="*", metavar="DEG", help="these in place of --angles even ones")
    p.add_argument("--senses", type=int, nargs="*", default=[1, -1])
    p.add_argument("--nutation", nargs="*", default=[], metavar="DEG:PHASE", help="angles and phases of nutation in place of none")
    p.add_argument("--inertia-ratio", type=float, default=1.04)
    p.add_argument("--jobs", type=int, default=os.cpu_count())
    options = p.parse_args()
    known = set()
    if os.path.exists(options.out):
        with open(options.out, newline="") as f:
            known = {tuple(float(row[k]) for k in KEYS) for row in csv.DictReader(f)}
    todo = [a for a in attitudes(options) if tuple(map(float, a)) not in known]
    with open(options.out, "a", newline="") as f, concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        writer = None
        for attitude, curve in zip(todo, pool.map(lambda a: run(options.umbra, a), todo)):
            row = dict(zip(KEYS, attitude), **{k: round(v, 4) for k, v in summary(curve).items()})
            if writer is None:
                writer = csv.DictWriter(f, row)
                if not known:
                    writer.writeheader()
            writer.writerow(row)
            f.flush()
            print(f"{attitude}: share {row['share']:.2f}, last {LAST[1]} s over before {row[f'ratio_{LAST[1]}']:.2f}", flush=True)


if __name__ == "__main__":
    main()
