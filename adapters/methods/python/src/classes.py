# SPDX-License-Identifier: BSD-3-Clause
"""Classes that are methods: of the adapter python, which embeds this text, and of the package slalom."""

import copy
import difflib
import importlib.util
import math
import os
import sys
import traceback
import types


class Invalid(Exception):
    """(where, what, expected)"""

    def __str__(self):
        where, what, expected = self.args
        return f"{where}: {what}" + (f"; expected {expected}" if expected else "")


def nearest(name, known, otherwise=""):
    """The expected names, for messages about an unknown one."""
    close = difflib.get_close_matches(name, known, 1)
    return f"'{close[0]}'" if close else otherwise or "one of " + ", ".join(known)


def import_module(path, where):
    """The module of a file, whose folder is searched first for modules that it imports."""
    name = os.path.splitext(os.path.basename(path))[0]
    sys.path.insert(0, os.path.dirname(path))
    spec = importlib.util.spec_from_file_location(name, path)
    if spec is None:
        raise Invalid(where, f"{path} is not a Python module", "a .py file")
    module = sys.modules[name] = importlib.util.module_from_spec(spec)
    try:
        spec.loader.exec_module(module)
    except BaseException as error:
        place = searched() if isinstance(error, ModuleNotFoundError) else ""
        raise Invalid(where, f"{path} cannot be imported: {describe(error)}{place}", "") from None
    return module


def find_class(module, name, where):
    classes = [key for key, value in vars(module).items() if isinstance(value, type)]
    if name not in classes:
        what = f"no class '{name}' in the module" if name else "missing"
        raise Invalid(where, what, nearest(name, classes, "a class with step()"))
    return getattr(module, name)


def complete(method, where, adapts=False):
    """The class with what it leaves out: a constructor, which sets the attributes `robot` and `options`, and
    reset(), which calls the constructor again, so that no run depends on another."""
    needed = "adapt" if adapts else "step"
    expected = f"a class with {needed}(observation)"
    if not isinstance(method, type):
        raise Invalid(where, f"{method!r} is not a class", expected)
    if not callable(getattr(method, needed, None)):
        raise Invalid(where, f"{method.__name__} has no {needed}()", expected)
    is_constructed = method.__init__ is not object.__init__
    is_reset = callable(getattr(method, "reset", None))
    if is_constructed and is_reset:
        return method

    class Complete(method):
        def __init__(self, robot, options):
            if is_constructed:
                super().__init__(robot, copy.copy(options))
            else:
                self.robot, self.options = robot, copy.copy(options)
            self._made_of = robot, options

    def reset(self, task):
        robot, options = self._made_of
        self.__dict__.clear()
        self.__init__(robot, options)

    if not is_reset:
        Complete.reset = reset
    for name in ("__name__", "__qualname__", "__module__", "__doc__"):
        setattr(Complete, name, getattr(method, name))
    return Complete


def make_options(method, values, where):
    """The options that the class declares as attributes: the given values, else the defaults. Texts become of the
    type of the default. `where` makes a text of an option's name."""
    expected = 'options = {"NAME": (DEFAULT, "UNIT", "HELP"), ...}'
    declared = getattr(method, "options", {})
    if not isinstance(declared, dict):
        raise Invalid(where("class"), "options of the class are not a dict", expected)
    for key, value in declared.items():
        if not (isinstance(key, str) and isinstance(value, tuple) and len(value) == 3):
            raise Invalid(where("class"), f"malformed option {key!r}", expected)
    options = types.SimpleNamespace(**{key: value[0] for key, value in declared.items()})
    for key, value in values.items():
        if key not in declared:
            expected = nearest(key, declared, "" if declared else "no options")
            raise Invalid(where(key), "unknown option of the class", expected)
        setattr(options, key, _converted(declared[key][0], value, where(key)))
    return options


def _converted(default, value, where):
    if not isinstance(value, str):
        return value
    for kind, expected in ((bool, "true or false"), (int, "an integer"), (float, "a number")):
        if isinstance(default, kind):
            try:
                converted = {"true": True, "false": False}[value] if kind is bool else kind(value)
                if math.isfinite(converted):
                    return converted
                raise ValueError
            except (KeyError, ValueError):
                raise Invalid(where, f"'{value}' is not valid", expected) from None
    return value


