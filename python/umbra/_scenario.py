"""Scenarios: read, changed, run, held against measurements."""
import datetime
import json
import numbers

import numpy as np
import xarray as xr

from . import _session
from ._arrays import times
from ._c import Memory, ffi, lib, message, record
from ._effects import Effect, effects
from ._keys import find_scenario, names
from ._names import Named
from ._result import Comparison, Diagnosis, Result, Sensitivity


def _value(value):
    """(number, None) or (None, text in YAML) of what a key is given."""
    if isinstance(value, (bool, np.bool_)):
        return None, "true" if value else "false"
    if isinstance(value, numbers.Real):
        return float(value), None
    if isinstance(value, np.datetime64):
        return None, np.datetime_as_string(value.astype("datetime64[us]"), timezone="UTC")
    if isinstance(value, datetime.datetime):
        utc = value if value.tzinfo is None else value.astimezone(datetime.timezone.utc).replace(tzinfo=None)
        return None, utc.isoformat() + "Z"
    if isinstance(value, str):
        return None, value
    return None, json.dumps(value)  # flow style of YAML


def _fill(change, memory, one):
    """A struct umbra_change of (key, value) or of an effect."""
    if isinstance(one, Effect):
        memory.fill(change, effect=one._change(memory))
        return
    number, written = _value(one[1])
    memory.fill(change, key=one[0], number=number, text=written)


def _changes(memory, changes):
    """An array of struct umbra_change, and its length, of a mapping of keys, an effect, or a list of such."""
    listed = []
    for one in [changes] if isinstance(changes, (dict, Effect)) else changes:
        listed += list(one.items()) if isinstance(one, dict) else [one]
    made = memory.new("struct umbra_change[]", max(1, len(listed)))
    for change, one in zip(made, listed):
        _fill(change, memory, one)
    return made, len(listed)


