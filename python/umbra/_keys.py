"""Keys of a scenario, and names of what the data folder has."""
import math
import os
from collections.abc import Mapping

from . import _session
from ._c import ffi, labels, lib, record, texts
from ._names import hint

_KINDS = {label: value for value, label in labels("umbra_names").items()}


def _doc(key):
    out = [key.help or "A group of keys."]
    if key.accepted:
        out.append(f"Accepted: {key.accepted}.")
    if key.choice:
        out.append(f"One of {', '.join(key.choice)}.")
    if key.unit:
        out.append(f"In {key.unit}.")
    if not math.isnan(key.default_value):
        known = key.choice[int(key.default_value)] if key.choice else f"{key.default_value:g}"
        out.append(f"Default: {known}.")
    if key.required:
        out.append("Required.")
    return " ".join(out)


class Keys(Mapping):
    """What a scenario may state: `umbra.keys["parts.interior.power_W"].doc`. Names of elements are left out: a
    scenario's own key is "parts.bus.interior.power_W"."""

    def __init__(self):
        self._known = None

    def _all(self):
        if self._known is None:
            known, index, session = {}, 0, _session.default().pointer
            while (pointer := lib.umbra_key_at(session, index)) != ffi.NULL:
                key = record(pointer[0])
                key.__dict__["doc"] = _doc(key)
                known[key.path] = key
                index += 1
            self._known = known
        return self._known

    def __getitem__(self, path):
        if path not in self._all():
            raise KeyError(f"no key '{path}'; {hint(path, self._all())}")
        return self._all()[path]

    def __iter__(self):
        return iter(self._all())

    def __len__(self):
        return len(self._all())


keys = Keys()


def names(function, session, *arguments):
    """Names of a kind, of a function that has (.., kind, out, count) behind `arguments`: names("model_names", session,
    model, "BANDS")."""
    *before, kind = arguments
    out, count = ffi.new("const char *const **"), ffi.new("size_t *")
    session.call(function, *before, _KINDS[kind], out, count)
    return texts(out[0], count[0])


def materials():
    """Names of the materials that come with Umbra."""
    return names("data_names", _session.default(), "MATERIALS")


def sensors():
    """Names of the sensors that come with Umbra."""
    return names("data_names", _session.default(), "SENSORS")


def find_scenario(name, session=None):
    """Path of a scenario: of one that comes with Umbra, by its name, or of a file or folder that is there."""
    session = session or _session.default()
    for path in (os.fspath(name), os.path.join(session.data, "scenarios", os.fspath(name))):
        if os.path.exists(path):
            return path
    raise FileNotFoundError(f"no file, folder or scenario '{name}'; {hint(name, scenarios())}")


def scenarios():
    """Names of the scenarios that come with Umbra, each good for `umbra.Scenario(name)`."""
    root = os.path.join(_session.default().data, "scenarios")
    found = []
    for folder, inner, files in os.walk(root):
        inner.sort()
        if "scenario.yaml" in files:
            found.append(os.path.relpath(folder, root))
    return found
