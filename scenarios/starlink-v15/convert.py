#!/usr/bin/env python3
"""The 800 observations of Starlink v1.5 satellites as a measurement file of Umbra.

    convert.py OBSERVATIONS.csv OUT.csv

measured.csv beside this file was made so; for other observations of the same survey run it again.
OBSERVATIONS.csv: `observation_time,satellite_height,satellite_altitude,satellite_azimuth,
ab_magnitude` (UTC, km, deg, deg, mag), as published with Fankhauser, Tyson & Askari 2023.

Every row is an observation of its own: rows are put in order of time, as Umbra wants them.

The file has no uncertainties. What stands between such a model and the sky is not the photometry
(0.1 mag or so) but what two plates leave out: residuals of the published model scatter by 0.75 mag.
A scatter of the model belongs to the flux that is expected, not to the one that happened to be
measured: sigma is 0.75 mag of the row's own flux and, beside it, 0.75 mag of the median flux, so
that rows that came out faint do not count for more than others,

    sigma = 0.75 mag sqrt(1 + (F_median / F)^2).

Only the standard library is used.
"""
import csv
import datetime
import math
import os
import statistics
import sys

SCATTER = 0.75  # [mag]
STATION = "Mount Lemmon"
HEADER = ("time_utc", "quantity", "of", "value", "sigma", "satellite_height_km", "azimuth_deg",
          "elevation_deg", "station")


def read(path):
    with open(path, encoding="utf-8") as file:
        lines = (line for line in file if not line.startswith("#") and line.strip())
        rows = list(csv.DictReader(lines))
    for row in rows:
        row["time"] = datetime.datetime.fromisoformat(row["observation_time"])
    return sorted(rows, key=lambda row: row["time"])


def main():
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    rows = read(sys.argv[1])
    median = statistics.median(float(row["ab_magnitude"]) for row in rows)
    partial = sys.argv[2] + ".partial"
    with open(partial, "w", encoding="utf-8", newline="") as file:
        file.write("# Pomenis, Mount Lemmon; Fankhauser, Tyson & Askari 2023, arXiv 2305.11123; MIT\n")
        out = csv.writer(file, lineterminator="\n")
        out.writerow(HEADER)
        for row in rows:
            faintness = 10.0 ** (0.4 * (float(row["ab_magnitude"]) - median))
            sigma = SCATTER * math.hypot(1.0, faintness)
            out.writerow((row["time"].isoformat(timespec="milliseconds") + "Z", "magnitude_ab", "v",
                          row["ab_magnitude"], f"{sigma:.6g}", row["satellite_height"],
                          row["satellite_azimuth"], row["satellite_altitude"], STATION))
    os.replace(partial, sys.argv[2])
    print(f"{len(rows)} observations in {sys.argv[2]}")


if __name__ == "__main__":
    main()
