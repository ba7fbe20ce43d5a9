"""Sessions: calls into the library, their errors, Ctrl-C, progress, warnings."""
import collections
import contextlib
import logging
import os
import signal
import sys
import threading
import time
import warnings
import weakref

from ._c import CLONE, HERE, NULL, Memory, ffi, lib, message, numbers, text
from ._errors import BY_STATUS, Error

LOG = logging.getLogger("umbra")
Level = numbers("umbra_log_level")
_LEVELS = {Level.LOG_DEBUG: logging.DEBUG, Level.LOG_INFO: logging.INFO, Level.LOG_ERROR: logging.ERROR}


class UmbraWarning(UserWarning):
    """What the program warns of."""


class Bar:
    """A line of progress on a stream, for one that is watched."""

    def __init__(self, stream=None):
        self._stream, self._said, self._shown = stream, 0.0, 0

    def __call__(self, task, done, total):
        now, whole = time.monotonic(), total and done >= total
        if now - self._said < 0.1 and not whole:
            return
        self._said = now
        self._put(f"{task}: {100 * done // total} %" if total else f"{task} ...")

    def clear(self):
        if self._shown:
            self._put("")

    def _put(self, line):
        stream = self._stream or sys.stderr
        stream.write("\r" + line.ljust(self._shown) + ("\r" if not line else ""))
        stream.flush()
        self._shown = len(line)


class Handle:
    """An object of the library, closed when nothing needs it any more."""

    def __init__(self, session, pointer, close):
        self.session, self.pointer = session, pointer
        weakref.finalize(self, session.bury, pointer, close)


class Session:
    """Settings of the library, and its calls. Most programs never make one: there is one for all, which
    `umbra.configure` sets up. One call at a time runs in a session; threads that compute side by side have one each.

    data      folder with materials/, scenarios/ ...; default: UMBRA_DATA, else what came with the package
    cache     folder where view factors are kept between runs; default: UMBRA_CACHE, else none
    threads   that a call computes with; 0: all. Above 1 many variants are computed by forked processes
    progress  function of (task, done, total), total 0 where nobody knows; True: a line on standard error;
              None: such a line where standard error is a terminal; False: nothing
    """

    def __init__(self, *, data=None, cache=None, threads=0, progress=None):
        self._lock, self._owner, self._dead = threading.Lock(), None, collections.deque()
        self._raised, self._warned = None, []
        if progress is None:
            progress = sys.stderr is not None and sys.stderr.isatty()
        self.progress = Bar() if progress is True else progress or None
        own = HERE / "data"
        if data is None and "UMBRA_DATA" not in os.environ and own.is_dir():
            data = own
        self.data = os.fspath(data) if data else os.environ.get("UMBRA_DATA") or os.fspath(CLONE)
        self._log = ffi.callback("void(void *, enum umbra_log_level, const char *)", self._hear, onerror=self._keep)
        self._step = ffi.callback("int(void *, const char *, size_t, size_t)", self._tell, error=0, onerror=self._keep)
        memory, out = Memory(), ffi.new("struct umbra **")
        settings = memory.structure("umbra_settings", data=data, cache=cache or os.environ.get("UMBRA_CACHE") or None,
                                    threads=threads, log=self._log, progress=self._step)
        status = lib.umbra_open(settings, out)
        if status != 0:
            raise BY_STATUS[status]("no session of libumbra can be opened")
        self.pointer = out[0]
        weakref.finalize(self, _close, lib.umbra_close, self.pointer, (self._log, self._step))

    # --- what C calls ------------------------------------------------------------------------------------------------

    def _hear(self, _, level, line):
        if level == Level.LOG_WARNING:
            self._warned.append(text(line))
        else:
            LOG.log(_LEVELS[level], "%s", text(line))

    def _tell(self, _, task, done, total):
        if self.progress is not None:
            self.progress(text(task), done, total)
        return 1

    def _keep(self, kind, error, trace):
        """An exception in a function of the user ends the work, and is raised when the call returns."""
        self._raised = error
        lib.umbra_interrupt(self.pointer)

    # --- calls -------------------------------------------------------------------------------------------------------

    @contextlib.contextmanager
    def _turn(self):
        if self._owner == threading.get_ident():
            raise Error("a call of Umbra inside of its own callback; accepted: another session")
        with self._lock:
            self._owner = threading.get_ident()
            try:
                self._sweep()
                self._raised, self._warned = None, []
                yield
            finally:
                self._owner = None

    def call(self, name, *arguments):
        """A function of umbra.h by its name without "umbra_", that returns a status, with the session before its
        arguments."""
        with self._turn():
            self._end(getattr(lib, "umbra_" + name)(self.pointer, *arguments))

    def work(self, name, *arguments):
        """The same of one that may last: Ctrl-C ends it."""
        with self._turn(), _listening(self.pointer):
            try:
                status = getattr(lib, "umbra_" + name)(self.pointer, *arguments)
            finally:
                if isinstance(self.progress, Bar):
                    self.progress.clear()
            self._end(status)

    def make(self, name, kind, *arguments, long=False):
        """The object that such a function makes; its last argument."""
        out = ffi.new(f"struct umbra_{kind} **")
        (self.work if long else self.call)(name, *arguments, out)
        return Handle(self, out[0], getattr(lib, f"umbra_{kind}_close"))

    def _end(self, status):
        raised, self._raised = self._raised, None
        warned, self._warned = self._warned, []
        for line in warned:
            warnings.warn(line, UmbraWarning, stacklevel=_level())
        if raised is not None:
            raise raised
        if status != 0:
            raise BY_STATUS.get(status, Error)(message(lib.umbra_message(self.pointer)))

    # --- ends --------------------------------------------------------------------------------------------------------

    def bury(self, pointer, close):
        """Close an object, now or before the next call: the collector may come by in the midst of one."""
        self._dead.append((pointer, close))
        if self._lock.acquire(blocking=False):
            try:
                self._sweep()
            finally:
                self._lock.release()

    def _sweep(self):
        while self._dead:
            pointer, close = self._dead.popleft()
            _close(close, pointer, None)


