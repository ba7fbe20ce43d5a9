#!/usr/bin/env python3
"""Runs what the tables of this page and of envisat-paper's stand for, and prints them as Markdown.

  python3 scenarios/envisat-graz-2016/tables.py --keep runs            all of them: an hour on two cores
  python3 scenarios/envisat-graz-2016/tables.py --keep runs inside     the table of the bus's inside

Tables: shows, choices, contributions, inside, creases, air, paper, attitude, mesh. Runs that stand in the folder already are read, not made
again: empty it after a change of the program. Standard library only.
"""
import argparse
import concurrent.futures
import csv
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # no __pycache__ beside the scenario
import search  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
PAPER = HERE.parent / "envisat-paper"
MECHANISMS = ("sun", "earth", "emitted", "interreflected", "other")
ARRAY = "parts.solar_array.joint.angle_deg="
INSIDE = "parts.bus.interior.conductivity_W_m_K="
NOTHING = re.compile(r"[-+]0\.0+( %)?(, [-+]0\.0+( %)?)?")  # a change that no digit shows
SLOW = ["time.step_s=10"]  # tables of many rows: 10 s between observations

OTHER_WAY = ["attitude.0.spin.axis_lvlh=[0.0120425, -0.8817156, -0.4716276]", "attitude.0.spin.axis_body=[0, 0, -1]"]
CHOICES = {
    "nothing": [],
    "array angle 0": [ARRAY + "0"],
    "array angle 30": [ARRAY + "30"],
    "array angle 65": [ARRAY + "65"],
    "array angle 90": [ARRAY + "90"],
    "array turned over (145)": [ARRAY + "145"],
    "spin the other way": OTHER_WAY,
    "phase 90": ["attitude.0.spin.phase_deg=90"],
    "phase 180": ["attitude.0.spin.phase_deg=180"],
    "array 5.7 kg/m2 (400 kg)": ["parts.solar_array.shell.areal_heat_capacity_J_m2_K=5130"],
    "e* 0.005": ["parts.bus.mli.effective_emittance=0.005"],
    "e* 0.05": ["parts.bus.mli.effective_emittance=0.05"],
}
CONTRIBUTIONS = ("shadow_refraction", "earth_map", "earth_spectrum", "earth_anisotropy", "earthlight_lobe", "multiple_scattering", "emittance_temperature",
                 "absorptance_angle", "mutual_radiation", "solar_multiple_reflection", "specular_exchange", "bulk_temperature",
                 "inter_reflection", "panel_flatness")
CREASES = {"flat": None, "3 deg, 0.1 m": "{tilt_rms_deg: 3, patch_m: 0.1}", "10 deg, too small to tell apart": "{tilt_rms_deg: 10}",
           "10 deg, 0.1 m": "{tilt_rms_deg: 10, patch_m: 0.1}"}
AIRS = {"us_standard": "{profile: us_standard}", "mid_latitude_summer": "{profile: mid_latitude_summer}"}


def mean(values):
    values = list(values)
    return sum(values) / len(values) if values else float("nan")


def largest(values):
    return max(values, key=abs)


class Run:
    """Columns of a finished run as lists of numbers; time_utc as texts."""

    def __init__(self, folder):
        self.folder = folder
        self.light = self.columns("lightcurve.csv")
        self.heat = self.columns("temperatures.csv")
        self.time = self.light["time_utc"]
        self.sunlit = self.light["sunlit_fraction"]

    def columns(self, name):
        with open(self.folder / name, newline="") as f:
            rows = list(csv.reader(f))
        head, rows = rows[0], rows[1:]
        return {key: [row[i] if key == "time_utc" else float(row[i] or "nan") for row in rows] for i, key in enumerate(head)}

    def band(self, name):
        return self.light[f"{name}_intensity_W_sr"]

    def where(self, values, sun):
        """Those in sunlight, or in the umbra: above or below a thousandth of it."""
        return [v for v, lit in zip(values, self.sunlit) if (lit >= 1e-3) == sun]

    def materials(self, band, sun=None):
        """What each material sends over the pass, or its part in sunlight or in the umbra, as a share [1]."""
        lit, sums = dict(zip(self.time, self.sunlit)), {}
        with open(self.folder / "materials.csv", newline="") as f:
            for row in csv.DictReader(f):
                if row["band"] == band and (sun is None or (lit[row["time_utc"]] >= 1e-3) == sun):
                    sums[row["material"]] = sums.get(row["material"], 0.0) + sum(float(row[k] or 0) for k in MECHANISMS)
        return {name: value / sum(sums.values()) for name, value in sums.items()}


