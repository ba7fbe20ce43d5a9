"""Many points: studies and forecasts, into folders and as tables."""
import collections
import os
import tempfile
import warnings

import numpy as np

from . import _session
from ._arrays import posix
from ._c import Memory, ffi

Forecast = collections.namedtuple("Forecast", "passes curves contributions")
Forecast.__doc__ = """Tables of a forecast (docs/files.md), as pandas.DataFrame: a row a pass; curves of each pass; what
each uncertain parameter does to each pass, None where nothing is uncertain."""


def _folder(folder):
    """A context with the folder of results: the user's, or one that goes with it."""
    class Own(tempfile.TemporaryDirectory):
        def __enter__(self):
            return os.path.join(super().__enter__(), "results")

    class Given:
        def __enter__(self):
            return os.fspath(folder)

        def __exit__(self, *_):
            return False

    return Own(prefix="umbra-") if folder is None else Given()


def _run(session, name, *arguments, **points):
    """Call umbra_study or umbra_forecast, whose last arguments are points and missing."""
    memory, missing = Memory(), ffi.new("size_t *")
    session.work(name, *arguments, memory.structure("umbra_points", **points), missing)
    if missing[0] and not points.get("nshare"):
        warnings.warn(f"{missing[0]} points are missing, since their processes died; resume=True computes them",
                      _session.UmbraWarning, stacklevel=3)


def _share(path, measured, points):
    """What an executor runs: one share of a study, with one thread, in whatever process this is."""
    memory = Memory()
    _run(_session.Session(threads=1, progress=False), "study", memory.text(path), memory.text(measured), **points)


def study(path, folder=None, *, measured=None, workers=0, executor=None, tasks=None, resume=False, force=False,
          pictures=False):
    """Run the study of a file (docs/files.md): an xarray.Dataset, the content of study.nc.

    folder    of the results, tables among them; None: none is kept
    measured  measurements that points are held against, in place of those that the file names
    workers   processes of this machine that compute; 0: as many as the session has threads
    executor  what computes in place of workers: a concurrent.futures executor, mpi4py's MPIPoolExecutor, a Dask
              client, or anything with submit(function, ..).result(). Each of its `tasks` (its own number of workers,
              else the number of processors) computes a share; points lie in `folder`.points, which all must see
    resume    take the points that are on record; force: also in place of a folder that Umbra did not write
    """
    import xarray
    path, measured = os.path.abspath(path), None if measured is None else os.path.abspath(measured)
    memory = Memory()
    with _folder(folder) as into:
        into = os.path.abspath(into)
        if executor is not None:
            count = tasks or getattr(executor, "_max_workers", None) or os.cpu_count()
            shares = [{"folder": into, "workers": 1, "force": int(force), "resume": int(resume), "share": k + 1,
                       "nshare": count} for k in range(count)]
            for future in [executor.submit(_share, path, measured, share) for share in shares]:
                future.result()
            workers, resume = 1, True
        _run(_session.default(), "study", memory.text(path), memory.text(measured), folder=into, workers=workers,
             resume=int(resume), force=int(force), pictures=int(pictures))
        return xarray.load_dataset(os.path.join(into, "study.nc"))


def forecast(scenario, folder=None, *, days=1.0, start=None, stations=(), minimum_elevation=0.0, uncertain=(),
             workers=0, resume=False, force=False, pictures=False):
    """Passes to come, with what is seen of them: a Forecast of tables.

    folder             of the results, a calendar among them; None: none is kept
    start              datetime64 in UTC; None: the scenario's start
    stations           {name: (north [deg], east [deg], height [m])}; none: the scenario's
    minimum_elevation  of culminations [deg]; 0: the scenario's
    uncertain          "effect[:target],parameter=sigma" or "key=sigma": error bars by these
    """
    import pandas
    memory, session = Memory(), scenario._session
    given = [(memory.text(name), *place) for name, place in dict(stations).items()]
    settings = memory.structure(
        "umbra_forecast_settings", days=days, minimum_elevation_deg=minimum_elevation, uncertain=list(uncertain),
        from_unix_s=0.0 if start is None else float(posix(np.datetime64(start))),
        station=memory.new("struct umbra_station[]", given) if given else None, nstation=len(given))
    with _folder(folder) as into:
        _run(session, "forecast", scenario._handle.pointer, settings, folder=into, workers=workers,
             resume=int(resume), force=int(force), pictures=int(pictures))
        tables = []
        for name in Forecast._fields:
            path = os.path.join(into, name + ".csv")
            tables.append(_times(pandas.read_csv(path)) if os.path.exists(path) else None)
    return Forecast(*tables)


def _times(table):
    import pandas
    for name in table.columns:
        if name.endswith("_utc"):
            table[name] = pandas.to_datetime(table[name], utc=True).dt.tz_localize(None)
    return table
