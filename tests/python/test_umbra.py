"""The Python package beside the command and beside umbra.h.

    test_umbra.py UMBRA PAIR.SO [unittest's options]      with umbra importable, UMBRA_LIBRARY naming the library
"""
import concurrent.futures
import contextlib
import csv
import gc
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import unittest
import warnings

import numpy as np
import pandas as pd
import umbra

PROGRAM, PAIR = (os.path.abspath(path) for path in sys.argv[1:3])
SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BOX = os.path.join(SOURCE, "tests", "app", "data", "box.yaml")
SEEN = {"time.start_utc": "2016-09-06T18:08:00Z", "time.step_s": 6}  # of the box


def box():
    return umbra.Scenario(BOX).change(SEEN)


def first_parameter(effect):
    return next(iter(getattr(umbra.effects, effect).parameters.values()))


class Runs(unittest.TestCase):
    """What a run gives is what the command writes."""

    @classmethod
    def setUpClass(cls):
        cls.result = box().run()

    def test_csv(self):
        with tempfile.TemporaryDirectory() as folder:
            sets = [word for key, value in SEEN.items() for word in ("--set", f"{key}={value}")]
            subprocess.run([PROGRAM, "run", BOX, *sets, "--no-plots", "--out", "out"], cwd=folder, check=True,
                           stdout=subprocess.DEVNULL)
            with open(os.path.join(folder, "out", "lightcurve.csv")) as file:
                rows = list(csv.DictReader(file))
            self.result.write(os.path.join(folder, "ours"))
            with open(os.path.join(folder, "ours", "lightcurve.csv")) as file:
                self.assertEqual(rows, list(csv.DictReader(file)))
        light = self.result.intensity
        self.assertEqual(light.dims, ("time", "band"))
        self.assertEqual(light.sizes["time"], len(rows))
        self.assertEqual(light.attrs["units"], "W/sr")
        for k, row in enumerate(rows):
            self.assertEqual(np.datetime64(row["time_utc"][:-1]), light.time.values[k])
            for band in ("vis", "lwir"):
                said = float(row[f"{band}_intensity_W_sr"])
                self.assertAlmostEqual(float(light.sel(band=band)[k]), said, delta=1e-8 * abs(said))
                sun = float(row[f"{band}_sun_W_sr"])
                ours = self.result.intensity_parts.sel(band=band, mechanism="sun").sum("material")[k]
                self.assertAlmostEqual(float(ours), sun, delta=1e-8 * abs(sun))

    def test_no_copy(self):
        first, second = self.result.irradiance.values, self.result.irradiance.values
        self.assertEqual(first.__array_interface__["data"], second.__array_interface__["data"])
        self.assertFalse(first.flags.owndata)
        with self.assertRaises(ValueError):
            first[0, 0] = 1.0

    def test_owner_lives(self):
        result = box().run()
        light = result.intensity.values
        total = light.sum()
        del result
        gc.collect()
        box().run()  # would take freed memory
        self.assertEqual(light.sum(), total)

    def test_dataset(self):
        made = self.result.to_dataset()
        self.assertIn("bus", made.place.values)
        self.assertIn("material:grey_white", made.place.values)
        self.assertEqual(list(made.mechanism.values), ["sun", "earth", "emitted", "interreflected", "other"])
        self.assertEqual(made.wavelength_m.dims, ("bin",))
        self.assertTrue(np.issubdtype(made.time.dtype, np.datetime64))
        self.assertTrue(100 < float(made.temperature.sel(place="bus").mean()) < 400)

    def test_cite(self):
        cited = umbra.cite(self.result)
        self.assertIn(umbra.__version__, cited.sentence)
        self.assertTrue(cited.bibtex.lstrip().startswith("@"))

    def test_folder_of_others_stays(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "mine"), "w"):
                pass
            with self.assertRaises(umbra.IoError):
                self.result.write(folder)
            self.assertTrue(os.path.exists(os.path.join(folder, "mine")))

    def test_without(self):
        """Less light heats the satellite, and the change stays in the scenario."""
        scenario = umbra.Scenario("hidden-effect/dusk").change({"time.step_s": 60})
        before = scenario.run().temperature.sel(place="bus")
        after = scenario.without("albedo").run().temperature.sel(place="bus")
        self.assertTrue((after < before).all())

    def test_many(self):
        """A variant is the scenario, changed and run."""
        key, effect = "parts.bus.shell.areal_heat_capacity_J_m2_K", umbra.effects.emittance("grey_white")
        found = box().variants({"as it is": [], "heavy": {key: 6000}, "dull": effect, "wrong": {key: -1}},
                               ["irradiance", "temperature"], exact=True)
        self.assertEqual(list(found["set"].values), ["as it is", "heavy", "dull", "wrong"])
        heavy = box().change({key: 6000}).run()
        np.testing.assert_allclose(found.irradiance.sel(set="heavy"), heavy.irradiance, rtol=1e-6)
        dull = box().add(effect).run()
        np.testing.assert_allclose(found.temperature.sel(set="dull"), dull.temperature, rtol=1e-6)
        self.assertTrue(np.isnan(found.irradiance.sel(set="wrong")).all())
        self.assertIn("-1", str(found.refused.sel(set="wrong").values))
        self.assertEqual(list(found.time.values), list(dull.irradiance.time.values))


