"""Files for other programs, opened by other programs: xarray, meshio, VTK, imageio, astropy, numpy, matplotlib.

    formats.py UMBRA BOX.YAML
"""
import csv
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

import erfa
import imageio
import meshio
import numpy as np
import xarray as xr
from astropy.io import fits
from astropy.time import Time
from astropy.wcs import WCS
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

EYE = """
sensors:
  eye: {band: vis, aperture_m: 0.5, throughput: 0.1, gain_e: 2, exposure_s: 0.5, pixel_arcsec: 0.7,
        fwhm_arcsec: 2, dark_e_s: 8, read_noise_e: 3, sky_mag_arcsec2: 19}
"""
WHEN = "2016-09-06T18:11:00Z"
ARCSEC = math.pi / 180 / 3600


def rows_of(path):
    with open(path) as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def look_at_run(folder):
    """run.nc has the numbers of the tables."""
    temperature = rows_of(folder / "run/temperatures.csv")
    light = rows_of(folder / "run/lightcurve.csv")
    with xr.open_dataset(folder / "run/run.nc") as ds:
        bus = ds.part_temperature.sel(part="bus").values
        assert np.allclose(bus, [float(row["bus.mean_K"]) for row in temperature], rtol=1e-8)
        lwir = ds.irradiance.sel(band="lwir").values
        seen = [row["lwir_irradiance_W_m2"] for row in light]
        assert any(seen) and np.allclose(lwir, [float(x) if x else np.nan for x in seen], rtol=1e-8, equal_nan=True)


def look_at_grids(folder):
    """Areas and mean temperatures of the satellite, instant by instant, from grids alone."""
    temperature = rows_of(folder / "run/temperatures.csv")
    names = {(row["array"], row["name"]): int(row["number"]) for row in rows_of(folder / "vtu/names.csv")}
    collection = (folder / "vtu/satellite.pvd").read_text()
    for k, row in enumerate(temperature):
        assert f'timestep="{60.0 * k:.3f}" file="satellite-{k:04d}.vtu"' in collection
        grid = meshio.read(folder / f"vtu/satellite-{k:04d}.vtu")
        corner = grid.points[grid.cells_dict["triangle"]]
        area = 0.5 * np.linalg.norm(np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]), axis=1)
        data = {key: value[0] for key, value in grid.cell_data.items()}
        assert math.isclose(area.sum(), 6.0, rel_tol=1e-12)
        assert (data["part"] == names["part", "bus"]).all() and (data["back_material"] == -1).all()
        assert (data["front_material"] == names["material", "grey_white"]).all()
        assert np.isnan(data["back_temperature_K"]).all()
        mean = (area * data["front_temperature_K"]).sum() / area.sum()
        assert math.isclose(mean, float(row["bus.mean_K"]), rel_tol=1e-8), (mean, row["bus.mean_K"])
        side = data["group"] == names["group", "bus.+x"]
        assert math.isclose(area[side].sum(), 1.0, rel_tol=1e-12)
    mesh = meshio.read(folder / "box.obj")
    assert len(mesh.points) == 8 and sum(len(cells.data) for cells in mesh.cells) in (6, 12)


def look_at_solids(folder):
    """Tetrahedra fill the box, warm where run.nc says so."""
    grid = meshio.read(folder / "solid/solids-0001.vtu")
    p = grid.points[grid.cells_dict["tetra"]]
    volume = np.abs(np.einsum("ij,ij->i", p[:, 1] - p[:, 0], np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 0]))) / 6
    assert math.isclose(volume.sum(), 1.0, rel_tol=1e-9)
    assert 'file="solids-0001.vtu"' in (folder / "solid/solids.pvd").read_text()
    with xr.open_dataset(folder / "solid-run/run.nc") as ds:
        expected = ds.solid_vertex_temperature.isel(time=1).values
    assert np.allclose(grid.point_data["temperature_K"], expected, rtol=1e-12)


