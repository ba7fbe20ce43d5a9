#!/usr/bin/env python3
"""What is left of FUNcube-1 over the orbit, and what the stated ranges of its properties leave open.

    orbit.py --umbra build/umbra --keep runs

Each parameter of surfaces.yaml and inside.yaml goes to both ends of its range, the others as the scenario
has them: two runs each, a minute in all. Runs that stand in the folder are read, not made again. Half of
the difference over sqrt(3) is one standard deviation of a uniform range; ranges add as independent ones.

orbit.csv: by minutes since sunrise, measured - model with its spread from orbit to orbit, and where
measured - model lies within two standard deviations of the ranges: level and course together, and the
course alone, each curve less its mean over the frames. orbit.png draws it (gnuplot).

Printed: how large the ranges are, and what the 714 frames decide of them. These count as 72 of sigma
1 K, since neighbours repeat each other. What is printed before and after is a linear fit of all parameters
within their ranges as normal priors: not what the scenario has.
"""
import argparse
import calendar
import concurrent.futures
import csv
import math
import pathlib
import re
import subprocess
import time

HERE = pathlib.Path(__file__).resolve().parent
STUDIES = ("surfaces.yaml", "inside.yaml")
BIN = 180.0                  # s, of the orbit
ORBIT, WORTH = 5838.0, 72.0  # s from sunrise to sunrise; frames that do not repeat each other


def of_record(material, key):
    text = (HERE / "materials" / (material + ".yaml")).read_text(encoding="utf-8")
    return float(re.search(r"^  %s: (\S+)" % key, text, re.M).group(1))


def parameters():
    """[name, options of the run at either end]"""
    found = []
    for study in STUDIES:
        for line in (HERE / study).read_text(encoding="utf-8").splitlines():
            if not line.startswith("  - {name:"):
                continue
            of = dict(re.findall(r"(\w+): ([^,}]+)", line))
            ends = [float(of["from"]), float(of["to"])]
            if "key" in of:
                options = [["--set", "%s=%g" % (of["key"], end)] for end in ends]
            elif of["property"] == "absorptance":
                now = of_record(of["material"], "solar_absorptance")
                options = [["--with", "solar_absorptance:%s,shift=%g" % (of["material"], end - now)] for end in ends]
            else:
                now = of_record(of["material"], "emittance")
                options = [["--with", "emittance:%s,factor=%g" % (of["material"], end / now)] for end in ends]
            found.append((of["name"], options))
    return found


