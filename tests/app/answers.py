"""What every command prints with --json is as its schema says, and every key of every schema is printed
by some command.

    answers.py UMBRA HOUSE

The schemas are those of `umbra help COMMAND --json`. They allow no key that they do not name.
"""
import json
import pathlib
import signal
import subprocess
import sys
import tempfile

import jsonschema

BOX = ["box.yaml"]
SHORT = ["--set", "time.step_s=6", "--set", "time.start_utc=2016-09-06T18:08:00Z"]
EYE = """
sensors:
  eye: {band: vis, aperture_m: 0.5, throughput: 0.1, gain_e: 2, exposure_s: 0.5, pixel_arcsec: 0.7,
        fwhm_arcsec: 2, dark_e_s: 8, read_noise_e: 3, sky_mag_arcsec2: 19, saturation_e: 200000}
"""
LIMITS = """
limits:
  - {of: bus, minimum_K: 250, maximum_K: 280}
cases:
  hot: {set: [environment.solar_irradiance_W_m2=1414]}
"""
BALL = """schema: 1
name: ball
time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T12:01:00Z, step_s: 60}
orbit: {fixed: {position_gcrs_km: [4950, 4950, 0]}}
attitude: [{fixed: {q_gcrs: [1, 0, 0, 0]}}]
observer: {station: {latitude_deg: 4, longitude_deg: 47, height_m: 0}}
parts:
  - {name: ball, sphere: {radius_m: 1}, outside: black, lumped: true,
     shell: {areal_heat_capacity_J_m2_K: 1e9}}
thermal: {start: isothermal, start_temperature_K: 271.5, orbits_before: 0}
bands:
  a: {from_um: 4, to_um: 5}
  b: {from_um: 8, to_um: 9}
  c: {from_um: 10, to_um: 12}
  d: {from_um: 12, to_um: 14}
  e: {from_um: 17, to_um: 24}
"""
STUDY = """schema: 1
name: paint
scenario: box.yaml
mode: exact
parameters:
  - {effect: emittance, target: grey_white, from: 0.9, to: 1.1}
design: {kind: latin_hypercube, points: 4, seed: 1}
outputs: {bands: [lwir], places: [bus]}
"""
SPIN = "attitude: [{spin: {axis_gcrs: [0, 0, 1], axis_body: [0, 0, 1], period_s: 60}}]\n"
BRDF = "incidence_deg,scattering_deg,brdf_1_sr\n" + "".join(
    f"{i},{s},{0.1 + 0.5 * 2.718 ** (-((s - i) / 20) ** 2):.6g}\n"
    for i in (0, 20, 40, 60) for s in range(-70, 75, 10))
PROFILE = "x_um,height_um\n" + "".join(f"{x},{0.3 * ((x * 7919) % 101 / 101 - 0.5) + 0.2 * ((x // 5) % 7):.5g}\n" for x in range(200))
RATIO = "wavelength_um,ratio\n" + "".join(f"{w / 10},{0.9 + w / 4000}\n" for w in range(4, 140, 4))


