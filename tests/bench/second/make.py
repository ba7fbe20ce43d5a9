#!/usr/bin/env python3
"""Worlds of the laboratory's second truth: make.py UMBRA LAB SOURCE OUT.

Each hides what a case of the laboratory hides (`lab --list`), or nothing, in one of the two passes of
scenarios/hidden-effect. The truth differs from the analyst's scenario in all else, too:

  mesh       a temperature per facet, more samples, finer bins and tolerances (KEYS)
  sizes      each by 2 % (rms)
  materials  another record of the same substance: each number by 0.01 (rms), roughness by 10 %, the
             lobe of GGX in place of Beckmann's
  attitude   jitter of 0.2 deg (rms) about each axis, correlated over 60 s
  Earth      Knocke's, by latitude and season, where the analyst has a uniform one

What is off besides need not be named, and may be (THERE). OUT gets worlds.csv, a folder per world and
materials, as bench/worlds has them. Draws depend on the name of a world alone."""

import csv
import math
import os
import random
import shutil
import subprocess
import sys

UMBRA, LAB, SOURCE, OUT = sys.argv[1:5]
CHOSEN = sys.argv[5:]  # names; none: all
PASSES = os.path.join(SOURCE, "scenarios", "hidden-effect")
NOTHING = 8  # worlds that hide nothing
KEYS = ["parts.bus.lumped=false", "parts.array.lumped=false", "thermal.facet_size_m=0.5", "thermal.samples=16",
        "thermal.relative_tolerance=1e-8", "thermal.absolute_tolerance_K=1e-6", "optics.samples=25",
        "time.exposure_samples=5", "bands.vis.bins=30", "bands.lwir.bins=60", "environment.earth=knocke"]
SIZES = {"parts.bus.box.size_m": [1.0, 0.9, 1.2], "parts.array.plate.size_m": [1.2, 1.6]}
# what is there beside what is hidden, and need not be told
THERE = ["?area:*", "?band_emissivity:*|emittance:*|solar_absorptance:*", "?diffuse_level:*|specular_level:*|roughness:*|anisotropy:*",
         "?earth_map|attitude_offset"]
ATTITUDE = ("attitude_offset", "spin_period")  # effects that are in the attitude's table


def run(*words):
    done = subprocess.run([UMBRA, *words], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"umbra {' '.join(words)}: exit status {done.returncode}: {done.stderr}")


def cases():
    """(name, pass, --with text or None): effects by turns at dusk and at dawn, then nothing."""
    listed = subprocess.run([LAB, "--list", "--part", "effects", "--seeds", "1"], capture_output=True, text=True, check=True)
    of = {"dusk": {}, "dawn": {}}
    for line in listed.stdout.splitlines():
        _, where, what = line.split()[:3]
        if where in of and not what.startswith("area"):  # sizes are off anyway
            of[where].setdefault(what.partition(",")[0].partition(":")[0], what)
    names = sorted(set(of["dusk"]) | set(of["dawn"]))
    out = []
    for i, effect in enumerate(names):
        where = ("dusk", "dawn")[i % 2]
        if effect not in of[where]:
            where = {"dusk": "dawn", "dawn": "dusk"}[where]
        out.append((f"{where}-{effect}", where, of[where][effect]))
    return out + [(f"{('dusk', 'dawn')[i % 2]}-nothing-{i + 1}", ("dusk", "dawn")[i % 2], None) for i in range(NOTHING)]


def sizes(draw):
    return [f"{key}=[{', '.join(format(v * (1 + 0.02 * draw.gauss(0, 1)), '.6g') for v in values)}]"
            for key, values in SIZES.items()]


def material(path, draw, to):
    """Another record: numbers of `grey` moved, the lobe of GGX."""
    alpha = None
    with open(path) as source, open(to, "w") as out:
        for line in source:
            key, _, rest = line.strip().partition(": ")
            shift = 0.01 * draw.gauss(0, 1)
            if key == "beckmann_alpha":
                alpha = float(rest) * (1 + 0.1 * draw.gauss(0, 1))
            elif key in ("solar_absorptance", "emittance", "vis_reflectance_diffuse", "specular_reflectance"):
                value = min(max(float(rest.split()[0]) + shift, 0.005), 0.99)
                out.write(f"  {key}: {value:.5f}\n")
            elif key == "band_emissivity":
                head, _, last = line.rpartition("value: ")
                value = min(float(last.split("}")[0]) + shift, 0.99)
                out.write(f"{head}value: {value:.5f}}}]\n")
            elif key != "balance_tolerance":
                out.write(line)
        out.write("  balance_tolerance: 0.1\n")
        if alpha is not None:
            out.write(f"lobe: {{kind: ggx, alpha: {alpha:.5f}}}\n")


