"""Arrays of a result as NumPy has them, without a copy, and with names as xarray has them."""
import numpy as np
import xarray as xr

from ._c import ffi, lib, text


def view(array, owner):
    """The numbers of a struct umbra_array, read-only; `owner` lives as long as they are looked at."""
    shape = tuple(array.shape[i] for i in range(array.dimensions))
    count = int(np.prod(shape, dtype=np.intp))
    if count == 0:
        return np.empty(shape)
    kept = ffi.gc(array.data, lambda _, owner=owner: None)
    out = np.frombuffer(ffi.buffer(kept, 8 * count), dtype=np.float64).reshape(shape)
    out.flags.writeable = False
    return out


def axes(array):
    return tuple(text(array.axis[i]) for i in range(array.dimensions))


def listed(pointer):
    """The arrays of a result by name."""
    out, index = {}, 0
    while (array := lib.umbra_result_array_at(pointer, index)) != ffi.NULL:
        out[text(array.name)] = array
        index += 1
    return out


def times(unix):
    """POSIX seconds as datetime64, to the microsecond that a double has of them."""
    unix = np.asarray(unix, dtype=float)
    out = np.full(unix.shape, np.datetime64("NaT"), dtype="datetime64[us]")
    known = np.isfinite(unix)
    out[known] = np.round(unix[known] * 1e6).astype("int64").astype("datetime64[us]")
    return out.astype("datetime64[ns]")


def posix(times_utc):
    """The other way round; NaN of what is no time."""
    stamps = np.asarray(times_utc, dtype="datetime64[ns]")
    return np.where(np.isnat(stamps), np.nan, stamps.astype("int64") / 1e9)


def data_array(array, owner, coordinates):
    """coordinates: of axes by name; what has another length than the axis is left out."""
    values, dims = view(array, owner), axes(array)
    coords = {}
    for name, (dim, labels) in coordinates.items():
        if dim in dims and len(labels) == values.shape[dims.index(dim)]:
            coords[name] = (dim, labels)
    unit = text(array.unit)
    return xr.DataArray(values, dims=dims, coords=coords, name=text(array.name), attrs={"units": unit})