def set_parameter(method, name, value):
    """Sets an option of an object during a run: by its own set_parameter(), else where each step finds it."""
    declared = getattr(type(method), "options", {})
    if name not in declared:
        raise ValueError(f"'{name}' is not an option; expected {nearest(name, declared, '' if declared else 'no options')}")
    try:
        converted = _converted(declared[name][0], value, name)
    except Invalid as error:
        raise ValueError(str(error)) from None
    if hasattr(method, "set_parameter"):
        method.set_parameter(name, converted)
    elif isinstance(getattr(method, "options", None), types.SimpleNamespace):
        setattr(method.options, name, converted)
    else:
        raise TypeError(f"'{name}' cannot be set during a run: {type(method).__name__} has no set_parameter(name, value)")


def parameters(given):
    """What adapt() has returned, as texts."""
    if not isinstance(given, dict):
        raise TypeError(f"adapt() returned {given!r}; expected a dict of parameters and their values")
    return {str(name): to_text(value, name) for name, value in given.items()}


def to_text(value, where):
    """A value as in an .ini: numbers, truth values, texts, paths, lists of these or of points."""
    if hasattr(value, "tolist"):
        value = value.tolist()  # of NumPy
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    if isinstance(value, int):
        return str(value)
    if hasattr(value, "__float__"):
        text = repr(float(value) + 0.0)
        return text[:-2] if text.endswith(".0") else text
    if not isinstance(value, (list, tuple)):
        raise Invalid(where, f"{value!r} is not valid", "a number, a truth value, a text or a list")
    nested = any(isinstance(part, (list, tuple)) for part in value)
    return ("; " if nested else ", ").join(to_text(part, where) for part in value)


def option_ranges(method, options, where):
    """What the class declares for tuning: a list of (name, default, low, high, log, integer)."""
    expected = 'option_ranges = {"NAME": (LOW, HIGH) or (LOW, HIGH, "log"), ...} of numeric options'
    ranges = getattr(method, "option_ranges", {})
    if not isinstance(ranges, dict):
        raise Invalid(where, "option_ranges of the class are not a dict", expected)
    found = []
    for name, value in ranges.items():
        try:
            default = getattr(options, name)
            low, high, *rest = value
            if rest not in ([], ["log"]):
                raise ValueError
            found.append((name, float(default), float(low), float(high), rest == ["log"], isinstance(default, int)))
        except (AttributeError, TypeError, ValueError):
            raise Invalid(where, f"malformed range of '{name}' in option_ranges", expected) from None
    return found


def searched():
    """The Python that did not find a module, and the environment that could be meant."""
    version = "Python {}.{}".format(*sys.version_info)
    text = f"; not in {version} ({sys.executable})"
    activated = {name: os.environ[name] for name in ("VIRTUAL_ENV", "CONDA_PREFIX") if os.environ.get(name)}
    is_embedded = __file__ == "<slalom>"
    if is_embedded and not any(os.path.realpath(sys.prefix) == os.path.realpath(path) for path in activated.values()):
        for name, folder in activated.items():
            text += f"; {name} is {folder}, which was not used; expected an environment of {version} by venv"
            text += ", or slalom.evaluate() in its own Python"
    return text


def describe(error):
    """One line: type, text and where it was raised, without folders of the machine. The traceback goes to standard error."""
    traceback.print_exception(type(error), error, error.__traceback__)
    if isinstance(error, ModuleNotFoundError):
        print(error, searched(), sep="", file=sys.stderr)
    text = ": ".join(filter(None, (type(error).__name__, str(error)))).replace("\n", " ")
    frames = [
        f"{os.path.basename(frame.filename)}:{frame.lineno} in {frame.name}"
        for frame in traceback.extract_tb(error.__traceback__)
        if os.path.dirname(frame.filename) != os.path.dirname(__file__) and not frame.filename.startswith("<frozen")
    ]
    return text + (f" ({', '.join(frames)})" if frames else "")
