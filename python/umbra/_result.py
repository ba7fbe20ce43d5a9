"""Results: arrays by name, datasets, files, citations."""
import collections

import numpy as np
import xarray as xr

from ._arrays import data_array, listed, times
from ._c import Memory, ffi, record, text
from ._names import Named, hint

Citation = collections.namedtuple("Citation", "sentence bibtex")
Citation.__doc__ = "What a result rests on: a sentence for a paper, and the BibTeX entries that it names."


class Result(Named):
    """What a run gives. Its arrays are attributes: `result.irradiance` is an xarray.DataArray with the names of
    times, bands and places, whose numbers are the library's own, not copied and read-only."""

    def __init__(self, handle, coordinates=None):
        self._handle = handle
        self._listed = listed(handle.pointer)
        self._coordinates = dict(coordinates or {})
        if "time_unix_s" in self._listed and "time" not in self._coordinates:
            made = data_array(self._listed["time_unix_s"], handle, {})
            if made.dims == ("time",):
                self._coordinates["time"] = ("time", times(made.values))
        if "wavelength_m" in self._listed:
            self._coordinates["wavelength_m"] = ("bin", data_array(self._listed["wavelength_m"], handle, {}).values)

    @property
    def arrays(self):
        """Names of its arrays."""
        return list(self._listed)

    def __getitem__(self, name):
        if name not in self._listed:
            raise KeyError(f"no array '{name}'; {hint(name, self._listed)}")
        return data_array(self._listed[name], self._handle, self._coordinates)

    def __getattr__(self, name):
        if not name.startswith("_") and name in self._listed:
            return self[name]
        return super().__getattr__(name)

    def __dir__(self):
        return [*super().__dir__(), *self.__dict__.get("_listed", ())]

    def to_dataset(self):
        """All arrays as an xarray.Dataset. What is its own coordinate (times, wavelengths) stands there."""
        own = {"time_unix_s"} if "time" in self._coordinates else set()
        return xr.Dataset({name: self[name] for name in self._listed if name not in own | set(self._coordinates)})

    def write(self, folder, *, force=False, pictures=False):
        """Write the files that the command writes for such a result; the folder appears whole or not at all. force:
        also in place of a folder that Umbra did not write."""
        memory = Memory()
        how = memory.structure("umbra_write", force=int(force), pictures=int(pictures), command="python umbra")
        self._handle.session.work("result_write", self._handle.pointer, memory.text(folder), how)

    def __repr__(self):
        return f"<umbra.{type(self).__name__}: {', '.join(self._listed)}>"


class Comparison(Result):
    """A scenario beside measurements: `chi2`, `dof`, `chi2_reduced`, `channels` (a pandas.DataFrame, one row for each
    quantity of each band or place), arrays of rows."""

    def __init__(self, handle, pointer, coordinates):
        super().__init__(handle, coordinates)
        self._said = record(pointer[0])

    chi2 = property(lambda self: self._said.chi2, doc="Of all observations with a sigma.")
    dof = property(lambda self: self._said.dof, doc="Degrees of freedom.")
    chi2_reduced = property(lambda self: self._said.chi2_reduced, doc="chi2 / dof.")

    @property
    def channels(self):
        """A row for each quantity of each band or place."""
        import pandas
        return pandas.DataFrame([vars(channel) for channel in self._said.channel]).set_index(["quantity", "of"])


class Diagnosis(Result):
    """Of a diagnosis or a fit: `verdict`, with members as struct umbra_verdict has them, and arrays of the model
    before and after. str() is the sentence for a person."""

    def __init__(self, handle, pointer, coordinates):
        super().__init__(handle, coordinates)
        self._said = record(pointer[0])

    verdict = property(lambda self: self._said, doc="Findings with estimates, alternatives, what to measure next.")

    @property
    def estimates(self):
        """A row for each parameter that was fitted, as a pandas.DataFrame."""
        import pandas
        rows = [{"effect": f.effect, "target": f.target, "confidence": f.confidence.name.lower(), **vars(e)}
                for f in self._said.finding for e in f.estimate]
        return pandas.DataFrame(rows, columns=None if rows else ["effect", "target", "name", "value", "sigma"])

    def __str__(self):
        return self._said.sentence


class Sensitivity(Result):
    """Derivatives of light and temperatures by the parameters of effects: d_light [parameter, band, time],
    d_temperature [parameter, place, time]."""

    def __init__(self, handle, pointer):
        self._said = record(pointer[0])
        names = [column.name for column in self._said.derivative]
        super().__init__(handle, {"parameter": ("parameter", names), "band": ("band", self._said.band),
                                  "place": ("place", self._said.place)})

    @property
    def parameters(self):
        """What the columns are, as a pandas.DataFrame: ranges, units, methods, errors."""
        import pandas
        return pandas.DataFrame([vars(column) for column in self._said.derivative]).set_index("name")

    def what_if(self, values):
        """Light and temperatures when parameters take values, {"emittance:mli.factor": 1.1}, as the matrix
        says, at once. A switch takes 1 for on."""
        names = [column.name for column in self._said.derivative]
        for name in values:
            if name not in names:
                raise KeyError(f"no parameter '{name}'; {hint(name, names)}")
        columns, numbers = [names.index(name) for name in values], [float(value) for value in values.values()]
        session = self._handle.session
        made = session.make("what_if", "result", self._handle.pointer, ffi.new("size_t[]", columns),
                            ffi.new("double[]", numbers), len(columns))
        return Result(made, {name: self._coordinates[name] for name in ("time", "band", "place")})


def cite(result):
    """What to cite for a result: a Citation with `sentence` and `bibtex`."""
    out = ffi.new("const struct umbra_citation **")
    handle = result._handle
    handle.session.call("cite", handle.pointer, out)
    return Citation(text(out[0].sentence), text(out[0].bibtex))
