"""Residuals by the height at which the Sun's ray passes over the Earth.

  python3 scenarios/starlink-v15/tangent_height.py out/starlink/residuals.csv [OTHER/residuals.csv ...]

The height is that of the straight line from the satellite to the middle of the Sun, where it is nearest to the WGS-84
ellipsoid; negative: the line cuts the ellipsoid. Position from azimuth, elevation and range of the row, the Sun by the
Astronomical Almanac's formula of low precision (0.01 deg, 0.5 km of height). Residual: measured - model [mag], negative
where the model is too faint. The offset of each table is the median above 60 km, where there is no air. Trend: the slope of a
straight line through the rows from 5 to 40 km, by least squares, with its standard error.
"""
import csv
import datetime
import math
import statistics
import sys

LATITUDE, LONGITUDE, HEIGHT = 32.4434, -110.7881, 2790.0  # Mount Lemmon, scenario.yaml
A, F = 6378137.0, 1 / 298.257223563
E2 = F * (2 - F)
EDGES = [-60, -20, 0, 5, 10, 15, 20, 25, 30, 40, 60, 100, 1e9]


def sun(time):
    """Unit vector to the Sun, Earth-fixed."""
    n = (time - datetime.datetime(2000, 1, 1, 12, tzinfo=datetime.timezone.utc)).total_seconds() / 86400
    g = math.radians(357.528 + 0.9856003 * n)
    longitude = math.radians(280.460 + 0.9856474 * n + 1.915 * math.sin(g) + 0.020 * math.sin(2 * g))
    tilt = math.radians(23.439 - 0.0000004 * n)
    x, y, z = (math.cos(longitude), math.cos(tilt) * math.sin(longitude), math.sin(tilt) * math.sin(longitude))
    turn = math.radians(280.46061837 + 360.98564736629 * n)
    c, s = math.cos(turn), math.sin(turn)
    return (c * x + s * y, c * y - s * x, z)


def satellite(azimuth, elevation, distance):
    """Earth-fixed position [m] from the station's azimuth, elevation [deg] and range [m]."""
    b, l = math.radians(LATITUDE), math.radians(LONGITUDE)
    sb, cb, sl, cl = math.sin(b), math.cos(b), math.sin(l), math.cos(l)
    n = A / math.sqrt(1 - E2 * sb * sb)
    a, e = math.radians(azimuth), math.radians(elevation)
    east, north, up = math.cos(e) * math.sin(a), math.cos(e) * math.cos(a), math.sin(e)
    return ((n + HEIGHT) * cb * cl + distance * (-sl * east - sb * cl * north + cb * cl * up),
            (n + HEIGHT) * cb * sl + distance * (cl * east - sb * sl * north + cb * sl * up),
            (n * (1 - E2) + HEIGHT) * sb + distance * (cb * north + sb * up))


def height(p):
    """Above the ellipsoid [m] (iterated Bowring)."""
    x, z = math.hypot(p[0], p[1]), p[2]
    b = math.atan2(z, x * (1 - E2))
    for _ in range(4):
        n = A / math.sqrt(1 - E2 * math.sin(b) ** 2)
        b = math.atan2(z + E2 * n * math.sin(b), x)
    n = A / math.sqrt(1 - E2 * math.sin(b) ** 2)
    return x * math.cos(b) + z * math.sin(b) - n * (1 - E2 * math.sin(b) ** 2)


def tangent_height(position, toward):
    """Least height [m] on the ray from a position; that of the position where the Sun stands above it."""
    def at(way):
        return [p + way * t for p, t in zip(position, toward)]
    low, high = 0.0, 8e6
    for _ in range(80):
        one, two = low + (high - low) / 3, high - (high - low) / 3
        if height(at(one)) < height(at(two)):
            high = two
        else:
            low = one
    return height(at(low))


def rows(path):
    for row in csv.DictReader(open(path)):
        time = datetime.datetime.fromisoformat(row["time_utc"].replace("Z", "+00:00"))
        at = satellite(*(float(row[k]) for k in ("azimuth_deg", "elevation_deg")), float(row["range_km"]) * 1e3)
        if row["model"]:  # empty: no light at all
            yield tangent_height(at, sun(time)) / 1e3, float(row["measured"]) - float(row["model"])


def trend(points):
    """Slope of y over x and its standard error."""
    n = len(points)
    mx, my = sum(x for x, _ in points) / n, sum(y for _, y in points) / n
    sxx = sum((x - mx) ** 2 for x, _ in points)
    slope = sum((x - mx) * (y - my) for x, y in points) / sxx
    rest = sum((y - my - slope * (x - mx)) ** 2 for x, y in points)
    return slope, math.sqrt(rest / (n - 2) / sxx)


def main():
    for path in sys.argv[1:]:
        data = list(rows(path))
        zero = statistics.median(r for h, r in data if h > 60)
        print("%s: %d rows; median above 60 km %+.2f mag" % (path, len(data), zero))
        for low, high in zip(EDGES, EDGES[1:]):
            r = sorted(x - zero for h, x in data if low <= h < high)
            if not r:
                continue
            quarter = len(r) // 4
            print("%6.0f to %-6s km %5d  median %+6.2f  quartiles %+6.2f %+6.2f  mean %+6.2f +- %.2f" % (
                low, "%.0f" % high if high < 1e6 else "...", len(r), statistics.median(r), r[quarter], r[-1 - quarter],
                statistics.mean(r), statistics.stdev(r) / len(r) ** 0.5 if len(r) > 1 else math.nan))
        print("  5 to 40 km: %+.2f +- %.2f mag over 35 km" % tuple(
            35 * x for x in trend([(h, r - zero) for h, r in data if 5 <= h < 40])))


if __name__ == "__main__":
    main()
