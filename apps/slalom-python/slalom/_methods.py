# SPDX-License-Identifier: BSD-3-Clause
"""Classes as methods of libslalom: slalom_own_methods of slalom.h."""

from __future__ import annotations

import contextlib
import copy
import ctypes
import itertools
import json
import os
import types
from ctypes import POINTER, c_char_p, c_double, c_float, c_int, c_int32, c_size_t, c_uint64, c_void_p
from typing import Any, Dict, Iterator, List, Mapping, Tuple

from . import _classes
from ._library import Call, Error, numpy, reply, to_section


class _Robot(ctypes.Structure):
    _fields_ = [
        *((name, c_double) for name in ("radius", "max_v", "max_w", "max_accel_v", "max_accel_w")),
        ("forward_only", c_int),
        ("rays", c_int),
        ("aperture", c_double),
        ("max_range", c_double),
        ("holonomic", c_int),
        ("corners", POINTER(c_double)),
        ("corner_count", c_size_t),
    ]


class _Task(ctypes.Structure):
    _numbers = ("start_x", "start_y", "start_phi", "goal_x", "goal_y", "goal_tolerance", "control_period")
    _fields_ = [*((name, c_double) for name in _numbers), ("seed", c_uint64)]


class _Map(ctypes.Structure):
    _fields_ = [
        *((name, c_double) for name in ("resolution", "origin_x", "origin_y")),
        ("size_x", c_size_t),
        ("size_y", c_size_t),
        ("cells", c_void_p),
    ]


class _Track(ctypes.Structure):
    _numbers = ("x", "y", "vx", "vy", "radius")
    _fields_ = [("id", c_int32), *((name, c_double) for name in _numbers)]


class _Observation(ctypes.Structure):
    _fields_ = [("numbers", c_double * 9), ("ranges", c_void_p), ("rays", c_size_t)]


def _described_robot(given: _Robot) -> types.SimpleNamespace:
    """The robot and its sensor, with the names of slalom_method.h."""
    numbers = {name: getattr(given, name) for name, _ in _Robot._fields_[:-2]}
    numbers.update(forward_only=bool(given.forward_only), holonomic=bool(given.holonomic))
    corners = [(given.corners[2 * i], given.corners[2 * i + 1]) for i in range(given.corner_count)]
    return types.SimpleNamespace(footprint=corners, **numbers)


def _view(address: int, code: str, shape: Tuple[int, ...], writable: bool = False) -> Any:
    """Memory of the library: an array of NumPy, or without it a memoryview."""
    item = {"d": c_double, "f": c_float, "B": ctypes.c_uint8}[code]
    size = ctypes.sizeof(item)
    for length in shape:
        size *= length
    view = memoryview((ctypes.c_uint8 * size).from_address(address)).cast("B")
    view = view.cast(code, shape) if size > 0 else view.cast(code)
    return view if writable else view.toreadonly()


def _array(view: Any) -> Any:
    return view if numpy is None else numpy.asarray(view)