class Runs:
    """Runs of the program by name, made once, two at a time."""

    def __init__(self, umbra, keep, jobs):
        self.umbra, self.keep, self.pool, self.made = umbra, keep, concurrent.futures.ThreadPoolExecutor(jobs), {}

    def ask(self, name, scenario=HERE, sets=(), without=()):
        if name not in self.made:
            self.made[name] = self.pool.submit(self.make, name, scenario, sets, without)
        return self.made[name]

    def make(self, name, scenario, sets, without):
        folder = self.keep / name.replace(" ", "_").replace("/", "_").replace("*", "")
        if not (folder / "lightcurve.csv").exists():
            command = [self.umbra, "run", str(scenario), "--no-plots", "--force", "--threads", "1", "--out", str(folder) + ".part"]
            for s in sets:
                command += ["--set", s]
            for effect in without:
                command += ["--without", effect]
            done = subprocess.run(command, capture_output=True, text=True)
            if done.returncode != 0:
                raise SystemExit(f"{name}: {done.stderr.strip()}")
            os.rename(str(folder) + ".part", folder)
        return Run(folder)


def table(head, rows):
    print("| " + " | ".join(head) + " |\n|" + "---|" * len(head))
    for row in rows:
        print("| " + " | ".join("0" if NOTHING.fullmatch(cell) else cell for cell in row) + " |")
    print()


def percent(shares):
    return ", ".join(f"{name} {100 * value:.1f} %" for name, value in sorted(shares.items(), key=lambda item: -item[1]))


def range_of(run, place):
    return f"{min(run.heat[place + '.min_K']):.1f} to {max(run.heat[place + '.max_K']):.1f} K"


