#!/usr/bin/env python3
"""Whole-orbit telemetry of FUNcube-1 to a measurement file of Umbra.

    convert.py TELEMETRY.csv OUT.csv [--channels mean|panels|chassis|all] [--every N] [--sigma K]

Channels, comma-separated:
  mean     the four solar panels +X -X +Y -Y averaged: temperature of 'material:panel_side'
  panels   each of them: 'body.+x', 'body.-x', 'body.+y', 'body.-y'
  chassis  the two thermistors in the frame averaged: 'body.interior'
Default: mean.

Tags are whole minutes, seconds cut off (two minutes hold two frames): a row stands for the middle
of its minute. Left out: held frames (a row like its predecessor in everything but the time: the
last frame repeated while no new one is stored) and second rows of one minute. Degrees Celsius
become kelvin. --every N keeps every Nth frame: residuals of neighbouring minutes repeat each other,
those 10 min apart do not. sigma is one number for every row, README.md says why 1 K.
"""
import argparse
import csv
import sys

ZERO_CELSIUS = 273.15
PANELS = {
    "body.+x": "Solar Panel +X deg. C",
    "body.-x": "Solar Panel -X deg. C",
    "body.+y": "Solar Panel +Y deg. C",
    "body.-y": "Solar Panel -Y deg. C",
}
CHASSIS = ["Black Chassis deg. C", "Silver Chassis deg. C"]
TIME = "Satellite Date/Time UTC"


def frames(path):
    """New frames of the telemetry as dictionaries, in order of time; and how many were left out."""
    with open(path, newline="", encoding="utf-8-sig") as file:
        rows = list(csv.DictReader(file))
    missing = [name for name in [TIME, *PANELS.values(), *CHASSIS] if not rows or name not in rows[0]]
    if missing:
        sys.exit(f"{path}: no column '{missing[0]}'; accepted: whole-orbit telemetry of FUNcube-1")
    kept, held, repeated = [], 0, 0
    previous = None
    for row in rows:
        values = {name: text for name, text in row.items() if name != TIME}
        if values == previous:
            held += 1
            continue
        previous = values
        if kept and row[TIME] <= kept[-1][TIME]:
            repeated += 1
            continue
        kept.append(row)
    return kept, held, repeated


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
        yield "body.interior", kelvin(row, CHASSIS)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("telemetry")
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

    kept, held, repeated = frames(arguments.telemetry)
    kept = kept[:: arguments.every]
    with open(arguments.out, "w", encoding="utf-8") as out:
        out.write("# FUNcube-1 whole-orbit telemetry (AMSAT-UK), made by convert.py\n")
        out.write("time_utc,quantity,of,value,sigma\n")
        for row in kept:
            time = row[TIME][:16].replace(" ", "T") + ":30.000Z"
            for place, value in channels_of(row, wanted):
                out.write(f"{time},temperature,{place},{value:.3f},{arguments.sigma:g}\n")
    print(f"{len(kept)} frames; left out: {held} held, {repeated} second ones of a minute")


if __name__ == "__main__":
    main()