def commands():
    """Arguments of commands in an order in which each finds the files that it needs."""
    synth = ["synth", *BOX, *SHORT, "--noise", "0.01,0.001", "--seed", "5", "--temperatures", "bus",
             "--with", "emittance:grey_white,factor=0.8"]
    few = ["--only", "emittance", "--only", "area:bus", "--only", "zero_point", "--only", "albedo_level"]
    yield ["new", "mine"]
    yield ["run", *BOX, "--no-plots", "--out", "run"]
    yield ["check", *BOX]
    yield ["check", *BOX, "--view", "--out", "view"]
    yield ["cases", "limits.yaml", "--no-plots", "--out", "cases"]
    yield ["export", *BOX, "--as", "mesh", "-o", "box.obj"]
    yield ["export", *BOX, "--as", "facets", "-o", "facets.csv"]
    yield ["export", *BOX, "--as", "trajectory", "-o", "trajectory"]
    yield ["export", *BOX, "--as", "exchange", "-o", "exchange"]
    yield ["export", *BOX, "--as", "network", "-o", "network"]
    yield ["export", *BOX, "--as", "temperatures", "-o", "temperatures"]
    yield ["export", *BOX, "--set", "observer.air.profile=us_standard", "--as", "sky", "-o", "sky"]
    yield ["export", *BOX, "--as", "vtu", "-o", "vtu"]
    yield ["export", *BOX, "--as", "tdm", "-o", "box.tdm"]
    yield ["forecast", *BOX, "--days", "0.6", "--times"]
    yield ["forecast", *BOX, "--days", "0.6", "--set", "time.step_s=60", "--no-plots", "--out", "forecast"]
    yield ["forecast", *BOX, "--days", "0.6", "--set", "time.step_s=60", "--no-plots", "--uncertain",
           "emittance:grey_white=0.05", "--out", "uncertain"]
    yield ["render", *BOX, "--time", "2016-09-06T18:10:30Z", "--band", "lwir", "--width", "16", "-o", "a.exr"]
    yield ["render", *BOX, "--time", "2016-09-06T18:10:30Z", "--band", "lwir", "--width", "16", "-o", "a.nc"]
    yield ["render", "a.nc", "-o", "b.exr"]
    for i, minute in enumerate(("11:00", "12:00", "14:00")):
        yield ["render", "eye.yaml", "--time", f"2016-09-06T18:{minute}Z", "--sensor", "eye", "--star", "7.5,40,30",
               "--width", "32", "--samples", "4", "--border", "16", "--seed", str(i), "--no-plots", "-o", f"{i}.fits"]
    frames = [f"{i}.fits" for i in range(3)]
    yield ["photometry", *frames, "--aperture", "6,8,11", "-o", "counts.csv"]
    yield ["photometry", *frames, "--aperture", "4,5,7", "--star", "7.5,60,60", "-o", "stars.csv"]
    yield ["calibrate", "eye.yaml", "stars.csv", "--sensor", "eye"]
    yield ["calibrate", "eye.yaml", "stars.csv", "counts.csv", "--sensor", "eye", "-o", "calibrated.csv"]
    yield [*synth, "-o", "m.csv"]
    yield ["compare", *BOX, *SHORT, "m.csv", "--no-plots", "--out", "compare"]
    yield ["study", "study.yaml", "--check"]
    yield ["study", "study.yaml", "--out", "study"]
    yield ["sensitivity", *BOX, "--only", "emittance", "--only", "albedo_level", "--no-plots", "--out", "sensitivity",
           "--what-if", "emittance:grey_white,factor=1.01"]
    yield ["diagnose", *BOX, *SHORT, "m.csv", *few, "--nuisance", "zero_point:vis,sigma=0.05", "--no-plots", "--out",
           "diagnose"]
    yield ["synth", *BOX, *SHORT, "--noise", "0.01,0.001", "--seed", "5", "--with", "zero_point:vis,factor=0.95", "-o",
           "dim.csv"]
    yield ["diagnose", *BOX, *SHORT, "vis.csv", "--no-plots", "--only", "zero_point:vis", "--only", "area:bus",
           "--nuisance", "emittance:grey_white", "--passes", "1", "--out",
           "group"]
    yield ["synth", *BOX, *SHORT, "--noise", "0.01,0.001", "--seed", "5", "--temperatures", "bus", "--with",
           "emittance:grey_white,factor=0.5", "-o", "warm.csv"]
    yield ["diagnose", *BOX, *SHORT, "warm.csv", "--no-plots", "--only", "zero_point:vis", "--out", "warm"]
    yield ["fit", *BOX, *SHORT, "m.csv", "--add", "emittance:grey_white", "--no-plots", "--out", "fit"]
    yield ["fit", *BOX, *SHORT, "vis.csv", "--add", "area:bus", "--nuisance", "zero_point:vis", "--posterior", "--draws",
           "400", "--no-plots", "--out", "together"]
    yield ["synth", "ball.yaml", "--noise", "0.01,0.0001", "--seed", "3", "-o", "ball.csv"]
    yield ["retrieve", "ball.yaml", "ball.csv", "--out", "retrieve"]
    yield ["map", *BOX, "--step", "30", "--no-plots", "--out", "map"]
    yield ["map", *BOX, *SHORT, "m.csv", "--step", "30", "--no-plots", "--out", "map-measured"]
    yield ["synth", "spin.yaml", "--noise", "0.02", "--seed", "1", "-o", "spin.csv"]
    yield ["attitude", "spin.yaml", "spin.csv", "--step", "30", "--axis-step", "30", "--period", "55,65", "--out",
           "attitude"]
    yield ["period", "m.csv", "--no-plots", "--out", "period"]
    yield ["report", "run", "compare", "-o", "both.html"]
    yield ["serve", *BOX, "--only", "emittance"]
    yield ["import", "table.csv", "--time", "UTC", "--magnitude", "V", "--sigma", "Verr", "-o", "table-measured.csv"]
    for thing, item in (("materials", "osr"), ("filters", "johnson_v"), ("sensors", "ufo"),
                        ("effects", "emittance"), ("keys", "parts"), ("scenarios", "cube")):
        yield ["list", thing]
        yield ["list", thing, item]
    yield ["material", "--from-brdf", "brdf.csv"]
    yield ["material", "--from-profile", "profile.csv"]
    yield ["material", "panel", "--from-reflectance", "ratio.csv", "--from-profile", "profile.csv"]
    yield ["validate", "--optics"]
    yield ["replay", "run"]
    yield ["completion", "bash"]
    yield ["help"]
    yield ["help", "run"]


