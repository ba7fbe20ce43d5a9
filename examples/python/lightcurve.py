"""Runs a scenario and prints its light curve: python3 lightcurve.py LIBUMBRA.so SCENARIO"""
import ctypes as c
import sys


class Array(c.Structure):  # struct umbra_array
    _fields_ = [("name", c.c_char_p), ("unit", c.c_char_p), ("dimensions", c.c_size_t),
                ("shape", c.c_size_t * 4), ("axis", c.c_char_p * 4), ("data", c.POINTER(c.c_double))]


library = c.CDLL(sys.argv[1])
library.umbra_message.restype = c.c_char_p
library.umbra_result_array.restype = c.POINTER(Array)
umbra, scenario, model, result = (c.c_void_p() for _ in range(4))


def call(name, *arguments):
    if getattr(library, "umbra_" + name)(*arguments) != 0:
        sys.exit(library.umbra_message(umbra).decode() if umbra else "no session")


def array(name):
    return library.umbra_result_array(result, name.encode()).contents


call("open", None, c.byref(umbra))
call("scenario_read", umbra, sys.argv[2].encode(), None, c.byref(scenario))
call("model_build", umbra, scenario, c.byref(model))
call("run", umbra, model, c.byref(result))
names, bands = c.POINTER(c.c_char_p)(), c.c_size_t()
call("model_names", umbra, model, 3, c.byref(names), c.byref(bands))  # UMBRA_BANDS
time, light = array("time_unix_s"), array("intensity")
print(time.name.decode(), *(f"{names[b].decode()}_intensity [{light.unit.decode()}]" for b in range(bands.value)), sep=",")
for k in range(time.shape[0]):
    print(f"{time.data[k]:.3f}", *(f"{light.data[k * bands.value + b]:.9g}" for b in range(bands.value)), sep=",")
for kind, handle in (("result", result), ("model", model), ("scenario", scenario)):
    getattr(library, f"umbra_{kind}_close")(c.byref(handle))
library.umbra_close(c.byref(umbra))
