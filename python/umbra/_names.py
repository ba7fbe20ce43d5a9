"""Names that a user types: a wrong one raises and names the nearest."""
import difflib


def hint(name, known):
    """What a message says of a name that is not among those that are known."""
    known = sorted(known)
    near = difflib.get_close_matches(str(name), known, 1, 0.4)
    if near:
        return f"did you mean {near[0]}?"
    return "accepted: " + ", ".join(known) if 0 < len(known) <= 12 else f"{len(known)} names are known"


class Named:
    """An object whose wrong attributes are refused with the nearest name, read or set."""

    def __getattr__(self, name):
        if name.startswith("_"):  # what Python itself asks for
            raise AttributeError(name)
        raise AttributeError(f"{type(self).__name__} has no '{name}'; {hint(name, self._public())}")

    def __setattr__(self, name, value):
        if not name.startswith("_") and name not in dir(type(self)):
            raise AttributeError(f"{type(self).__name__} has no '{name}'; {hint(name, self._public())}")
        object.__setattr__(self, name, value)

    def _public(self):
        return [name for name in dir(self) if not name.startswith("_")]
