"""Runs a scenario and prints its light curve: python3 lightcurve.py SCENARIO (pip install ./python)"""
import sys

import umbra

result = umbra.Scenario(sys.argv[1]).run()
light = result.intensity
print("time_unix_s", *(f"{band}_intensity [{light.units}]" for band in light.band.values), sep=",")
for time, row in zip(result.time_unix_s.values, light.values):
    print(f"{time:.3f}", *(f"{value:.9g}" for value in row), sep=",")
