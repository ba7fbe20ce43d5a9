"""libumbra as it is: umbra.h, read when the package is imported, is the one list of functions,
structures and numbers. Nothing in this package names them a second time."""
import enum
import functools
import os
import pathlib
import re

import cffi

from ._names import Named

HERE = pathlib.Path(__file__).resolve().parent
CLONE = HERE.parents[1]  # where the package is not installed


def _declarations(header):
    """What a C compiler sees of the header: no comments, no lines of the preprocessor."""
    header = re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL).replace("\\\n", " ")
    header = re.sub(r"#ifdef __cplusplus\n.*?#endif", "", header, flags=re.DOTALL)
    return re.sub(r"^\s*#.*$", "", header, flags=re.MULTILINE)


def _header():
    for path in (HERE / "umbra.h", CLONE / "library" / "umbra.h"):
        if path.is_file():
            return path.read_text(encoding="utf-8")
    raise ImportError(f"{HERE}: umbra.h is missing; accepted: a package that pip installed, or a clone of Umbra")


def _open(ffi):
    """UMBRA_LIBRARY, else the library of the package, else that of a clone, else the system's."""
    stated = os.environ.get("UMBRA_LIBRARY")
    names = [stated] if stated else [HERE / "libumbra.so", CLONE / "build" / "libumbra.so", "libumbra.so.0"]
    said = []
    for name in names:
        if isinstance(name, pathlib.Path) and not name.exists():
            said.append(f"{name}: no such file")
            continue
        try:
            # never closed: threads of OpenMP are still in its code when Python ends
            return ffi.dlopen(str(name), ffi.RTLD_NOW | getattr(os, "RTLD_NODELETE", 0))
        except OSError as error:
            said.append(str(error))
    raise ImportError("libumbra is not found, or a library that it needs is missing (tools/install-deps installs them). "
                      "The environment variable UMBRA_LIBRARY may name libumbra.so. Tried:\n  " + "\n  ".join(said))


class Record(Named):
    """What the library says of something: members as umbra.h has them."""

    def __repr__(self):
        return f"Record({', '.join(f'{name}={value!r}' for name, value in vars(self).items())})"


ffi = cffi.FFI()
ffi.cdef(_declarations(_header()))
lib = _open(ffi)
NULL = ffi.NULL


def text(pointer):
    """A text of C; None where there is none."""
    return None if pointer == NULL else ffi.string(pointer).decode()


def message(pointer):
    """What the library says of an error or a refusal, without the command's word for a change."""
    return (text(pointer) or "").removeprefix("--set: ")


def texts(pointer, count):
    return [text(pointer[i]) for i in range(count)]


def labels(name):
    """The names of an enum by number, without what all of them begin with: {0: "OK", 1: "ERR_INPUT" ..}"""
    found = ffi.typeof(f"enum {name}").elements
    prefix = len("UMBRA_")
    return {value: label[prefix:] for value, label in sorted(found.items())}


@functools.lru_cache(maxsize=None)
def numbers(name):
    """An enum of C as one of Python: umbra_verdict_kind as VerdictKind."""
    made = "".join(word.title() for word in name.split("_")[1:])
    return enum.IntEnum(made, {label: value for value, label in labels(name).items()}, module="umbra")


def record(structure):
    """A structure that the library returned, as an object: texts, numbers, enums, and lists where a member `x` has a
    count `nx` beside it (or ends with NULL). Everything is copied."""
    members = dict(ffi.typeof(structure).fields)
    out = Record()
    for name, member in members.items():
        if name[0] == "n" and name[1:] in members:
            continue
        value, kind = getattr(structure, name), member.type
        if kind.kind == "enum":
            value = numbers(kind.cname.split()[-1])(value)
        elif kind.cname == "char *":
            value = text(value)
        elif kind.kind == "pointer":
            value = [_element(value[i], kind.item) for i in range(_count(structure, name, value, members))]
        out.__dict__[name] = value
    return out


def _element(value, kind):
    return text(value) if kind.cname == "char *" else record(value) if kind.kind == "struct" else value


def _count(structure, name, pointer, members):
    if "n" + name in members:
        return getattr(structure, "n" + name)
    n = 0
    while pointer != NULL and pointer[n] != NULL:
        n += 1
    return n


class Memory:
    """Structures for one call: what they point to lives as long as this does."""

    def __init__(self):
        self._kept = []

    def new(self, kind, value=None):
        made = ffi.new(kind, value) if value is not None else ffi.new(kind)
        self._kept.append(made)
        return made

    def keep(self, made, *others):
        self._kept += [made, *others]
        return made

    def text(self, value):
        return NULL if value is None else self.new("char[]", os.fsencode(value))

    def texts(self, values):
        return self.new("char *[]", [self.text(value) for value in values]) if len(values) else NULL

    def numbers(self, values):
        return self.new("double[]", [float(value) for value in values]) if len(values) else NULL

    def structure(self, name, **members):
        """A structure that a caller fills, its size stated; texts and lists of texts are converted."""
        made = self.new(f"struct {name} *")
        self.fill(made[0], **members)
        return made

    def fill(self, made, **members):
        """The same of an element of an array."""
        made.size = ffi.sizeof(made)
        for member, value in members.items():
            if isinstance(value, (str, os.PathLike)):
                value = self.text(value)
            elif isinstance(value, (list, tuple)):
                if hasattr(made, "n" + member):
                    setattr(made, "n" + member, len(value))
                value = self.texts(value)
            if value is not None:
                setattr(made, member, value)
