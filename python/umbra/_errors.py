"""Exceptions: one class for each status of umbra.h, each with the one line that the library says."""
from ._c import labels

#: What Python programs catch beside them.
_ALSO = {"INPUT": ValueError, "IO": OSError, "MEMORY": MemoryError, "NUMERIC": ArithmeticError}


class Error(Exception):
    """Umbra could not do it; the message is one line with what is accepted."""


def _classes():
    made = {}
    for status, label in labels("umbra_status").items():
        if not label.startswith("ERR_"):
            continue
        what = label[len("ERR_"):]
        bases = (Error, _ALSO[what]) if what in _ALSO else (Error,)
        name = what.title() + "Error"
        made[status] = type(name, bases, {"__doc__": f"UMBRA_{label} of umbra.h.", "__module__": "umbra"})
    return made


BY_STATUS = _classes()
CLASSES = {made.__name__: made for made in BY_STATUS.values()}