def _close(close, pointer, _):
    """_: what has to live until then."""
    close(ffi.new(f"{ffi.typeof(pointer).cname}*", pointer))


def _level():
    """How far above the caller the first line stands that is not of this package."""
    frame, level = sys._getframe(1), 1
    while frame.f_back is not None and frame.f_code.co_filename.startswith(str(HERE)):
        frame, level = frame.f_back, level + 1
    return level


@contextlib.contextmanager
def _listening(pointer):
    """Python's own handlers of signals wait until C returns. Its wakeup pipe does not: a thread reads there that
    Ctrl-C was pressed, and has the library return. Signals are for the main thread alone."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    reading, writing = os.pipe()
    os.set_blocking(writing, False)
    before = signal.set_wakeup_fd(writing, warn_on_full_buffer=False)

    def listen():
        while True:
            heard = os.read(reading, 64)
            told = heard.rstrip(b"\0")
            if before >= 0 and told:  # somebody else's, such as an event loop's
                os.write(before, told)
            if signal.SIGINT in told and callable(signal.getsignal(signal.SIGINT)):
                lib.umbra_interrupt(pointer)
            if told != heard:
                return

    thread = threading.Thread(target=listen, name="umbra-signals", daemon=True)
    thread.start()
    try:
        yield
    finally:
        signal.set_wakeup_fd(before)
        os.write(writing, b"\0")
        thread.join()
        os.close(reading)
        os.close(writing)


_default = None


def default():
    """The session of those who made none."""
    global _default
    if _default is None:
        _default = Session()
    return _default


def configure(**settings):
    """Begin anew with other settings, those of `umbra.Session`: what was made before keeps its own."""
    global _default
    _default = Session(**settings)


def _forget():
    global _default
    _default = None


os.register_at_fork(after_in_child=_forget)  # a forked child opens its own
