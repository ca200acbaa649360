# SPDX-License-Identifier: BSD-3-Clause
"""Functions of the user as metrics, descriptors and families of scenarios."""

from __future__ import annotations

import inspect
import json
import math
import random
from typing import Any, Callable, Dict, Iterable, List, Optional

from ._library import FAMILY, Call, Error, reply


def _number(name: str, given: Any) -> float:
    try:
        return float(given)
    except (TypeError, ValueError):
        raise Error(f"{name}: {given!r} is not valid; expected a number") from None


def name_of(function: Callable[..., Any], otherwise: str) -> str:
    name = str(getattr(function, "__name__", otherwise))
    return name if name.isidentifier() else otherwise


def _source(function: Callable[..., Any]) -> str:
    try:
        return inspect.getsource(function)
    except (OSError, TypeError):
        return f"{name_of(function, 'a function')} of Python, whose source is not known"


def _value(given: Any, where: str) -> Any:
    """A number, or a text that says why there is none."""
    if given is None:
        return "no value"
    if isinstance(given, str):
        return given or "no value"
    try:
        number = float(given)
    except (TypeError, ValueError):
        raise Error(f"{where}: {given!r} is not valid; expected a number, None, or a text that says why there is none") from None
    return number if math.isfinite(number) else "not a finite number"


def column(
    of: str,
    function: Callable[[Any], Any],
    arguments: Iterable[Any],
    name: Optional[str],
    unit: str,
    better: Optional[str],
    kind: Optional[str],
    low: Optional[float],
    high: Optional[float],
    version: int,
) -> Dict[str, Any]:
    """A column of slalom_results_add(), with what the function says of each argument."""
    identity = name_of(function, "") if name is None else name
    values: List[Any] = [_value(function(one), f"{identity} of {one!r}") for one in arguments]
    return {
        "id": identity,
        "of": of,
        "values": values,
        "version": int(version),
        "unit": unit,
        "better": better or "none",
        "kind": kind or ("ratio" if unit == "-" else "amount"),
        "range": "..".join("" if end is None else repr(_number("low and high", end)) for end in (low, high)),
        "source": _source(function),
    }


def candidates(family: Callable[..., Dict[str, Any]], options: Dict[str, Any], call: Call) -> Any:
    """slalom_family of a function of a random.Random and of these options."""

    def make(_context: Any, name: bytes, seed: int) -> int:
        try:
            given = family(random.Random(seed), **options)
            if not isinstance(given, dict):
                raise Error(f"family {name_of(family, 'family')}: {given!r} is not a dict; expected one with the keys of a scenario in YAML")
            if "representation" not in given:
                given = {"representation": "continuous", "discs": [], "polygons": [], **given}
            reply(json.dumps({**given, "name": name.decode()}, default=lambda one: one.tolist()))
            return 0
        except BaseException as error:
            call.raised = error
            reply(str(error))
            return 1

    return FAMILY(make)