def turned(q, r):
    """The attitude q (GCRS to body, scalar first), the body turned on by small angles r [rad]."""
    a, b = q, (1.0, -0.5 * r[0], -0.5 * r[1], -0.5 * r[2])
    n = math.sqrt(sum(x * x for x in b))
    b = [x / n for x in b]
    return (b[0] * a[0] - b[1] * a[1] - b[2] * a[2] - b[3] * a[3],
            b[0] * a[1] + b[1] * a[0] + b[2] * a[3] - b[3] * a[2],
            b[0] * a[2] - b[1] * a[3] + b[2] * a[0] + b[3] * a[1],
            b[0] * a[3] + b[1] * a[2] - b[2] * a[1] + b[3] * a[0])


def jitter(source, draw, to):
    """An Ornstein-Uhlenbeck process about each axis; rows are 5 s apart or closer."""
    rms, keep = math.radians(0.2), math.exp(-5.0 / 60.0)
    off = [rms * draw.gauss(0, 1) for _ in range(3)]
    with open(source) as rows, open(to, "w") as out:
        for row in csv.reader(rows):
            if not row[0][:1].isdigit():  # comments and the head
                out.write(",".join(row) + "\n")
                continue
            off = [keep * x + rms * math.sqrt(1 - keep * keep) * draw.gauss(0, 1) for x in off]
            q = turned([float(x) for x in row[1:5]], off)
            out.write(row[0] + "," + ",".join(format(x, ".15g") for x in q) + "\n")


def thin(path):
    """Of temperatures every tenth row of a place stays."""
    with open(path) as source:
        rows = list(csv.reader(source))
    at = rows[0].index("quantity")
    of, seen = rows[0].index("of"), {}
    with open(path, "w", newline="") as out:
        for row in rows:
            if row[at] == "temperature":
                seen[row[of]] = seen.get(row[of], -1) + 1
                if seen[row[of]] % 10:
                    continue
            csv.writer(out, lineterminator="\n").writerow(row)


def make(name, where, what, work):
    draw = random.Random(name)
    scenario = os.path.join(PASSES, where)
    records = os.path.join(work, "records")
    os.makedirs(records, exist_ok=True)
    for record in ("cell", "cfrp", "mli", "white"):
        material(os.path.join(PASSES, "materials", record + ".yaml"), draw, os.path.join(records, record + ".yaml"))
    in_table = what is not None and what.startswith(ATTITUDE)
    table = os.path.join(work, "table")
    run("run", scenario, "--out", os.path.join(work, "run"), "--force", "--no-plots", *(["--with", what] if in_table else []))
    run("export", os.path.join(work, "run"), "--as", "trajectory", "-o", table, "--force")
    jitter(os.path.join(table, "attitude.csv"), draw, os.path.join(table, "jitter.csv"))
    keys = KEYS + sizes(draw) + [f"attitude=[{{table: {table}/jitter.csv}}]", "material_files=[" + ", ".join(
        os.path.join(records, record + ".yaml") for record in ("cell", "cfrp", "mli", "white")) + "]"]
    words = [word for key in keys for word in ("--set", key)]
    if what is not None and not in_table:
        words += ["--with", what]
    if where == "dawn":
        words += ["--temperatures", "bus.interior,bus.-x,array.front", "--temperature-sigma", "0.5"]
    folder = os.path.join(OUT, name)
    os.makedirs(folder, exist_ok=True)
    measured = os.path.join(folder, "measurement.csv")
    run("synth", scenario, *words, "--noise", "0.01,0.001", "--seed", str(draw.randrange(2**53)), "-o", measured, "--force")
    thin(measured)
    shutil.copy(os.path.join(scenario, "scenario.yaml"), folder)


def main():
    os.makedirs(OUT, exist_ok=True)
    shutil.copytree(os.path.join(PASSES, "materials"), os.path.join(OUT, "materials"), dirs_exist_ok=True)
    work = os.path.abspath(os.path.join(OUT, "work"))
    chosen = [c for c in cases() if not CHOSEN or c[0] in CHOSEN]
    with open(os.path.join(OUT, "worlds.csv"), "w", newline="") as out:
        table = csv.writer(out, lineterminator="\n")
        table.writerow(["world", "scenario", "measurement", "without", "set", "hidden", "also", "good"])
        for i, (name, where, what) in enumerate(chosen):
            make(name, where, what, work)
            hidden = THERE if what is None else [what] + THERE
            table.writerow([name, f"{name}/scenario.yaml", "measurement.csv", "", "", " + ".join(hidden), "",
                            "open"])
            print(f"{i + 1} of {len(chosen)}: {name}", file=sys.stderr)
    shutil.rmtree(work)


main()
