# SPDX-License-Identifier: BSD-3-Clause
"""The functions of libslalom (slalom.h), called by ctypes, so that they serve every version of Python."""

from __future__ import annotations

import ctypes
import functools
import json
import os
import sys
import weakref
from ctypes import c_char_p, c_double, c_int, c_size_t, c_uint32, c_uint64, c_void_p
from typing import Any, Callable, List, Optional, Sequence, Tuple

from . import _classes

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]

_ABI_VERSION = 1


class Error(ValueError):
    """What is invalid or failed, where, and what was expected."""


#: Called with a context, a phase, and the number of its steps that are done, and in total.
PROGRESS = ctypes.PYFUNCTYPE(c_int, c_void_p, c_char_p, c_size_t, c_size_t)


#: Called with a context, the name of a scenario and a seed.
FAMILY = ctypes.PYFUNCTYPE(c_int, c_void_p, c_char_p, c_uint64)


class _Host(ctypes.Structure):
    """Functions of this interpreter in the order of slalom_host."""

    _names = (
        ("interrupted", "PyErr_CheckSignals"),
        ("put_aside", "PyErr_Fetch"),
        ("raise_again", "PyErr_Restore"),
        ("holds_lock", "PyGILState_Check"),
        ("before_fork", "PyOS_BeforeFork"),
        ("after_fork_in_parent", "PyOS_AfterFork_Parent"),
        ("after_fork_in_child", "PyOS_AfterFork_Child"),
        ("unlock", "PyEval_SaveThread"),
        ("lock", "PyEval_RestoreThread"),
        ("enter", "PyGILState_Ensure"),
        ("leave", "PyGILState_Release"),
    )
    _fields_ = [(name, c_void_p) for name, _ in _names]


#: Results: a text is "owned", an object or an array "new"; NULL, or an int other than 0, is a failure.
_FUNCTIONS = {
    "slalom_library_abi_version": (c_uint32, ()),
    "slalom_version": (c_char_p, ()),
    "slalom_error": (c_char_p, ()),
    "slalom_free": (None, (c_void_p,)),
    "slalom_reply": (None, (c_char_p,)),
    "slalom_stop": (None, ()),
    "slalom_set_host": (None, (ctypes.POINTER(_Host),)),
    "slalom_scenarios_new": ("new", ()),
    "slalom_scenarios_free": (None, (c_void_p,)),
    "slalom_scenarios_read": ("new", (c_char_p,)),
    "slalom_scenarios_from_yaml": ("new", (c_char_p,)),
    "slalom_scenarios_generate": ("new", (c_char_p, c_int, c_uint64, c_int, c_char_p, PROGRESS, c_void_p)),
    "slalom_scenarios_generate_own": (
        "new",
        (c_char_p, FAMILY, c_int, c_uint64, c_int, c_char_p, PROGRESS, c_void_p),
    ),
    "slalom_scenarios_add": (c_int, (c_void_p, c_void_p, c_size_t)),
    "slalom_scenarios_size": (c_size_t, (c_void_p,)),
    "slalom_scenarios_write": (c_int, (c_void_p, c_char_p)),
    "slalom_scenario_json": ("owned", (c_void_p, c_size_t)),
    "slalom_scenario_yaml": ("owned", (c_void_p, c_size_t)),
    "slalom_scenario_svg": ("owned", (c_void_p, c_size_t)),
    "slalom_scenario_occupancy": ("new", (c_void_p, c_size_t, c_double, c_void_p, c_void_p)),
    "slalom_evaluate": ("new", (c_char_p, c_void_p, c_void_p, c_char_p, PROGRESS, c_void_p)),
    "slalom_results_read": ("new", (c_char_p,)),
    "slalom_results_free": (None, (c_void_p,)),
    "slalom_results_size": (c_size_t, (c_void_p,)),
    "slalom_results_json": ("owned", (c_void_p,)),
    "slalom_results_numbers": ("new", (c_void_p, c_char_p)),
    "slalom_results_trajectory": ("new", (c_void_p, c_size_t, c_void_p)),
    "slalom_results_scenarios": ("new", (c_void_p,)),
    "slalom_results_add": ("new", (c_void_p, c_char_p, c_char_p)),
    "slalom_results_html": ("owned", (c_void_p,)),
    "slalom_results_summary": ("owned", (c_void_p,)),
    "slalom_results_table": ("owned", (c_void_p, c_char_p, c_char_p, c_double)),
    "slalom_results_save": (c_int, (c_void_p, c_char_p)),
    "slalom_certify": ("owned", (c_char_p, c_char_p, c_char_p, c_void_p, c_char_p, c_int, c_char_p)),
}


def _shipped_folders() -> List[str]:
    """Where Slalom's libraries may be: in a wheel, built, installed."""
    package = os.path.dirname(os.path.abspath(__file__))
    multiarch = getattr(sys.implementation, "_multiarch", "")
    folders = ("bundle/lib/slalom", "../../slalom", "../../../slalom", f"../../../{multiarch}/slalom")
    return [os.path.abspath(os.path.join(package, folder)) for folder in folders]