class Names(unittest.TestCase):
    """Nothing is listed in Python; wrong names are told the nearest."""

    def test_every_effect(self):
        said = subprocess.run([PROGRAM, "effects"], check=True, capture_output=True, text=True).stdout
        for name in umbra.effects:
            made = getattr(umbra.effects, name)
            self.assertRegex(said, rf"(?m)^ *{name}\b")
            self.assertIn(made.about.summary, made.__doc__)
            self.assertIn(made.about.reference, made.__doc__)
            for parameter in made.parameters.values():
                self.assertIn(f"{parameter.name}: {parameter.help}", made.__doc__)
                self.assertIn(f"{parameter.minimum:g} to {parameter.maximum:g}", made.__doc__)
            self.assertIn(name, dir(umbra.effects))
        self.assertGreater(len(umbra.effects), 50)

    def test_every_key(self):
        self.assertGreater(len(umbra.keys), 200)
        for path, key in umbra.keys.items():
            self.assertTrue(key.doc, path)
            if key.accepted:
                self.assertIn(key.accepted, key.doc)
        self.assertIn("W", umbra.keys["parts.interior.power_W"].doc)

    def test_own_effect(self):
        """A user's own effects have their classes and texts at once, and act."""
        self.addCleanup(umbra.configure)
        before = box().run()
        self.assertEqual(umbra.effects.load(PAIR), ["twice", "twice_more"])
        self.assertIn("Twice as bright", umbra.effects.twice.__doc__)
        self.assertIn("twice", dir(umbra.effects))
        after = box().add(umbra.effects.twice()).run()
        np.testing.assert_array_equal(after.irradiance, 2 * before.irradiance)

    def test_every_declaration(self):
        """All functions of the header are there."""
        with open(os.path.join(SOURCE, "library", "umbra.h")) as file:
            names = set(re.findall(r"^[a-z].*?\b(umbra_[a-z_]+)\(", file.read(), re.M))
        self.assertGreater(len(names), 30)
        for name in names:
            self.assertTrue(hasattr(umbra._lib, name), name)

    def assertTold(self, error, words, call):
        with self.assertRaises(error) as caught:
            call()
        self.assertIn(words, str(caught.exception))
        self.assertNotIn("\n", str(caught.exception))

    def test_read_back(self):
        """A key says what was set last, with all its bits; groups and lists as Python has them."""
        s = box()
        s["time.step_s"] = 0.1 + 0.2
        self.assertEqual(s["time.step_s"], 0.1 + 0.2)
        s["time.step_s"] = "45"
        self.assertEqual(s["time.step_s"], 45.0)
        self.assertEqual(s["time.start_utc"], "2016-09-06T18:08:00Z")
        self.assertIs(s["parts.bus.lumped"], True)
        self.assertEqual(s["parts.bus.box.size_m"], [1.0, 1.0, 1.0])
        self.assertEqual(s["parts"][0]["shell"], {"areal_heat_capacity_J_m2_K": 3000.0})
        self.assertTold(umbra.InputError, "states nothing there", lambda: s["environment.albedo"])

    def test_nearest(self):
        result = Runs.result if hasattr(Runs, "result") else box().run()
        name = first_parameter("emittance").name
        told = self.assertTold
        told(AttributeError, "did you mean emittance?", lambda: umbra.effects.emitance)
        told(TypeError, f"did you mean {name}?", lambda: umbra.effects.emittance("mli", **{name + "s": 1}))
        told(AttributeError, "did you mean target?", lambda: umbra.effects.emittance("mli").targt)
        told(AttributeError, "did you mean run?", lambda: box().rum)
        told(AttributeError, "did you mean irradiance?", lambda: result.iradiance)
        told(KeyError, "did you mean irradiance?", lambda: result["iradiance"])
        told(AttributeError, "has no", lambda: setattr(box(), "step", 3))
        told(KeyError, "parts.interior.power_W", lambda: umbra.keys["parts.interior.powr_W"])
        told(FileNotFoundError, "did you mean envisat-graz-2016?", lambda: umbra.Scenario("envisat-graz-2017"))
        told(umbra.InputError, "did you mean 'step_s'?", lambda: box().__setitem__("time.stap_s", 3))
        told(umbra.InputError, "out of range", lambda: box().add(umbra.effects.emittance("grey_white", **{name: 1e9})))
        told(AttributeError, "did you mean albedo?", lambda: box().without("albdo"))
        told(KeyError, "did you mean value?", lambda: umbra.Measurements(pd.DataFrame({"vlaue": [1.0]})))

    def test_errors(self):
        """One class for each status, which Python programs catch as their own, too."""
        self.assertTrue(issubclass(umbra.InputError, ValueError) and issubclass(umbra.InputError, umbra.Error))
        self.assertTrue(issubclass(umbra.IoError, OSError))
        with self.assertRaises(umbra.InputError) as caught:
            umbra.Scenario(text="schema: 1\nname: [")
        self.assertIn("scenario.yaml", str(caught.exception))

    def test_every_scenario(self):
        self.assertIn("envisat-graz-2016", umbra.scenarios())
        for name in umbra.scenarios():
            umbra.Scenario(name)
        self.assertIn("black", umbra.materials())