class _Own:
    """An object of a class that is a method."""

    def __init__(self, method: Any) -> None:
        self._method = method
        self._reset, self._step = method.reset, getattr(method, "step", None)
        self.finish = getattr(method, "finish", None)
        self.uses_tracks = bool(getattr(method, "uses_tracks", False))
        self.uses_map = bool(getattr(method, "uses_map", False))

    def reset(self, task: _Task, heading: Any, known: Any) -> None:
        self._numbers = None
        fields = {name: getattr(task, name) for name, _ in _Task._fields_}
        given = types.SimpleNamespace(
            goal_heading=heading[0] if heading else None,
            goal_heading_tolerance=heading[1] if heading else 0.0,
            **fields,
        )
        if self.uses_map:
            cells = _array(_view(known.cells, "B", (known.size_y, known.size_x)))
            given.map = types.SimpleNamespace(
                resolution=known.resolution,
                origin_x=known.origin_x,
                origin_y=known.origin_y,
                cells=cells if numpy is None else cells.copy(),
            )
        self._reset(given)

    def _seen(self, observation: int, tracks: int, count: int) -> types.SimpleNamespace:
        if self._numbers is None:  # all is at the same place until the next reset
            given = _Observation.from_address(observation)
            self._numbers = _view(observation, "d", (9,))
            self._ranges = _array(_view(given.ranges, "f", (given.rays,)))
        time, x, y, phi, v, vy, w, goal_x, goal_y = self._numbers.tolist()
        seen = types.SimpleNamespace(
            time=time, x=x, y=y, phi=phi, v=v, vy=vy, w=w, goal_x=goal_x, goal_y=goal_y, ranges=self._ranges
        )
        if self.uses_tracks:
            seen.tracks = [
                types.SimpleNamespace(id=track.id, **{name: getattr(track, name) for name in _Track._numbers})
                for track in (_Track * count).from_address(tracks)
            ] if count else []
        return seen

    def adapt(self, observation: int, tracks: int, count: int) -> Dict[str, str]:
        return _classes.parameters(self._method.adapt(self._seen(observation, tracks, count)))

    def set_parameter(self, name: str, value: str) -> None:
        _classes.set_parameter(self._method, name, value)

    def step(self, observation: int, tracks: int, count: int, command: int) -> None:
        if self._numbers is None:
            self._command = _view(command, "d", (3,), writable=True)
        output = self._step(self._seen(observation, tracks, count))
        try:
            if isinstance(output, (str, bytes)):
                raise TypeError
            v, w, *rest = output
            if len(rest) > 1:
                raise TypeError
            self._command[0], self._command[1] = v, w
            if rest:
                self._command[2] = rest[0]
        except (TypeError, ValueError):
            raise _Refused(f"step() returned {output!r}; expected (v, w) or (v, w, vy)") from None


class _Refused(Exception):
    """An error that is its text alone."""


#: Classes with their options, and objects of them, by number.
_classes_given: Dict[int, Tuple[Any, Mapping[str, Any], str]] = {}
_objects: Dict[int, _Own] = {}
_numbers = itertools.count(1)


def _failed(error: BaseException) -> int:
    if isinstance(error, KeyboardInterrupt):
        Call.active.stop(error)  # it ends more than this run
    said = isinstance(error, (_Refused, KeyboardInterrupt))
    reply(str(error) if said else _classes.describe(error))
    return 1


def _create(number: int, options: bytes, robot: Any) -> int:
    kind, values, where = _classes_given[number]
    try:
        chosen = _classes.make_options(kind, {**values, **json.loads(options)}, lambda key: key)
        ranges = _classes.option_ranges(kind, chosen, where)
        own = _Own(kind(_described_robot(robot[0]), chosen))
    except _classes.Invalid as error:
        reply(_message(*error.args[1:]))
        return 0
    except BaseException as error:
        reply(f"{getattr(kind, '__name__', 'object')} cannot be created: {_classes.describe(error)}")
        return 0
    tunable = [dict(zip(("name", "default", "low", "high", "log", "integer"), one)) for one in ranges]
    reply(json.dumps({"uses_tracks": own.uses_tracks, "uses_map": own.uses_map, "tunable": tunable}))
    made = next(_numbers)
    _objects[made] = own
    return made


def _reset(number: int, task: Any, heading: Any, known: Any) -> int:
    try:
        _objects[number].reset(task[0], heading, known[0] if known else None)
        return 0
    except BaseException as error:
        return _failed(error)


def _step(number: int, observation: int, tracks: int, count: int, command: int) -> int:
    try:
        _objects[number].step(observation, tracks, count, command)
        return 0
    except BaseException as error:
        return _failed(error)


def _adapt(number: int, observation: int, tracks: int, count: int) -> int:
    try:
        reply(json.dumps(_objects[number].adapt(observation, tracks, count)))
        return 0
    except BaseException as error:
        return _failed(error)


