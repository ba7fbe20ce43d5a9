#!/usr/bin/env python3
"""The telemetry of FUNcube-1 beside this file as a measurement file of Umbra.

    convert.py OUT.csv [--channels mean|panels|chassis|all] [--every N] [--sigma K]

Channels, comma-separated:
  mean     the four solar panels +X -X +Y -Y averaged: temperature of 'material:panel_side'
  panels   each of them: 'body.+x', 'body.-x', 'body.+y', 'body.-y'
  chassis  the two thermistors in the frame averaged: 'body.frame'
Default: mean; measured.csv is made so, and measured-10min.csv with --every 10.

Degrees Celsius become kelvin. --every N keeps every Nth frame: residuals of neighbouring minutes
repeat each other, those 10 min apart do not. sigma is one number for every row, README.md says why
1 K.
"""
import argparse
import csv
import pathlib
import sys

ZERO_CELSIUS = 273.15
TELEMETRY = pathlib.Path(__file__).resolve().parent / "telemetry.csv"
PANELS = {
    "body.+x": "panel_x_plus_C",
    "body.-x": "panel_x_minus_C",
    "body.+y": "panel_y_plus_C",
    "body.-y": "panel_y_minus_C",
}
CHASSIS = ["chassis_black_C", "chassis_silver_C"]


def frames():
    """Rows of the telemetry as dictionaries, in order of time."""
    with open(TELEMETRY, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def kelvin(row, names):
    return sum(float(row[name]) for name in names) / len(names) + ZERO_CELSIUS


def channels_of(row, wanted):
    """Pairs of place and temperature [K]."""
    if "mean" in wanted:
        yield "material:panel_side", kelvin(row, list(PANELS.values()))
    if "panels" in wanted:
        for place, name in PANELS.items():
            yield place, kelvin(row, [name])
    if "chassis" in wanted:
        yield "body.frame", kelvin(row, CHASSIS)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("out")
    parser.add_argument("--channels", default="mean")
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--sigma", type=float, default=1.0)
    arguments = parser.parse_args()
    wanted = set(arguments.channels.split(","))
    if "all" in wanted:
        wanted = {"mean", "panels", "chassis"}
    unknown = wanted - {"mean", "panels", "chassis"}
    if unknown:
        sys.exit(f"channel '{unknown.pop()}'; accepted: mean, panels, chassis, all")
    if not arguments.sigma > 0:
        sys.exit(f"sigma {arguments.sigma} K; accepted: above 0")

    if arguments.every < 1:
        sys.exit(f"every {arguments.every} frames; accepted: 1 and more")

    kept = frames()[:: arguments.every]
    with open(arguments.out, "w", encoding="utf-8") as out:
        out.write("# FUNcube-1 whole-orbit telemetry (AMSAT-UK), made by convert.py from telemetry.csv\n")
        out.write("time_utc,quantity,of,value,sigma\n")
        for row in kept:
            for place, value in channels_of(row, wanted):
                out.write(f"{row['time_utc']},temperature,{place},{value:.3f},{arguments.sigma:g}\n")
    print(f"{len(kept)} frames")


if __name__ == "__main__":
    main()