class Evidence(unittest.TestCase):
    """Measurements, from pandas and back, and what they say."""

    @classmethod
    def setUpClass(cls):
        cls.value = 0.5
        cls.effect = umbra.effects.emittance("grey_white", **{first_parameter("emittance").name: cls.value})
        cls.measured = umbra.synth(box().add(cls.effect), 0.01, seed=1, temperatures=["bus"])

    def test_round(self):
        table = self.measured.to_pandas()
        self.assertEqual(len(table), len(self.measured))
        pd.testing.assert_frame_equal(umbra.Measurements(table).to_pandas(), table)
        indexed = table.set_index("time").tz_localize("UTC").tz_convert("Asia/Tokyo")
        pd.testing.assert_frame_equal(umbra.Measurements(indexed).to_pandas(), table)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "m.csv")
            self.measured.write(path)
            pd.testing.assert_frame_equal(umbra.read_measurements(path).to_pandas(), table)

    def test_compare(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", umbra.UmbraWarning)
            found = box().compare(self.measured)
        table = self.measured.to_pandas()
        self.assertEqual(list(found.residual.of.values), list(table["of"]))
        np.testing.assert_allclose(found.model + found.residual, table["value"], rtol=1e-9)
        self.assertEqual(int(found.channels["count"].sum()), len(table))
        self.assertGreater(found.chi2_reduced, 5.0)

    def test_fit(self):
        start = umbra.effects.emittance("grey_white")
        found = box().fit(self.measured, start)
        row = found.estimates.iloc[0]
        self.assertEqual((row.effect, row.target), ("emittance", "grey_white"))
        self.assertLess(abs(row.value - self.value), 4 * row.sigma)
        self.assertIn("emittance", str(found))
        self.assertLess(found.verdict.chi2_after, found.verdict.chi2_before)

    def test_diagnose(self):
        found = box().diagnose(self.measured, only=["emittance", "solar_absorptance"])
        self.assertIs(found.verdict.kind, umbra.VerdictKind.FOUND)
        self.assertEqual(found.verdict.finding[0].effect, "emittance")

    def test_sets(self):
        table = self.measured.to_pandas()
        early = table["time"] < table["time"].median()
        parts = [umbra.Measurements(table[early]), umbra.Measurements(table[~early])]
        both = umbra.join({"early": parts[0], "late": parts[1]})
        self.assertEqual(len(both), len(table))
        found = box().diagnose(both, only=["emittance", "zero_point"])
        self.assertEqual(found.verdict.finding[0].effect, "emittance")
        half = {h.name: h.probability for h in found.verdict.half}
        self.assertAlmostEqual(sum(half.values()), 1.0)
        self.assertGreater(half["surface"], 0.9)
        self.assertGreater(found.verdict.probability_one, 0.9)
        with self.assertRaises(umbra.InputError):
            umbra.join({"a": both, "b": parts[0]})
        with self.assertRaises(umbra.InputError):
            umbra.join([])

    def test_sensitivity(self):
        found = box().sensitivity(only=["emittance"])
        name = found.parameters.index[0]
        null, value = found.parameters.null_value[name], 0.9
        moved = found.what_if({name: value})
        slope = found.d_temperature.sel(parameter=name)
        np.testing.assert_allclose(moved.temperature, found.temperature + slope * (value - null), rtol=1e-9)
        with self.assertRaises(KeyError):
            found.what_if({"nothing": 1.0})


STUDY = """schema: 1
name: read
scenario: box.yaml
parameters:
  - {material: grey_white, property: emittance, from: 0.7, to: 0.9}
  - {key: parts.bus.shell.areal_heat_capacity_J_m2_K, from: 2000, to: 4000, unit: J/m2/K}
design: {kind: grid, levels: 2}
outputs: {bands: [vis, lwir], places: [bus]}
"""


class Points(unittest.TestCase):
    """Studies and forecasts."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        shutil.copy(BOX, os.path.join(folder.name, "box.yaml"))
        self.study = os.path.join(folder.name, "study.yaml")
        with open(self.study, "w") as file:
            file.write(STUDY)
        self.out = os.path.join(folder.name, "out")

    def test_study(self):
        found = umbra.study(self.study, workers=1)
        self.assertEqual(found.sizes["point"], 4)
        self.assertEqual(list(found.band.values), ["vis", "lwir"])
        with concurrent.futures.ProcessPoolExecutor(2) as executor:
            shared = umbra.study(self.study, self.out, executor=executor)
        self.assertTrue(found.drop_vars([]).equals(shared))
        self.assertTrue(os.path.exists(os.path.join(self.out, "points.csv")))
        self.assertFalse(os.path.exists(self.out + ".points"))

    def test_study_errors(self):
        with self.assertRaises(umbra.IoError):
            umbra.study(self.study + ".none")

    def test_forecast(self):
        found = umbra.forecast(umbra.Scenario(BOX), self.out, start="2016-09-06", stations={"Graz": (47.067, 15.493, 495)},
                               minimum_elevation=20)
        self.assertGreater(len(found.passes), 0)
        self.assertTrue((found.passes.culmination_elevation_deg >= 20).all())
        self.assertTrue((found.passes.rise_utc < found.passes.set_utc).all())
        self.assertEqual(set(found.curves["pass"]), set(found.passes["pass"]))
        self.assertIsNone(found.contributions)
        self.assertTrue(os.path.exists(os.path.join(self.out, "passes.ics")))


class Page(unittest.TestCase):
    """What docs/python.md shows runs."""

    def test_ten_lines(self):
        with open(os.path.join(SOURCE, "docs", "python.md")) as file:
            shown = re.search(r"```python\n(.*?)```", file.read(), re.S).group(1)
        self.assertLessEqual(len([line for line in shown.splitlines() if line]), 10)
        here = os.getcwd()
        with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
            warnings.simplefilter("ignore")
            os.chdir(folder)
            self.addCleanup(os.chdir, here)
            with open(os.devnull, "w") as null, contextlib.redirect_stdout(null):
                exec(compile(shown, "docs/python.md", "exec"), {})
            self.assertTrue(os.path.exists("out/silver/lightcurve.csv"))
            os.chdir(here)


class Sessions(unittest.TestCase):
    """Progress, Ctrl-C, threads, warnings."""

    def tearDown(self):
        umbra.configure()

    def long(self):
        return umbra.Scenario(BOX).change({"time.stop_utc": "2016-09-07T18:11:00Z", "time.step_s": 1})

    def test_interrupt(self):
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        scenario = self.long()
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            scenario.run()
        box().run()

    def test_progress(self):
        heard = []
        umbra.configure(progress=lambda *step: heard.append(step))
        box().run()
        self.assertTrue(heard and all(done <= total or total == 0 for _, done, total in heard))

    def test_progress_raises(self):
        def raises(*step):
            raise ZeroDivisionError("mine")
        umbra.configure(progress=raises)
        with self.assertRaises(ZeroDivisionError):
            box().run()

    def test_warning(self):
        """Of the program, told at the line of the caller."""
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            umbra.Scenario("envisat-graz-2016").change({"time.step_s": 300})._model()
        said = [one for one in told if one.category is umbra.UmbraWarning]
        self.assertTrue(said and all(one.filename == __file__ for one in said), told)
        self.assertIn("elements of object", str(said[0].message))

    def test_threads(self):
        """Threads with sessions of their own, and threads that share one."""
        expected, found = box().run().irradiance.values, []

        def run(session):
            found.append(umbra.Scenario(BOX, session=session).change(SEEN).run().irradiance.values)

        lanes = [threading.Thread(target=run, args=(one,)) for one in (None, None, umbra.Session(threads=1))]
        for lane in lanes:
            lane.start()
        for lane in lanes:
            lane.join()
        self.assertEqual(len(found), 3)
        for one in found:
            np.testing.assert_array_equal(one, expected)

    def test_end(self):
        """Python ends well while threads of a computation still wait for work."""
        for _ in range(4):
            subprocess.run([sys.executable, "-c", f"import umbra; kept = umbra.Scenario({BOX!r}).run().irradiance"],
                           check=True, stderr=subprocess.DEVNULL)

    def test_forked(self):
        """A forked child has a session of its own."""
        box().run()
        child = os.fork()
        if child == 0:
            os._exit(0 if len(umbra.effects) > 50 else 1)
        self.assertEqual(os.waitpid(child, 0)[1], 0)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