def look_at_grids_by_vtk(folder):
    """VTK's own reader, as ParaView has it, finds what meshio finds."""
    for name in ("vtu/satellite-0002", "solid/solids-0001"):
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(folder / f"{name}.vtu"))
        reader.Update()
        grid, other = reader.GetOutput(), meshio.read(folder / f"{name}.vtu")
        assert grid.GetNumberOfCells() == sum(len(cells.data) for cells in other.cells) > 0
        assert (vtk_to_numpy(grid.GetPoints().GetData()) == other.points).all()
        for data, expected in ((grid.GetCellData(), {k: v[0] for k, v in other.cell_data.items()}),
                               (grid.GetPointData(), other.point_data)):
            assert data.GetNumberOfArrays() == len(expected)
            for key, values in expected.items():
                assert np.array_equal(vtk_to_numpy(data.GetArray(key)), values, equal_nan=values.dtype.kind == "f")


def look_at_material_temperatures(umbra, folder):
    """Profiles for STK, and the message of CNES read again: both to their last digit."""
    expected = [float(row["material:grey_white.mean_K"]) for row in rows_of(folder / "run/temperatures.csv")]
    profile = np.loadtxt(folder / "t/grey_white.tsf")
    assert (profile[:, 0] == 60.0 * np.arange(len(expected))).all() and np.allclose(profile[:, 1], expected, atol=6e-5, rtol=0)
    subprocess.run([umbra, "import", "t/temperatures.cic", "--time", "time_utc", "--temperature", "MATERIAL_TEMPERATURES (K)",
                    "--of", "material:grey_white", "-o", "t.csv"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    again, first = rows_of(folder / "t.csv"), rows_of(folder / "run/temperatures.csv")
    assert [row["time_utc"] for row in again] == [row["time_utc"] for row in first]
    assert np.allclose([float(row["value"]) for row in again], expected, atol=6e-5, rtol=0)
    message = (folder / "t/temperatures.cic").read_text()
    assert all(f"\n{key} = " in message for key in ("CREATION_DATE", "OBJECT_ID", "USER_DEFINED_SIZE"))


def look_at_sky(folder):
    """Electrons of sky in an exposure are those of sky.csv: photons of h c / lambda, throughput 0.1, 4 bins of 0.1 um.
    The circle has as many pixels at every instant, so only ratios are known from outside."""
    light = {}
    for row in rows_of(folder / "sky/sky.csv"):
        if row["band"] == "vis":
            light.setdefault(row["time_utc"], []).append((float(row["wavelength_um"]), float(row["radiance_W_m2_sr_um"])))
    pixel = 0.25 * math.pi * 0.5**2 * (0.7 * ARCSEC) ** 2 * 0.1 * 0.5  # area, solid angle, throughput, exposure
    hc = 6.62607015e-34 * 299792458.0
    ratio = []
    for row in rows_of(folder / "twilight/counts.csv"):
        if row["eye_background_e"]:
            electrons = pixel * sum(0.1 * radiance * wavelength * 1e-6 / hc for wavelength, radiance in light[row["time_utc"]])
            ratio.append(float(row["eye_background_e"]) / electrons)
    assert len(ratio) == len(light) >= 3 and max(ratio) / min(ratio) < 1 + 1e-7, ratio
    assert 20 < ratio[0] < 40  # pixels of the circle, 2 arcsec wide in pixels of 0.7


def look_at_picture(folder):
    """The satellite is in the middle of the picture, the sky about it is black."""
    picture = np.asarray(imageio.imread(folder / "a.exr"))
    assert picture.shape[1:] == (32, 3) and picture.dtype == np.float32
    assert picture.max() > 0.5 and (picture[0] == 0).all() and (picture[len(picture) // 2, 16] > 0).all()


def sky_of(folder, header):
    """The satellite's direction and 'up' in GCRS, from azimuth and elevation and the orbit's table."""
    row = next(r for r in rows_of(folder / "run/lightcurve.csv") if r["time_utc"].startswith(WHEN[:-1]))
    azimuth, elevation = (math.radians(float(row[key])) for key in ("azimuth_deg", "elevation_deg"))
    latitude, longitude = (math.radians(header[key]) for key in ("SITELAT", "SITELONG"))
    east = np.array([-math.sin(longitude), math.cos(longitude), 0])
    up = np.array([math.cos(latitude) * math.cos(longitude), math.cos(latitude) * math.sin(longitude), math.sin(latitude)])
    north = np.cross(up, east)
    seen = math.cos(elevation) * (math.sin(azimuth) * east + math.cos(azimuth) * north) + math.sin(elevation) * up
    t = Time(WHEN[:-1], scale="utc")
    turn = erfa.c2t06a(t.tt.jd1, t.tt.jd2, t.jd1, t.jd2, 0.0, 0.0)  # UT1 as UTC: 0.3 s, 5 arcsec
    orbit = min(rows_of(folder / "trajectory/orbit.csv"), key=lambda r: abs(Time(r["time_utc"][:-1]) - t).sec)
    away = np.array([float(orbit[f"{axis}_km"]) for axis in "xyz"])
    return turn.T @ seen, away / np.linalg.norm(away)


def look_at_frame(folder):
    """Where the frame lies on the sky, by astropy's WCS; and from where it was taken."""
    with fits.open(folder / "f.fits") as file:
        header, counts = file[0].header, file[0].data
    assert (header["SITELAT"], header["SITELONG"], header["SITEELEV"]) == (47.067, 15.493, 495)
    assert header["EXPTIME"] == 0.5 and header["RADESYS"] == "ICRS"
    wcs = WCS(header)
    seen, away = sky_of(folder, header)
    middle = [(n - 1) / 2 for n in counts.shape[::-1]]
    assert np.hypot(*(np.array(np.unravel_index(counts.argmax(), counts.shape))[::-1] - middle)) < 4
    ra, dec = wcs.all_pix2world([middle], 0)[0]
    got = erfa.s2c(math.radians(ra), math.radians(dec))
    assert erfa.sepp(got, seen) < 15 * ARCSEC, erfa.sepp(got, seen) / ARCSEC
    ra, dec = wcs.all_pix2world([[middle[0], middle[1] + 100]], 0)[0]
    above = erfa.s2c(math.radians(ra), math.radians(dec)) - got
    up = away - (away @ got) * got
    assert math.isclose(np.linalg.norm(above), 70 * ARCSEC, rel_tol=1e-4)
    assert above @ up / np.linalg.norm(above) / np.linalg.norm(up) > 0.9999
    ra, dec = wcs.all_pix2world([[middle[0] + 100, middle[1]]], 0)[0]
    right = erfa.s2c(math.radians(ra), math.radians(dec)) - got
    assert np.cross(above, right) @ got > 0  # as one sees it who looks along `got`


def write_fits(folder):
    """As observers have them: a table of seconds since a date, and a frame that is compressed."""
    rate = fits.Column("RATE", "E", array=[800, 790, np.nan, 805])
    table = fits.BinTableHDU.from_columns([
        fits.Column("TIME", "D", unit="s", array=[0, 10, 20, 30]), rate, fits.Column("SITE", "4A", array=["Graz"] * 4),
        fits.Column("IMAGE", "3I", array=np.zeros((4, 3)))])
    table.header.update(MJDREFI=57652, MJDREFF=0.85625, TIMESYS="UTC")
    fits.HDUList([fits.PrimaryHDU(), table]).writeto(folder / "table.fits")
    table.header["TIMESYS"] = "TDB"
    fits.HDUList([fits.PrimaryHDU(), table]).writeto(folder / "barycentre.fits")
    with fits.open(folder / "f.fits") as file:
        packed = fits.CompImageHDU(file[0].data, file[0].header, compression_type="GZIP_2", quantize_level=0)
        fits.HDUList([fits.PrimaryHDU(), packed]).writeto(folder / "packed.fits")
    whole = (folder / "table.fits").read_bytes()
    (folder / "cut.fits").write_bytes(whole[: len(whole) // 2880 * 2880 - 2880 + 40])


def look_at_foreign_fits(umbra, folder):
    def run(*arguments):
        return subprocess.run([umbra, *arguments], cwd=folder, capture_output=True, text=True)

    columns = ["--time", "TIME", "--counts", "RATE", "--of", "eye"]
    assert run("import", "table.fits", *columns, "-o", "table.csv").returncode == 0
    rows = rows_of(folder / "table.csv")
    assert [r["time_utc"][11:19] for r in rows] == ["20:33:00", "20:33:10", "20:33:30"]
    assert [float(r["value"]) for r in rows] == [800, 790, 805]
    for name, says in (("barycentre.fits", "TIMESYS is not UTC"), ("cut.fits", "ends before its rows")):
        failed = run("import", name, *columns, "-o", "no.csv")
        assert failed.returncode == 1 and f"{name}: {says}" in failed.stderr, failed.stderr
    for name in ("f", "packed"):
        done = run("photometry", f"{name}.fits", "--aperture", "8,12,20", "-o", f"{name}.csv")
        assert done.returncode == 0, done.stderr
    a, b = ([r["value"] for r in rows_of(folder / f"{name}.csv")] for name in ("f", "packed"))
    assert a == b and float(a[0]) > 0


def main():
    umbra, box = (pathlib.Path(name).resolve() for name in sys.argv[1:])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        shutil.copy(box, folder)
        (folder / "eye.yaml").write_text(box.read_text() + EYE)
        air = ["--set", "observer.air.profile=mid_latitude_summer"]
        (folder / "twilight.yaml").write_text(box.read_text() + EYE.replace(" dark_e_s: 8, read_noise_e: 3, sky_mag_arcsec2: 19", ""))
        walls = "    shell: {areal_heat_capacity_J_m2_K: 3000}\n    lumped: true\n"
        assert walls in box.read_text()
        (folder / "solid.yaml").write_text(box.read_text().replace(walls, "    solid: aluminium_bare\n    facet_size_m: 0.6\n"))
        for arguments in (["run", "box.yaml", "--no-plots", "-o", "run"], ["export", "box.yaml", "--as", "vtu", "-o", "vtu"],
                          ["export", "box.yaml", "--as", "mesh", "-o", "box.obj"],
                          ["export", "box.yaml", "--as", "temperatures", "-o", "t"],
                          ["export", "box.yaml", *air, "--as", "sky", "-o", "sky"],
                          ["run", "twilight.yaml", *air, "--no-plots", "-o", "twilight"],
                          ["run", "solid.yaml", "--no-plots", "-o", "solid-run"],
                          ["export", "solid.yaml", "--as", "vtu", "-o", "solid"],
                          ["export", "box.yaml", "--as", "trajectory", "-o", "trajectory"],
                          ["render", "box.yaml", "--time", WHEN, "--band", "lwir", "--width", "32", "-o", "a.exr"],
                          ["render", "eye.yaml", "--time", WHEN, "--sensor", "eye", "--border", "40", "--no-plots", "-o", "f.fits"]):
            subprocess.run([umbra, *arguments], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        look_at_run(folder)
        script = box.parents[3] / "output/plots.py"
        subprocess.run([sys.executable, script, "svg", folder / "run"], check=True)
        assert all((folder / f"run/{name}-matplotlib.svg").stat().st_size > 10000 for name in ("lightcurve", "temperatures"))
        look_at_grids(folder)
        look_at_solids(folder)
        look_at_grids_by_vtk(folder)
        look_at_material_temperatures(umbra, folder)
        look_at_sky(folder)
        look_at_picture(folder)
        look_at_frame(folder)
        write_fits(folder)
        look_at_foreign_fits(umbra, folder)
    print("1 run, 7 readers: xarray, meshio, vtk, numpy, imageio, astropy, matplotlib; 1 writer: astropy")


if __name__ == "__main__":
    main()