def shows(runs):
    run = runs.ask("as it is").result()
    vis, lwir = run.band("vis"), run.band("lwir")
    for limit in (0.0, 1e-3, 0.01, 0.5, 0.99):
        print(f"sunlit above {limit:g}: {next(t for t, s in zip(run.time, run.sunlit) if s > limit)}")
    print(f"seconds without sunlight: {sum(s == 0.0 for s in run.sunlit)}")
    sunlit = sorted(run.where(vis, True))
    middle = sunlit[len(sunlit) // 2]
    print(f"VIS in sunlight: median {middle:.1f}, mean {mean(sunlit):.1f} W/sr; {percent(run.materials('vis'))}")
    for i in range(1, len(vis) - 1):
        if vis[i - 1] < vis[i] >= vis[i + 1] and vis[i] > 3 * middle:
            print(f"  peak {run.time[i]}: {vis[i]:.1f} W/sr, {100 * run.sunlit[i]:.0f} % sunlit")
    print(f"LWIR {min(lwir):.1f} to {max(lwir):.1f}, mean {mean(lwir):.1f}; in the umbra {min(run.where(lwir, False)):.1f} to "
          f"{max(run.where(lwir, False)):.1f} W/sr")
    for name, sun in (("pass", None), ("umbra", False), ("sunlight", True)):
        print(f"LWIR by material, {name}: {percent(run.materials('lwir', sun))}")
    for kind in ("earth", "interreflected"):
        for band in ("vis", "lwir"):
            part, whole = run.light[f"{band}_{kind}_W_sr"], run.band(band)
            part, whole = run.where(part, True) + run.where(part, False), run.where(whole, True) + run.where(whole, False)
            at = max(range(len(part)), key=lambda i: part[i] / whole[i] if whole[i] > 1e-3 * max(whole) else 0.0)
            print(f"{kind} in {band}: {100 * sum(part) / sum(whole):.2f} % over the pass, {100 * part[at] / whole[at]:.1f} % at most")
    before, last = lwir[:-150], lwir[-150:]
    sun = [v for v, lit in zip(before, run.sunlit) if lit >= 1e-3]
    print(f"LWIR, last 150 s {mean(last):.1f}, over all before {mean(last) / mean(before):.3f}, sunlit before {mean(sun):.1f} W/sr")
    lit = [i for i, s in enumerate(run.sunlit) if s >= 0.5]
    curves = (lwir, run.light["lwir_emitted_W_sr"], run.light["lwir_irradiance_W_m2"], [r ** -2 for r in run.light["range_km"]])
    rows = [[f"{end} s"] + [f"{mean(v[-end:]) / mean(v[i] for i in lit if i < len(v) - end):.2f}" for v in curves]
            for end in (30, 100, 150, 200)]
    table(["last", "radiant intensity", "its emitted part alone", "irradiance", "1/range² alone"], rows)
    for place in ("solar_array", "bus.mli", "bus.interior", "ka_antenna", "asar"):
        print(f"{place}: {range_of(run, place)}, mean {mean(run.heat[place + '.mean_K']):.1f} K")
    print()


def choices(runs):
    asked = {name: runs.ask(name, sets=SLOW + sets) for name, sets in CHOICES.items()}
    rows = []
    for name, future in asked.items():
        run = future.result()
        lwir, share = run.band("lwir"), run.materials("lwir")
        rows.append([name, f"{mean(lwir):.0f}", f"{mean(run.where(lwir, False)):.0f}", f"{mean(run.where(lwir, True)):.0f}",
                     f"{100 * share['cell_silicon']:.0f} %, back {100 * share['cfrp']:.0f} %",
                     f"{min(run.heat['solar_array.front.min_K']):.0f}-{max(run.heat['solar_array.front.max_K']):.0f}"])
    table(["changed", "pass", "in the umbra", "in sunlight", "share of the cells", "array [K]"], rows)


def contributions(runs):
    asked = {effect: runs.ask("no " + effect, without=[effect]) for effect in CONTRIBUTIONS}
    rows = []
    for effect, future in asked.items():
        run, base = future.result(), runs.ask("as it is").result()
        lwir = [100 * (a / b - 1) for a, b in zip(base.band("lwir"), run.band("lwir"))]
        vis = [a - b for a, b in zip(base.band("vis"), run.band("vis"))]

        def change(place, which="mean"):
            return [a - b for a, b in zip(base.heat[f"{place}.{which}_K"], run.heat[f"{place}.{which}_K"])]
        row = [f"`{effect}`", f"{100 * sum(vis) / sum(run.band('vis')):+.2f} %, {largest(vis):+.1f}",
               f"{mean(lwir):+.2f}, {largest(lwir):+.2f}"]
        row.append("{:+.2f}, {:+.2f}".format(mean(change("bus.mli")), largest(change("bus.mli"))))
        row.append("{:+.1f}, {:+.1f}".format(largest(change("bus.mli", "min")), largest(change("bus.mli", "max"))))
        for place in ("solar_array.front", "boom", "asar.cover", "ka_antenna"):
            row.append("{:+.2f}, {:+.2f}".format(mean(change(place)), largest(change(place))))
        row += [f"{mean(change(place)):+.2f}" for place in ("bus.radiator", "bus.interior")]
        rows.append(row)
    table(["with", "VIS, sum, largest [W/sr]", "LWIR", "MLI of the bus", "coldest, hottest facet", "array, front", "boom",
           "ASAR cover", "Ka dish", "radiators", "interior"], rows)


def inside(runs):
    asked = {k: runs.ask("inside " + k, sets=SLOW + [INSIDE + k]) for k in ("0", "1", "3", "10")}
    node, rows = asked["0"].result().band("lwir"), []
    for k, future in asked.items():
        run = future.result()
        change = [100 * abs(a / b - 1) for a, b in zip(run.band("lwir"), node)]
        heat = run.heat
        rows.append([k + " W/m/K", f"{mean(heat['bus.interior.mean_K']):.2f} ({range_of(run, 'bus.interior')})",
                     f"{mean(heat['bus.radiator.mean_K']):.2f}", f"{mean(heat['bus.mli.mean_K']):.2f}",
                     f"{mean(heat['ka_antenna.mean_K']):.1f}", f"{mean(run.band('lwir')):.1f}",
                     f"{max(change):.2f} %, {mean(change):.2f} % in the mean"])
    table(["inside", "interior [K]", "radiators [K]", "MLI [K]", "Ka dish [K]", "LWIR, pass [W/sr]", "largest change of LWIR"], rows)


def creases(runs):
    asked = {}
    for name, value in CREASES.items():
        sets = ["time.step_s=2"]
        if value is not None:
            sets += ["parts.bus.creases=" + value, "parts.asar.groups.cover.creases=" + value]
        asked[name] = runs.ask("creases " + name, sets=sets)
    flat, rows = asked["flat"].result(), []
    for name, future in asked.items():
        run = future.result()
        vis = [a - b for a, b in zip(run.band("vis"), flat.band("vis"))]
        lwir = [100 * (a / b - 1) for a, b in zip(run.band("lwir"), flat.band("lwir"))]
        early = [i for i, t in enumerate(run.time) if t[11:19] < "20:43:30"]
        ratio = sum(run.band("vis")[i] for i in early) / sum(flat.band("vis")[i] for i in early)
        cover = mean(run.heat["asar.cover.mean_K"]) - mean(flat.heat["asar.cover.mean_K"])
        dish = mean(run.heat["ka_antenna.mean_K"]) - mean(flat.heat["ka_antenna.mean_K"])
        rows.append([name, f"{mean(run.where(run.band('vis'), True)):.0f} W/sr",
                     f"{100 * run.materials('vis', True)['mli_kapton']:.0f} %", f"{largest(vis):+.0f} W/sr",
                     f"{mean(lwir):+.1f} %, {largest(lwir):+.1f} %", f"{cover:+.1f}, {dish:+.1f}", f"{ratio:.2f}"])
    table(["tilt, rms, and patch", "VIS, sunlit", "MLI's share of it", "largest in VIS", "LWIR, mean and largest",
           "ASAR cover, Ka dish [K]", "VIS before 20:43:30 over flat"], rows)
    small, large = (asked[n].result() for n in ("10 deg, too small to tell apart", "10 deg, 0.1 m"))
    ratio = [a / b for a, b, s in zip(large.band("vis"), small.band("vis"), large.sunlit) if s > 0.5]
    print(f"patches told apart over the wider lobe: {min(ratio):.2f} to {max(ratio):.2f}, "
          f"rms {100 * mean((r - 1) ** 2 for r in ratio) ** 0.5:.0f} %\n")


def air(runs):
    asked = {name: runs.ask("air " + name, sets=SLOW + ["observer.air=" + value]) for name, value in AIRS.items()}
    clear, rows = runs.ask("nothing", sets=SLOW).result(), []
    top = max(range(len(clear.time)), key=lambda i: clear.light["elevation_deg"][i])
    for name, future in asked.items():
        row = [name]
        for band in ("vis", "lwir"):
            a, b = (r.light[f"{band}_irradiance_W_m2"] for r in (future.result(), clear))
            row += [f"{100 * (1 - a[top] / b[top]):.0f} %", f"{100 * (1 - sum(a) / sum(b)):.0f} %"]
        rows.append(row)
    table(["air", "VIS falls at the culmination", "over the pass", "LWIR at the culmination", "over the pass"], rows)


def paper(runs):
    rows, asked = [], {}
    for name, sets in (("3 W/m/K, four orbits", []), ("one node, four orbits", [INSIDE + "0"]),
                       ("3 W/m/K, periodic", ["thermal.start=periodic"]),
                       ("one node, periodic", ["thermal.start=periodic", INSIDE + "0"])):
        asked[name] = runs.ask("paper " + name, scenario=PAPER, sets=sets)
    for name, future in asked.items():
        run = future.result()
        lwir = run.band("lwir")
        umbra = [v for v, t in zip(lwir, run.time) if t[11:] < "20:36:51.9"]
        sun = [v for v, t in zip(lwir, run.time) if t[11:] > "20:37:05.5"]
        rows.append([name, f"{mean(run.heat['bus.interior.mean_K']):.1f} ({range_of(run, 'bus.interior')})",
                     f"{mean(run.heat['bus.radiator.mean_K']):.1f}", f"{mean(lwir):.1f}", f"{mean(umbra):.1f}", f"{mean(sun):.1f}"])
    table(["inside", "interior, mean (coldest to hottest) [K]", "radiators [K]", "LWIR, pass [W/sr]", "in the umbra",
           "in full sunlight"], rows)
    solid, node = (asked[n].result().band("lwir") for n in ("3 W/m/K, four orbits", "one node, four orbits"))
    change = [100 * (a / b - 1) for a, b in zip(solid, node)]
    print(f"the solid against one node, four orbits: LWIR {mean(change):+.1f} % in the mean, {largest(change):+.1f} % at most\n")


def attitude(runs):
    cheap = [s for s in search.CHEAP if not s.startswith(INSIDE)]
    rows = []
    for scenario, name in ((HERE, "graz"), (PAPER, "paper")):
        asked = {a: runs.ask(f"attitude {name} {a}", scenario=scenario, sets=cheap + [ARRAY + a]) for a in ("65", "-35")}
        for angle, future in asked.items():
            run = future.result()
            share, summary = run.materials("lwir"), search.summary(search.light_curve(run.folder))
            rows.append([name, angle + " deg", f"{100 * (share['cell_silicon'] + share['cfrp']):.0f} / "
                         f"{100 * share['mli_kapton']:.0f} / {100 * share['aluminium_anodised']:.0f} %",
                         f"{summary['ratio_150']:.2f}", f"{summary['area_before_150_m2']:.1f}, {summary['area_last_150_m2']:.1f}"])
    table(["scenario", "array", "cells and backs / MLI / metal", "LWIR, last 150 s over the time before",
           "apparent area of the array before, then [m2]"], rows)


def mesh(runs):
    """Facets of one size, and those of facets.csv, which are cut where temperatures ask for it; against the finest."""
    sets = {f"{size} m": ["thermal.facets=''", f"thermal.facet_size_m={size}"] for size in ("2.4", "1.2", "0.6", "0.3")}
    sets["facets.csv"] = []
    asked = {name: runs.ask("mesh " + name, sets=SLOW + extra) for name, extra in sets.items()}
    finest, rows, points = asked["0.3 m"].result(), [], []
    for name, future in asked.items():
        run = future.result()
        log = (run.folder / "log.txt").read_text()
        said = re.search(r"about (\S+) K at most \((\S+)\).*lwir by about (\S+) % at most, (\S+) % in the mean", log)
        surfaces = re.search(r"view factors: (\d+) surfaces", log)[1]
        change = [100 * (a / b - 1) for a, b in zip(finest.band("lwir"), run.band("lwir"))]
        moved = {p[:-7]: largest([a - b for a, b in zip(finest.heat[p], run.heat[p])]) for p in run.heat
                 if p.endswith(".mean_K") and p.count(".") == 2}
        place = max(moved, key=lambda p: abs(moved[p]))
        found = ["", ""] if run is finest else [f"{moved[place]:+.2f} ({place})", f"{mean(change):+.2f}, {largest(change):+.2f}"]
        rows.append([name, surfaces, f"{said[1]} ({said[2]})", found[0], f"{said[4]}, {said[3]}", found[1]])
        points.append((name, surfaces, abs(float(said[1])), abs(float(said[3]))))
    table(["facets", "that see others", "temperature of a group, said [K]", "to 0.3 m, found [K]", "LWIR, said, mean and most [%]",
           "to 0.3 m, found [%]"], rows)
    script = runs.keep / "mesh.gp"
    data = ["\n".join(f"{p[1]} {p[2]} {p[3]}" for p in points[:-1]), " ".join(str(v) for v in points[-1][1:])]
    script.write_text(f"""$one << E\n{data[0]}\nE\n$cut << E\n{data[1]}\nE
set terminal pngcairo size 900,420 font 'sans,10'; set output 'mesh.png'; set multiplot layout 1,2
set logscale xy; set xrange [600:20000]; set xlabel 'surfaces'; set grid; set key top right
set ylabel 'mean temperature of a group off by, at most [K]'; set yrange [0.05:20]
plot $one u 1:2 w lp pt 7 t 'facets of one size, 2.4 to 0.3 m', $cut u 1:2 w p pt 9 ps 2 t 'cut where asked for', 0.5 lt 0 t '0.5 K'
set ylabel 'LWIR off by, at most [%]'
plot $one u 1:3 w lp pt 7 t 'facets of one size', $cut u 1:3 w p pt 9 ps 2 t 'cut where asked for', 0.5 lt 0 t '0.5 %'
""")
    subprocess.run(["gnuplot", script.name], cwd=runs.keep, check=True)
    print(f"picture: {runs.keep / 'mesh.png'}\n")


TABLES = {f.__name__: f for f in (shows, choices, contributions, inside, creases, air, paper, attitude, mesh)}


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("tables", nargs="*", metavar="TABLE", help=", ".join(TABLES))
    p.add_argument("--umbra", default=shutil.which("umbra") or "build/umbra")
    p.add_argument("--keep", type=pathlib.Path, help="folder of the runs; without it they are thrown away")
    p.add_argument("--jobs", type=int, default=os.cpu_count())
    options = p.parse_args()
    unknown = [name for name in options.tables if name not in TABLES]
    if unknown:
        p.error(f"table '{unknown[0]}'; accepted: {', '.join(TABLES)}")
    keep = options.keep or pathlib.Path(tempfile.mkdtemp(prefix="umbra-tables-"))
    keep.mkdir(parents=True, exist_ok=True)
    try:
        runs = Runs(options.umbra, keep, options.jobs)
        for name in options.tables or TABLES:
            print(f"## {name}\n")
            TABLES[name](runs)
    finally:
        if options.keep is None:
            shutil.rmtree(keep, ignore_errors=True)


if __name__ == "__main__":
    main()
