"""Measurements: from files, from pandas, and back."""
import numpy as np

from . import _session
from ._arrays import posix, times
from ._c import Memory, ffi, text
from ._names import Named, hint

_ABOUT = {"size", "count"}  # of struct umbra_columns, no columns


def _columns():
    """Members of struct umbra_columns that are columns, with the kind of their elements."""
    return {name: field.type.item.cname for name, field in ffi.typeof("struct umbra_columns").fields
            if name not in _ABOUT}


class Measurements(Named):
    """Measurements as a table: one row an observation, with columns named as in struct umbra_columns (quantity, of,
    value, sigma ...; time_unix_s, or `time` as datetime64 in UTC). Made of a pandas.DataFrame; to_pandas() goes back.
    Of rows without a sigma the scenario's noise model says it."""

    def __init__(self, table=None, *, session=None, _handle=None):
        self._session = session or _session.default()
        self._handle = _handle or self._make(table)

    def _make(self, table):
        table, known = table.reset_index() if table.index.name == "time" else table, _columns()
        for name in table.columns:
            if name not in known and name != "time":
                raise KeyError(f"measurements have no column '{name}'; {hint(name, [*known, 'time'])}")
        memory, given = Memory(), {}
        for name, kind in known.items():
            if name == "time_unix_s" and "time" in table:
                given[name] = _numbers(memory, posix(_utc(table["time"])), "double")
            elif name in table:
                of = _texts if "char" in kind else _numbers
                given[name] = of(memory, table[name], kind)
        made = memory.structure("umbra_columns", count=len(table), **given)
        return self._session.make("measurements_make", "measurements", made)

    def to_pandas(self):
        """A pandas.DataFrame with the columns that there are, and `time` in front."""
        import pandas
        out, columns = ffi.new("const struct umbra_columns **"), {}
        self._session.call("measurements_columns", self._handle.pointer, out)
        said = out[0]
        for name, kind in _columns().items():
            pointer = getattr(said, name)
            if pointer == ffi.NULL:
                continue
            if "char" in kind:
                columns[name] = [text(pointer[i]) for i in range(said.count)]
            else:
                dtype = np.float64 if kind == "double" else np.intc
                size = said.count * np.dtype(dtype).itemsize
                columns[name] = np.frombuffer(ffi.buffer(pointer, size), dtype=dtype).copy()
        table = pandas.DataFrame(columns)
        table.insert(0, "time", times(table.pop("time_unix_s").to_numpy()))
        return table

    def write(self, path, *, force=False):
        """A CSV file of them, which the command reads (docs/files.md). force: in place of a file that is there."""
        memory = Memory()
        self._session.call("measurements_write", self._handle.pointer, memory.text(path), int(force))

    def _rows(self):
        """Coordinates of arrays that have a number for each row."""
        table = self.to_pandas()
        return {name: ("observation", table[name].to_numpy()) for name in ("time", "quantity", "of")}

    def __len__(self):
        return len(self.to_pandas())

    def __repr__(self):
        table = self.to_pandas()
        channels = table.groupby(["quantity", "of"], sort=False).size()
        said = ", ".join(f"{quantity} {of} {count}" for (quantity, of), count in channels.items())
        return f"<umbra.Measurements: {len(table)} rows: {said}>"


def _utc(column):
    """Times without a zone are UTC."""
    import pandas
    column = pandas.to_datetime(column)
    return (column if column.dt.tz is None else column.dt.tz_convert("UTC").dt.tz_localize(None)).to_numpy()


def _numbers(memory, column, kind):
    values = np.ascontiguousarray(column, dtype=np.float64 if kind == "double" else np.intc)
    return memory.keep(ffi.cast(f"{kind} *", ffi.from_buffer(values)), values)


def _texts(memory, column, kind):
    return memory.texts([None if value is None or value != value else str(value) for value in column])


def read_measurements(path, *, session=None):
    """Measurements of a CSV file (docs/files.md)."""
    session = session or _session.default()
    memory = Memory()
    return Measurements(session=session, _handle=session.make("measurements_read", "measurements", memory.text(path)))


def join(measurements, *, session=None):
    """Several measurements as one, each a set: a night, a telescope. A dict says what the sets are called; those of a
    list are called as their files. Effects on clock, exposure and reading are then a matter of each set,
    "zero_point:vis@night1" (docs/diagnosis.md)."""
    named = isinstance(measurements, dict)
    parts = list(measurements.values() if named else measurements)
    memory = Memory()
    session = session or (parts[0]._session if parts else _session.default())
    pointers = memory.new("struct umbra_measurements *[]", [part._handle.pointer for part in parts])
    names = memory.texts(list(measurements)) if named else ffi.NULL
    return Measurements(session=session,
                        _handle=session.make("measurements_join", "measurements", pointers, names, len(parts)))


def synth(scenario, noise, *, floor=0.001, seed=0, temperatures=(), temperature_sigma=0.0, grey_body=False):
    """Measurements made of a scenario as it stands, with Gaussian noise.

    noise, floor        1 sigma: a share of each value, and a share of the band's largest one
    seed                the same seed gives the same noise
    temperatures        places whose temperatures are measured, too; temperature_sigma [K], 0: 0.5
    grey_body           characteristic temperature and infrared cross-section, too, of three thermal bands or more
    """
    memory, session = Memory(), scenario._session
    settings = memory.structure("umbra_synth_settings", noise=noise, floor=floor, seed=seed, place=list(temperatures),
                                temperature_sigma=temperature_sigma, grey_body=int(grey_body))
    return Measurements(session=session,
                        _handle=session.make("synth", "measurements", scenario._handle.pointer, settings, long=True))