def _set_parameter(number: int, name: bytes, value: bytes) -> int:
    try:
        _objects[number].set_parameter(name.decode(), value.decode())
        return 0
    except BaseException as error:
        return _failed(error)


def _finish(number: int, outcome: bytes) -> int:
    try:
        finish = _objects[number].finish
        if finish is not None:
            finish(outcome.decode())
        return 0
    except BaseException as error:
        return _failed(error)


def _destroy(number: int) -> None:
    _objects.pop(number, None)


class _Functions(ctypes.Structure):
    _fields_ = [
        ("create", ctypes.PYFUNCTYPE(c_uint64, c_uint64, c_char_p, POINTER(_Robot))),
        ("reset", ctypes.PYFUNCTYPE(c_int, c_uint64, POINTER(_Task), POINTER(c_double), POINTER(_Map))),
        ("step", ctypes.PYFUNCTYPE(c_int, c_uint64, c_void_p, c_void_p, c_size_t, c_void_p)),
        ("finish", ctypes.PYFUNCTYPE(c_int, c_uint64, c_char_p)),
        ("destroy", ctypes.PYFUNCTYPE(None, c_uint64)),
        ("adapt", ctypes.PYFUNCTYPE(c_int, c_uint64, c_void_p, c_void_p, c_size_t)),
        ("set_parameter", ctypes.PYFUNCTYPE(c_int, c_uint64, c_char_p, c_char_p)),
    ]


#: slalom_own_methods.
FUNCTIONS = _Functions(
    *(
        kind(function)
        for (_, kind), function in zip(
            _Functions._fields_, (_create, _reset, _step, _finish, _destroy, _adapt, _set_parameter)
        )
    )
)


def _message(what: str, expected: str) -> str:
    return what + (f"; expected {expected}" if expected else "")


def _own(name: str, kind: Any, values: Mapping[str, Any], where: str) -> Dict[str, Any]:
    """A class, or a function of an observation, whose options are valid, with a number."""
    inner = {key: value for key, value in values.items() if key == "inner"}
    values = {key: value for key, value in values.items() if key != "inner"}
    if callable(kind) and not isinstance(kind, type) and not hasattr(kind, "step"):
        function = kind
        kind = type(getattr(function, "__name__", "function"), (), {"step": lambda self, o: function(o)})
    complete = _classes.complete(kind, where, bool(inner))
    _classes.make_options(complete, values, lambda key: f"{where} {key}")
    number = next(_numbers)
    _classes_given[number] = complete, values, where
    return {"name": name, "type": number, **inner}


def _described(name: str, method: Any) -> Dict[str, Any]:
    where = f"method '{name}'"
    if isinstance(method, dict) and method.get("adapter") == "python":
        # The library would start another interpreter.
        values = {key: value for key, value in method.items() if key not in ("adapter", "module", "class")}
        module = _classes.import_module(os.path.abspath(str(method.get("module", ""))), where)
        method = _classes.find_class(module, str(method.get("class", "")), where), values
    if isinstance(method, dict):
        return {"name": name, "keys": to_section(method, where)}
    if isinstance(method, tuple) and len(method) == 2 and isinstance(method[1], dict):
        return _own(name, *method, where)
    return _own(name, method, {}, where)


@contextlib.contextmanager
def described(methods: Mapping[str, Any]) -> Iterator[List[Dict[str, Any]]]:
    """The methods as of slalom_evaluate(), during the call. Raises Error."""
    made: List[Dict[str, Any]] = []
    if not isinstance(methods, Mapping) or "adapter" in methods:
        raise Error(f"methods: {methods!r} is not a dict of methods; expected {{NAME: METHOD, ...}}")
    try:
        for name, method in methods.items():
            made.append(_described(str(name), method))
        yield made
    except _classes.Invalid as error:
        raise Error(str(error)) from None
    finally:
        for one in made:
            _classes_given.pop(one.get("type", 0), None)