class Scenario(Named):
    """A scenario: the name of one that comes with Umbra (`umbra.scenarios()`), a path, or `text` in YAML, whose names
    of files then lead from `source`.

        s = umbra.Scenario("envisat-graz-2016")
        s["parts.bus.interior.power_W"] = 50
        s.add(umbra.effects.emittance("cell_silicon"))
        result = s.run()
    """

    def __init__(self, source=None, *, text=None, session=None):
        self._session = session or _session.default()
        if text is None:
            if source is None:
                raise TypeError("no scenario; accepted: a name, a path, or text=")
            source = find_scenario(source, self._session)
        memory = Memory()
        self._handle = self._session.make("scenario_read", "scenario", memory.text(source), memory.text(text))

    # --- changes -----------------------------------------------------------------------------------------------------

    def __setitem__(self, key, value):
        self.change({key: value})

    def __getitem__(self, key):
        """What a key says, changes included: a number, a flag, a text (times, too), a list, or a dict of a group. What
        the scenario leaves to its default is an InputError; `umbra.keys` has defaults."""
        out = ffi.new("const struct umbra_value **")
        self._session.call("scenario_get", self._handle.pointer, Memory().text(key), out)
        value = record(out[0][0])
        kind = value.kind.name
        if kind == "VALUE_LIST":
            return [self[f"{key}.{i}"] for i in range(value.count)]
        if kind == "VALUE_GROUP":
            return {name: self[f"{key}.{name}"] for name in value.name}
        return {"VALUE_NUMBER": value.number, "VALUE_FLAG": value.number == 1.0}.get(kind, value.text)

    def change(self, *changes):
        """Several changes, all or none: mappings of keys to values, and effects. Only what they make together is
        checked, so that a window of time may move."""
        memory = Memory()
        made, count = _changes(memory, changes)
        self._session.call("scenario_change", self._handle.pointer, made, count)
        return self

    def add(self, *added):
        """Turn effects on."""
        return self.change(*added)

    def without(self, *removed):
        """Turn effects off everywhere, by name: s.without("albedo")."""
        return self.change(*(effects[name].off() for name in removed))

    # --- answers -----------------------------------------------------------------------------------------------------

    def _model(self):
        return self._session.make("model_build", "model", self._handle.pointer, long=True)

    def _names(self, model):
        return {kind[:-1].lower(): (kind[:-1].lower(), names("model_names", self._session, model.pointer, kind))
                for kind in ("PLACES", "MATERIALS", "BANDS", "SENSORS", "MECHANISMS")}

    def run(self):
        """Light and heat over the scenario's own window: a Result."""
        model = self._model()
        return Result(self._session.make("run", "result", model.pointer, long=True), self._names(model))

    def variants(self, sets, arrays=("irradiance",), *, workers=0, exact=False):
        """Many changes of the scenario, each on its own: an xarray.Dataset of the arrays with an axis "set" in front.

        sets     a mapping of names to changes, or a list of changes; a change is a mapping of keys to values, an
                 effect, or a list of such
        arrays   names of arrays of a run
        workers  processes that compute; 0: as many as the session has threads
        exact    heat of each as a run has it; else to 0.1 K

        What the model refuses is NaN, and `refused` says why.
        """
        labels, changes = (list(sets), list(sets.values())) if isinstance(sets, dict) else (range(len(sets)), sets)
        memory, model = Memory(), self._model()
        settings = memory.structure("umbra_variants_settings", exact=int(exact))
        variants = self._session.make("variants_open", "variants", model.pointer, settings)
        given = memory.new("struct umbra_changes[]", max(1, len(changes)))
        for to, one in zip(given, changes):
            to.change, to.nchange = _changes(memory, one)
        many = memory.structure("umbra_many", array=list(dict.fromkeys([*arrays, "time_unix_s"])), workers=workers)
        handle = self._session.make("evaluate_many", "result", variants.pointer, given, len(changes), many, long=True)
        result = Result(handle, {"set": ("set", list(labels)), **self._names(model)})
        out = xr.Dataset({name: result[name] for name in arrays})
        refused = [message(lib.umbra_result_refusal(handle.pointer, i)) for i in range(len(changes))]
        return out.assign_coords(refused=("set", refused), **_instants(result.time_unix_s))

    def compare(self, measurements):
        """The scenario beside measurements: a Comparison."""
        handle = self._session.make("compare", "result", self._handle.pointer, measurements._handle.pointer, long=True)
        return Comparison(handle, lib.umbra_result_comparison(handle.pointer), measurements._rows())

    def diagnose(self, measurements, *, only=(), exclude=(), level=0.0, steps=0):
        """Which effect the scenario lacks: a Diagnosis. only, exclude: "effect" or "effect:target"; level: family-wise
        false-alarm rate, 0: 0.01; steps: effects at most, 0: 4. Takes minutes and more."""
        memory = Memory()
        settings = memory.structure("umbra_diagnose_settings", only=list(only), exclude=list(exclude), level=level,
                                    steps=steps)
        return self._diagnosis("diagnose", measurements, settings)

    def fit(self, measurements, *chosen):
        """Parameters of chosen effects: a Diagnosis. Values of the effects are where the fit starts."""
        memory = Memory()
        given = memory.new("struct umbra_effect_change[]", max(1, len(chosen)))
        for to, effect in zip(given, chosen):
            ffi.memmove(ffi.addressof(to), effect._change(memory), ffi.sizeof(to))
        return self._diagnosis("fit", measurements, given, len(chosen))

    def _diagnosis(self, name, measurements, *arguments):
        handle = self._session.make(name, "result", self._handle.pointer, measurements._handle.pointer, *arguments,
                                    long=True)
        return Diagnosis(handle, lib.umbra_result_verdict(handle.pointer), {})

    def sensitivity(self, measurements=None, *, only=(), exclude=()):
        """Derivatives by the parameters of effects, at the scenario's instants or at those of measurements: a
        Sensitivity."""
        memory = Memory()
        settings = memory.structure("umbra_sensitivity_settings", only=list(only), exclude=list(exclude))
        handle = self._session.make("sensitivity", "result", self._handle.pointer,
                                    ffi.NULL if measurements is None else measurements._handle.pointer, settings,
                                    long=True)
        return Sensitivity(handle, lib.umbra_result_sensitivity(handle.pointer))


def _instants(unix):
    """Coordinates "time" of sets: one axis, where all have the same times."""
    rows = unix.values[np.isfinite(unix.values).all(axis=1)]
    if len(rows) and (rows == rows[0]).all():
        return {"time": ("time", times(rows[0]))}
    return {"time_utc": (("set", "time"), times(unix.values))}
