"""Umbra: what a telescope sees of a satellite, in the visible and the thermal infrared.

    import umbra
    s = umbra.Scenario("envisat-graz-2016")            # umbra.scenarios() has the names; a path is good, too
    s["parts.bus.interior.power_W"] = 50               # umbra.keys tells what may be stated
    s.add(umbra.effects.emittance("cell_silicon"))     # dir(umbra.effects), help(umbra.effects.emittance)
    r = s.run()
    r.irradiance.sel(band="lwir").plot()               # xarray, without a copy
    r.write("out")
    print(umbra.cite(r).sentence)

Classes, texts and numbers are those of umbra.h and of the descriptors of effects and keys that the library has when it
is loaded; nothing is written down a second time.
"""
from . import _errors
from ._c import lib as _lib
from ._c import numbers as _numbers
from ._c import text as _text
from ._effects import Effect, effects
from ._keys import find_scenario, keys, materials, scenarios, sensors
from ._measurements import Measurements, join, read_measurements, synth
from ._points import Forecast, forecast, study
from ._result import Citation, Comparison, Diagnosis, Result, Sensitivity, cite
from ._scenario import Scenario
from ._session import Bar, Session, UmbraWarning, configure

__version__ = _text(_lib.umbra_version())
Error = _errors.Error
Confidence = _numbers("umbra_confidence")  # how sure a finding is
VerdictKind = _numbers("umbra_verdict_kind")  # what a diagnosis or a fit ends with
globals().update(_errors.CLASSES)  # InputError, IoError ...: one for each status

__all__ = sorted(name for name in globals() if not name.startswith("_"))