def find_library(library: str) -> str:
    """The path of a library: as given, or in the folders where Slalom's methods are."""
    for folder in ("", *_shipped_folders()):
        path = os.path.abspath(os.path.join(folder, library))
        if os.path.isfile(path):
            return path
    return library


@functools.lru_cache(maxsize=None)
def load() -> ctypes.PyDLL:
    """The library, which holds the interpreter's lock. Raises ImportError."""
    path = find_library("runtime/libslalom.so")
    try:
        library = ctypes.PyDLL(path)
    except OSError as error:
        raise ImportError(f"slalom: {error}; expected glibc 2.35 or newer and a whole installation of Slalom") from None
    for name, (result, parameters) in _FUNCTIONS.items():
        function = getattr(library, name)
        function.argtypes = parameters
        function.restype = c_void_p if result in ("new", "owned") else result
        function.errcheck = _CHECKS.get(result, _unchecked)
    if library.slalom_library_abi_version() != _ABI_VERSION:
        raise ImportError(f"slalom: {path} is of another version; expected one of {_ABI_VERSION}")
    addresses = (ctypes.cast(getattr(ctypes.pythonapi, name), c_void_p) for _, name in _Host._names)
    library.slalom_set_host(ctypes.byref(_Host(*addresses)))
    return library


def _unchecked(result: Any, _function: Any, _arguments: Any) -> Any:
    return result


def _checked_pointer(result: Optional[int], _function: Any, _arguments: Any) -> int:
    if result is None:
        raise Error(load().slalom_error().decode())
    return result


def _checked_status(result: int, _function: Any, _arguments: Any) -> None:
    if result != 0:
        raise Error(load().slalom_error().decode())


def _taken_text(result: Optional[int], function: Any, arguments: Any) -> str:
    address = _checked_pointer(result, function, arguments)
    try:
        return ctypes.string_at(address).decode()
    finally:
        load().slalom_free(address)


_CHECKS = {"new": _checked_pointer, "owned": _taken_text, c_int: _checked_status}


class Handle:
    """An object of the library, freed with the last reference."""

    def __init__(self, address: int, free: str) -> None:
        self._as_parameter_ = address
        weakref.finalize(self, getattr(load(), free), address)

    def __reduce__(self) -> Any:
        raise TypeError("an object of libslalom cannot be pickled or copied")


def taken_array(address: int, code: str, shape: Tuple[int, ...]) -> Any:
    """The values at an address, which is freed: an array of NumPy, or without it a memoryview."""
    count = functools.reduce(lambda a, b: a * b, shape, 1)
    item = {"d": c_double, "?": ctypes.c_bool}[code]
    values = bytearray(ctypes.string_at(address, count * ctypes.sizeof(item)))
    load().slalom_free(address)
    if numpy is not None:
        return numpy.frombuffer(values, dtype=code).reshape(shape)
    return memoryview(values).cast(code, shape) if count > 0 else memoryview(values).cast(code)


def to_json(value: Any) -> bytes:
    return json.dumps(value).encode()


def reply(text: str) -> None:
    """Answers a call of the library."""
    load().slalom_reply(text.encode(errors="replace").replace(b"\0", b" "))


def to_section(values: Any, where: str) -> dict:
    """{KEY: TEXT} of a dict. Raises Error."""
    if not isinstance(values, dict):
        raise Error(f"{where}: {values!r} is not a dict; expected {{KEY: VALUE, ...}}")
    try:
        return {str(key): _classes.to_text(value, f"{where} {key}") for key, value in values.items()}
    except _classes.Invalid as error:
        raise Error(str(error)) from None


def to_settings(sections: dict) -> dict:
    """The sections that are given, as texts. Raises Error."""
    return {name: to_section(values, name) for name, values in sections.items() if values is not None}


def whole(name: str, number: Any, low: int, high: int) -> int:
    """The number. Raises Error for another than an integer of [low, high]."""
    if not hasattr(number, "__index__") or not low <= number <= high:
        raise Error(f"{name}: {number!r} is not valid; expected an integer in [{low}, {high}]")
    return int(number)


class Call:
    """A call of the library, with a function for progress. What functions that it calls raise is raised when it has
    ended."""

    active: Optional[Call] = None

    def __init__(self, progress: Optional[Callable[[str, int, int], None]] = None) -> None:
        self.raised: Optional[BaseException] = None
        self.report = PROGRESS()

        def report(_context: Any, phase: bytes, done: int, total: int) -> int:
            try:
                progress(phase.decode(), done, total)
            except BaseException as error:
                self.raised = error
            return self.raised is not None

        if progress is not None:
            self.report = PROGRESS(report)

    def stop(self, error: BaseException) -> None:
        self.raised = error
        load().slalom_stop()

    def __enter__(self) -> Call:
        self._outer, Call.active = Call.active, self
        self._hook, sys.unraisablehook = sys.unraisablehook, self._unraisable
        return self

    def _unraisable(self, what: Any) -> None:
        # Python handles signals before the first line of a function, where ctypes would drop the exception.
        if isinstance(what.exc_value, KeyboardInterrupt):
            self.stop(what.exc_value)
        else:
            self._hook(what)

    def __exit__(self, *_: Any) -> None:
        sys.unraisablehook = self._hook
        Call.active = self._outer
        if self.raised is not None:
            raise self.raised from None
