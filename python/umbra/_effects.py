"""Effects as classes, made from what the library says of them when they are asked for."""
import inspect
import types

from . import _session
from ._c import Memory, ffi, labels, lib, record
from ._names import Named, hint


def _accepts(parameter):
    limits = f"{parameter.minimum:g} to {parameter.maximum:g}"
    return limits if parameter.unit == "1" else f"{limits} {parameter.unit}"


def _doc(said):
    lines = [said.summary + ".", ""]
    targets = [label[len("TARGET_"):].lower() for bit, label in labels("umbra_target").items() if said.targets & bit]
    lines += [f"Acts on: {', '.join(targets)}." + (" On unless a scenario turns it off." if said.on_by_default else "")]
    if said.parameter:
        lines += ["", "Parameters"]
    for p in said.parameter:
        lines.append(f"    {p.name}: {p.help}; {_accepts(p)}, default {p.default_value:g}, vanishes at {p.null_value:g}")
    lines += ["", f"Valid for: {said.validity}", f"Reference: {said.reference}"]
    if said.separated_by:
        lines.append(f"Told apart from {said.separated_by}")
    return "\n".join(lines)


class Effect(Named):
    """A physical effect with its target and the values of its parameters; those that are not given keep what the
    scenario says, or their defaults. `umbra.effects` has one class for each."""

    name = None  #: as scenarios call it
    about = None  #: what the library says of it, as umbra.h's struct umbra_effect
    parameters = types.MappingProxyType({})  #: by name

    def __init__(self, target=None, **values):
        if type(self) is Effect:
            raise TypeError("an effect is one of umbra.effects; see dir(umbra.effects)")
        for name in values:
            if name not in self.parameters:
                raise TypeError(f"{self.name} has no parameter '{name}'; {hint(name, self.parameters)}")
        self._target, self._values, self._off = target, {n: float(v) for n, v in values.items()}, False

    @classmethod
    def off(cls, target=None):
        """The effect turned off: on that target, or everywhere."""
        made = cls(target)
        made._off = True
        return made

    @property
    def target(self):
        """What it acts on; None: everything."""
        return self._target

    @property
    def values(self):
        """Values of parameters that were given, by name."""
        return dict(self._values)

    def __getattr__(self, name):
        if not name.startswith("_") and name in type(self).parameters:
            return self._values.get(name, type(self).parameters[name].default_value)
        return super().__getattr__(name)

    def __setattr__(self, name, value):
        if name in type(self).parameters:
            self._values[name] = float(value)
        else:
            super().__setattr__(name, value)

    def __dir__(self):
        return [*super().__dir__(), *self.parameters]

    def __repr__(self):
        said = [repr(self._target)] if self._target is not None else []
        said += [f"{name}={value:g}" for name, value in self._values.items()]
        return f"umbra.effects.{self.name}{'.off' if self._off else ''}({', '.join(said)})"

    def _change(self, memory):
        """struct umbra_effect_change."""
        return memory.structure("umbra_effect_change", effect=self.name, target=self._target, off=int(self._off),
                                parameter=list(self._values), value=memory.numbers(list(self._values.values())))


def _class(pointer):
    said = record(pointer[0])
    made = type(said.name, (Effect,), {"__doc__": _doc(said), "__module__": "umbra.effects", "name": said.name,
                                       "about": said})
    made.parameters = types.MappingProxyType({p.name: p for p in said.parameter})
    kinds = inspect.Parameter
    made.__signature__ = inspect.Signature(
        [kinds("target", kinds.POSITIONAL_OR_KEYWORD, default=None)]
        + [kinds(p.name, kinds.KEYWORD_ONLY, default=p.default_value) for p in said.parameter])
    return made


class Effects:
    """The effects there are, those that were loaded among them: `umbra.effects.emittance("mli")` makes one,
    `help(umbra.effects.emittance)` tells of it, `list(umbra.effects)` has their names."""

    def __init__(self):
        self._made = {}

    def _classes(self):
        session = _session.default()
        index = len(self._made) if self._made.get("") is session else 0
        if index == 0:
            self._made = {"": session}
            index = 1
        while True:
            pointer = lib.umbra_effect_at(session.pointer, index - 1)
            if pointer == ffi.NULL:
                return {name: made for name, made in self._made.items() if name}
            made = _class(pointer)
            self._made[made.name] = made
            index += 1

    def load(self, path):
        """Effects of one's own, from a shared object; its code runs inside this process. Names of what was added."""
        before = set(self._classes())
        memory = Memory()
        _session.default().call("effects_load", memory.text(path))
        return [name for name in self._classes() if name not in before]

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        known = self._classes()
        if name not in known:
            raise AttributeError(f"there is no effect '{name}'; {hint(name, known)}")
        return known[name]

    __getitem__ = __getattr__

    def __iter__(self):
        return iter(self._classes())

    def __len__(self):
        return len(self._classes())

    def __contains__(self, name):
        return name in self._classes()

    def __dir__(self):
        return ["load", *self._classes()]


effects = Effects()
