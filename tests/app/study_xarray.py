"""study.nc opens in xarray, and is selected from by the names of bands, places and parameters.

    study_xarray.py UMBRA BOX.YAML
"""
import csv
import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np
import xarray as xr

STUDY = """schema: 1
name: read
scenario: box.yaml
parameters:
  - {material: grey_white, property: emittance, from: 0.7, to: 0.9}
  - {key: parts.bus.shell.areal_heat_capacity_J_m2_K, from: 2000, to: 4000, unit: J/m2/K}
design: {kind: grid, levels: 2}
outputs: {bands: [vis, lwir], places: [bus], magnitudes: true}
"""
HEAT = "parts.bus.shell.areal_heat_capacity_J_m2_K"


def look(folder):
    with open(os.path.join(folder, "points.csv")) as file:
        rows = list(csv.DictReader(file))
    with xr.open_dataset(os.path.join(folder, "study.nc")) as ds:
        assert ds.sizes["point"] == 4 and ds.sizes["time"] == 5, ds.sizes
        assert list(ds.band.values) == ["vis", "lwir"] and list(ds.place.values) == ["bus"]
        assert np.issubdtype(ds.time.dtype, np.datetime64)
        assert str(ds.time.values[0]).startswith("2016-09-06T18:07:00")
        assert ds.irradiance.dims == ("point", "time", "band") and ds.irradiance.units == "W m-2"
        heat = ds.parameter_value.sel(parameter=HEAT).values
        assert heat.tolist() == [float(row[HEAT]) for row in rows]
        lwir = ds.irradiance.sel(band="lwir")
        for point, row in enumerate(rows):
            mean = float(lwir.isel(point=point).mean("time"))
            assert abs(mean / float(row["irradiance:lwir:mean"]) - 1) < 1e-8
        # walls that hold more heat cool less in the shadow; white paint that emits more, more
        bus = ds.temperature.sel(place="bus").isel(time=-1).values
        cold, warm = bus[heat == heat.min()].mean(), bus[heat == heat.max()].mean()
        assert warm > cold + 5, bus
        assert np.isfinite(ds.magnitude.sel(band="vis").values[:, -1]).all()


def main():
    umbra, box = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(box, os.path.join(folder, "box.yaml"))
        with open(os.path.join(folder, "study.yaml"), "w") as file:
            file.write(STUDY)
        subprocess.run([umbra, "study", "study.yaml", "--out", "out"], cwd=folder, check=True)
        look(os.path.join(folder, "out"))
    print("study.nc: read by xarray")


main()