def write_files(house, folder):
    box = (house / "tests/app/data/box.yaml").read_text()
    (folder / "box.yaml").write_text(box)
    (folder / "eye.yaml").write_text(box.replace("18:11:00Z", "18:16:00Z") + EYE)
    (folder / "limits.yaml").write_text(box + LIMITS)
    (folder / "spin.yaml").write_text(box.replace("attitude:\n  - lvlh: {}\n", SPIN).replace("step_s: 60", "step_s: 10"))
    for name, text in (("ball.yaml", BALL), ("study.yaml", STUDY), ("brdf.csv", BRDF), ("profile.csv", PROFILE),
                       ("ratio.csv", RATIO), ("table.csv", "UTC,V,Verr\n2016-09-06T18:08:00Z,7.1,0.1\n")):
        (folder / name).write_text(text)


def served(umbra, arguments, folder):
    """The line that a server says first; it is ended then."""
    with subprocess.Popen([umbra, *arguments, "--json"], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                          text=True) as server:
        line = server.stdout.readline()
        server.send_signal(signal.SIGINT)
    return line


def answer(umbra, arguments, folder):
    if "vis.csv" in arguments:
        rows = (folder / "dim.csv").read_text().splitlines(keepends=True)
        (folder / "vis.csv").write_text("".join(row for row in rows if ",lwir," not in row))
    if arguments[0] == "serve":
        return json.loads(served(umbra, arguments, folder))
    done = subprocess.run([umbra, *arguments, "--json"], cwd=folder, capture_output=True, text=True)
    assert done.returncode in (0, 4), f"{' '.join(arguments)}: {done.stderr}"
    return json.loads(done.stdout)


# Keys that no command above prints; tests/evidence/diagnosis/report.c and tests/app/draft_effect.c do.
SELDOM = (".superseded[]", ".unexplained.others", ".scatter[]", ".outliers[]", ".unexplained.light")


def keys_of(schema, at=""):
    """Paths of all keys that a schema names."""
    for name, inside in schema.get("properties", {}).items():
        yield f"{at}.{name}"
        yield from keys_of(inside, f"{at}.{name}")
    for key in ("items", "additionalProperties"):
        if isinstance(schema.get(key), dict):
            yield from keys_of(schema[key], f"{at}[]")


def seen_in(value, schema, at=""):
    """Paths of the schema's keys that a value has."""
    if isinstance(value, dict):
        names = schema.get("properties", {})
        for name, inside in value.items():
            if name in names:
                yield f"{at}.{name}"
                yield from seen_in(inside, names[name], f"{at}.{name}")
            elif isinstance(schema.get("additionalProperties"), dict):
                yield from seen_in(inside, schema["additionalProperties"], f"{at}[]")
    if isinstance(value, list):
        for inside in value:
            yield from seen_in(inside, schema.get("items", {}), f"{at}[]")


def main():
    umbra, house = (pathlib.Path(name).resolve() for name in sys.argv[1:])
    schema, missing, count = {}, {}, 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_files(house, folder)
        for command in answer(umbra, ["help"], folder)["commands"]:
            verb = command["name"]
            schema[verb] = answer(umbra, ["help", verb], folder)["answer"]
            jsonschema.Draft202012Validator.check_schema(schema[verb])
            missing[verb] = [set(keys_of(one)) | {"the answer"} for one in schema[verb]["anyOf"]]
        for arguments in commands():
            verb, value = arguments[0], answer(umbra, arguments, folder)
            fits = [i for i, one in enumerate(schema[verb]["anyOf"]) if jsonschema.Draft202012Validator(one).is_valid(value)]
            if not fits:
                wrong = min(([e.message for e in jsonschema.Draft202012Validator(one).iter_errors(value)]
                             for one in schema[verb]["anyOf"]), key=len)
                raise AssertionError(f"{' '.join(arguments)}: {wrong[:5]}")
            for i in fits:
                missing[verb][i] -= set(seen_in(value, schema[verb]["anyOf"][i])) | {"the answer"}
            count += 1
    missing["fit"][0] &= missing["diagnose"][0]  # the same schema: what either shows
    missing["diagnose"][0] &= missing["fit"][0]
    never = {f"{verb} {i}": [key for key in sorted(keys) if not key.startswith(SELDOM)]
             for verb, answers in missing.items() for i, keys in enumerate(answers)}
    never = {where: keys for where, keys in never.items() if keys}
    assert never == {}, json.dumps(never, indent=1)
    print(f"{count} commands of {len(schema)} as their schemas say")


if __name__ == "__main__":
    main()
