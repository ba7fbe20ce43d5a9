#!/usr/bin/env python3
"""How opposite panels of FUNcube-1 differ, by telemetry and by a scenario: its attitude.

    convert.py panels.csv --channels panels
    umbra compare SCENARIO panels.csv --out DIR
    differences.py DIR/residuals.csv

D = (T(+X) - T(-X)) + i (T(+Y) - T(-Y)) holds nothing of the panels' mean. While the body turns
about z it goes round at the rate of the Sun about z, with an amplitude that follows the sunlight
across z; in the dark, with that of the Earth's infrared. Per window of 6 min since sunrise,
D = c + a exp(2 pi i t / P) is fitted in each orbit: mean |a| [K], median P [s]. After sunset
D = c + b exp(-t / tau) + a exp(2 pi i t / 195 s) with one tau in all eclipses: how fast opposite
panels lose their difference.
"""
import calendar
import cmath
import csv
import statistics
import sys
import time

PANELS = ("body.+x", "body.-x", "body.+y", "body.-y")
WINDOW, EVERY = 360.0, 480.0  # s
PERIODS = [175.0 + 1.5 * i for i in range(31)]  # s
SPIN = 195.0  # s, in the dark
TAUS = range(60, 400, 5)  # s


def seconds(text):
    whole, _, fraction = text.rstrip("Z").partition(".")
    return calendar.timegm(time.strptime(whole, "%Y-%m-%dT%H:%M:%S")) + float("0." + (fraction or "0"))


def frames(path):
    """[time, since sunrise, since sunset, D measured, D of the model], s and K."""
    found = {}
    with open(path, newline="", encoding="utf-8") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            frame = found.setdefault(row["time_utc"], {})
            frame[row["of"]] = (float(row["measured"]), float(row["model"]))
            frame["since"] = (float(row["since_shadow_exit_s"]), float(row["since_shadow_entry_s"]))
    out = []
    for text, frame in found.items():
        d = [complex(frame[PANELS[0]][k] - frame[PANELS[1]][k], frame[PANELS[2]][k] - frame[PANELS[3]][k])
             for k in (0, 1)]
        out.append((seconds(text), *frame["since"], *d))
    return sorted(out, key=lambda frame: frame[0])


def least_squares(columns, values):
    """Coefficients and sum of squared residuals of a complex linear fit, by Gauss."""
    n = len(columns)
    a = [[sum(x.conjugate() * y for x, y in zip(columns[i], columns[j])) for j in range(n)]
         + [sum(x.conjugate() * v for x, v in zip(columns[i], values))] for i in range(n)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda k: abs(a[k][i]))
        a[i], a[pivot] = a[pivot], a[i]
        for k in range(n):
            if k != i:
                factor = a[k][i] / a[i][i]
                a[k] = [x - factor * y for x, y in zip(a[k], a[i])]
    c = [a[i][n] / a[i][i] for i in range(n)]
    return c, sum(abs(v - sum(c[j] * columns[j][k] for j in range(n))) ** 2 for k, v in enumerate(values))


def turning(window, which):
    """|a| and P of the frames of one window."""
    best = None
    for period in PERIODS:
        turn = [cmath.exp(2j * cmath.pi * (frame[0] - window[0][0]) / period) for frame in window]
        c, rest = least_squares([[1.0 + 0j] * len(window), turn], [frame[which] for frame in window])
        if best is None or rest < best[0]:
            best = (rest, abs(c[1]), period)
    return best[1], best[2]


def orbits(all_frames, since):
    """Frames apart by the event that they come after."""
    out = {}
    for frame in all_frames:
        if frame[since] == frame[since]:
            out.setdefault(round((frame[0] - frame[since]) / 600.0), []).append(frame)
    return out.values()


def decay(all_frames, which):
    """tau [s] with the least sum of squares over the eclipses."""
    sums = []
    for tau in TAUS:
        rest = 0.0
        for frames_of in orbits(all_frames, 2):
            part = [frame for frame in frames_of if 40.0 < frame[2] < 900.0]
            if len(part) < 8:
                continue
            columns = [[1.0 + 0j] * len(part), [cmath.exp(-frame[2] / tau) for frame in part],
                       [cmath.exp(2j * cmath.pi * frame[2] / SPIN) for frame in part]]
            rest += least_squares(columns, [frame[which] for frame in part])[1]
        sums.append((rest, tau))
    return min(sums)[1]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    all_frames = frames(sys.argv[1])
    print("since sunrise [min] | amplitude measured, model [K] | period measured, model [s]")
    start = 0.0
    while start + WINDOW < 5900.0:
        found = []
        for frames_of in orbits(all_frames, 1):
            window = [frame for frame in frames_of if start <= frame[1] < start + WINDOW]
            if len(window) >= 5:
                found.append((turning(window, 3), turning(window, 4)))
        if found:
            values = [statistics.mean(pair[k][0] for pair in found) for k in (0, 1)]
            values += [statistics.median(pair[k][1] for pair in found) for k in (0, 1)]
            print("%2.0f to %2.0f | %5.2f %5.2f | %3.0f %3.0f" % (start / 60.0, (start + WINDOW) / 60.0, *values))
        start += EVERY
    print("decay after sunset [s]: measured %d, model %d" % (decay(all_frames, 3), decay(all_frames, 4)))


if __name__ == "__main__":
    main()