def residuals(umbra, folder, options):
    """(since sunrise [s], time of day [s], measured - model [K]) of every frame"""
    if not (folder / "residuals.csv").exists():
        subprocess.run([umbra, "compare", str(HERE), str(HERE / "measured.csv"), "--no-plots", "--force", "--out", str(folder),
                        *options], check=True, stdout=subprocess.DEVNULL)
    with open(folder / "residuals.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    clock = [calendar.timegm(time.strptime(row["time_utc"][:19], "%Y-%m-%dT%H:%M:%S")) for row in rows]
    since = [float(row["since_shadow_exit_s"] or "nan") for row in rows]
    first = next(t - s for t, s in zip(clock, since) if s == s and s < ORBIT)  # a sunrise
    return [((t - first) % ORBIT, t, float(row["residual"])) for t, row in zip(clock, rows)]


def mean(values):
    return sum(values) / len(values)


def rms(values):
    return math.sqrt(mean([v * v for v in values]))


def centred(values):
    level = mean(values)
    return [v - level for v in values]


def inverse(a):
    """Of a symmetric positive matrix, by Gauss and Jordan."""
    n = len(a)
    a = [row[:] + [float(i == k) for k in range(n)] for i, row in enumerate(a)]
    for i in range(n):
        a[i] = [x / a[i][i] for x in a[i]]
        for k in range(n):
            if k != i:
                a[k] = [x - a[k][i] * y for x, y in zip(a[k], a[i])]
    return [row[n:] for row in a]


def decided(names, slopes, left):
    """Prints what the frames say of each parameter, in standard deviations of its range."""
    n, weight = len(names), WORTH / len(left)
    normal = [[weight * sum(x * y for x, y in zip(slopes[i], slopes[j])) + (i == j) for j in range(n)] for i in range(n)]
    covariance = inverse(normal)
    pull = [weight * sum(x * y for x, y in zip(s, left)) for s in slopes]
    best = [sum(c * p for c, p in zip(row, pull)) for row in covariance]
    rest = [v - sum(best[j] * slopes[j][k] for j in range(n)) for k, v in enumerate(left)]
    print("all of them moved within their ranges: rms %.2f -> %.2f K" % (rms(left), rms(rest)))
    print("parameter | level, course [K] of one standard deviation | moved by, left of it [standard deviations]")
    for j in range(n):
        print("%-17s | %5.2f %5.2f | %+5.2f %5.2f" % (names[j], abs(mean(slopes[j])), rms(centred(slopes[j])), best[j],
                                                     math.sqrt(covariance[j][j])))


def draw(rows, picture):
    commands = """
set terminal pngcairo size 900,460 font ',11'
set output '%s'
set xlabel 'minutes since sunrise'
set ylabel 'measured - model [K]'
set xrange [0:98]
set yrange [-14:6]
set key bottom right
set object 1 rectangle from 67.7, graph 0 to 97.3, graph 1 fillcolor rgb '#eeeeee' fillstyle solid noborder behind
plot '-' using 1:2:3 with filledcurves fillcolor rgb '#d8e4f0' title 'stated ranges: level and course', \\
     '-' using 1:2:3 with filledcurves fillcolor rgb '#a9c4de' title 'course alone', \\
     '-' using 1:2:3 with yerrorbars pointtype 7 linecolor rgb '#b03020' title '714 frames, spread of nine orbits', 0 linecolor rgb '#606060' notitle
""" % picture
    for columns in ((0, 4, 5), (0, 6, 7), (0, 2, 3)):
        commands += "".join(" ".join("%.3f" % row[c] for c in columns) + "\n" for row in rows) + "e\n"
    subprocess.run(["gnuplot"], input=commands, text=True, check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--umbra", default="umbra")
    parser.add_argument("--keep", default="runs")
    arguments = parser.parse_args()
    keep = pathlib.Path(arguments.keep)
    keep.mkdir(parents=True, exist_ok=True)
    named = parameters()
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        nominal = pool.submit(residuals, arguments.umbra, keep / "nominal", [])
        ends = [[pool.submit(residuals, arguments.umbra, keep / (name + "-" + "lh"[k]), options[k]) for k in (0, 1)]
                for name, options in named]
        frames = nominal.result()
        ends = [[[r for _, _, r in end.result()] for end in pair] for pair in ends]
    left = [r for _, _, r in frames]
    slopes = [[(low - high) / math.sqrt(12.0) for low, high in zip(*pair)] for pair in ends]  # of the model
    middle = [sum(0.5 * (pair[0][k] + pair[1][k]) - left[k] for pair in ends) for k in range(len(left))]
    course_middle, course_slopes, level = centred(middle), [centred(s) for s in slopes], mean(left)
    print("%d frames: bias %+.2f, about it %.2f, rms %.2f K" % (len(left), level, rms(centred(left)), rms(left)))
    print("level within the ranges, measured - model: %+.1f +- %.1f K" % (
        level + mean(middle), math.sqrt(sum(mean(s) ** 2 for s in slopes))))
    decided([name for name, _ in named], slopes, left)

    rows = []
    for b in range(int(math.ceil(ORBIT / BIN))):
        at = [k for k, frame in enumerate(frames) if b * BIN <= frame[0] < (b + 1) * BIN]
        orbit = {}
        for k in at:
            orbit.setdefault(int((frames[k][1] - frames[0][1] + frames[0][0]) // ORBIT), []).append(left[k])
        each = [mean(values) for values in orbit.values()]
        spread = math.sqrt(sum((v - mean(each)) ** 2 for v in each) / (len(each) - 1))
        here = mean([left[k] for k in at])

        def band(centre, of):
            half = 2.0 * math.sqrt(sum(mean([s[k] for k in at]) ** 2 for s in of))
            return centre - half, centre + half
        # where measured - model may lie if the truth is anywhere within the ranges
        both = band(level - (level + mean(middle)) - mean([course_middle[k] for k in at]), slopes)
        course = band(level - mean([course_middle[k] for k in at]), course_slopes)
        rows.append(((b + 0.5) * BIN / 60.0, len(at), here, spread, *both, *course))
    with open(HERE / "orbit.csv", "w", encoding="utf-8") as out:
        out.write("# measured - model of the panels' mean over the orbit, and two standard deviations of the stated ranges; made by orbit.py\n")
        out.write("since_sunrise_min,frames,left_K,between_orbits_K,ranges_low_K,ranges_high_K,course_low_K,course_high_K\n")
        for row in rows:
            out.write("%.1f,%d,%+.2f,%.2f,%+.2f,%+.2f,%+.2f,%+.2f\n" % row)
    draw(rows, HERE / "orbit.png")
    outside = [row for row in rows if not row[6] <= row[2] <= row[7]]
    print("left over the orbit: course outside two standard deviations in %d of %d bins" % (len(outside), len(rows)))


if __name__ == "__main__":
    main()
