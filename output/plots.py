"""Light curves and temperatures of this folder, drawn by matplotlib from its tables: change it as you like.

    python3 plots.py [png|svg|pdf] [FOLDER]
"""
import csv
import datetime
import os
import sys

import matplotlib
import matplotlib.dates

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def read(path):
    """Columns of a table: times as dates, numbers, NaN where nothing stands."""
    with open(path, encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    columns = {key: [float(row[key] or "nan") for row in rows] for key in rows[0] if key != "time_utc"}
    columns["time"] = [datetime.datetime.strptime(row["time_utc"], "%Y-%m-%dT%H:%M:%S.%fZ") for row in rows]
    return columns


def finish(figure, axes, time, name, kind):
    for axis in axes:
        axis.legend(fontsize="small", loc="upper left", bbox_to_anchor=(1.01, 1))
    axes[-1].set_xlabel(f"UTC, from {time[0]:%Y-%m-%d}")
    axes[-1].xaxis.set_major_formatter(matplotlib.dates.DateFormatter("%H:%M:%S"))
    figure.autofmt_xdate()
    figure.savefig(f"{name}.{kind}", bbox_inches="tight")
    plt.close(figure)


def light(kind):
    """Radiant intensity of every band with its Monte-Carlo standard error, and what makes it."""
    table = read("lightcurve.csv")
    bands = [key[: -len("_intensity_W_sr")] for key in table if key.endswith("_intensity_W_sr")]
    figure, axes = plt.subplots(len(bands), 1, sharex=True, squeeze=False, figsize=(9, 3.2 * len(bands)))
    for band, axis in zip(bands, axes[:, 0]):
        total, error = table[f"{band}_intensity_W_sr"], table[f"{band}_stderr_W_sr"]
        axis.plot(table["time"], total, color="k", label="total")
        axis.fill_between(table["time"], [t - e for t, e in zip(total, error)], [t + e for t, e in zip(total, error)],
                          color="k", alpha=0.2, label="Monte-Carlo error (1 sigma)")
        for mechanism in ("sun", "earth", "emitted", "interreflected", "other"):
            part = table[f"{band}_{mechanism}_W_sr"]
            if max(part) > 0.01 * max(total):
                axis.plot(table["time"], part, label=mechanism)
        axis.set_ylabel(f"radiant intensity, {band} [W/sr]")
    finish(figure, axes[:, 0], table["time"], "lightcurve-matplotlib", kind)


def heat(kind):
    """Mean temperatures of places, shaded from lowest to highest."""
    table = read("temperatures.csv")
    figure, axis = plt.subplots(figsize=(9, 5))
    axis.set_prop_cycle(matplotlib.cycler(linestyle=["-", "--", ":", "-."]) * matplotlib.rcParams["axes.prop_cycle"])
    for key in table:
        name = key[: -len(".mean_K")]
        if not key.endswith(".mean_K") or name.startswith("material:"):
            continue
        (line,) = axis.plot(table["time"], table[key], label=name)
        axis.fill_between(table["time"], table[f"{name}.min_K"], table[f"{name}.max_K"], alpha=0.15,
                          color=line.get_color())
    axis.set_ylabel("temperature [K]")
    finish(figure, [axis], table["time"], "temperatures-matplotlib", kind)


def main():
    kind = sys.argv[1] if len(sys.argv) > 1 else "png"
    os.chdir(sys.argv[2] if len(sys.argv) > 2 else os.path.dirname(os.path.abspath(__file__)))
    if os.path.exists("lightcurve.csv"):
        light(kind)
    heat(kind)


if __name__ == "__main__":
    main()
