# SPDX-License-Identifier: BSD-3-Clause
"""Automatic evaluation of obstacle avoidance methods for mobile robots.

    import slalom

    scenarios = slalom.generate("random", 100, seed=1)
    results = slalom.evaluate({"mine": MyMethod, "nd": slalom.mrpt_holonomic("CHolonomicND")}, scenarios)
    print(results.table("density:4", ["success", "optimality"]))

A method is a class as described in docs/methods/methods.md. Lengths are in m, angles in rad, times in s.
"""

from __future__ import annotations

import atexit
import contextlib
import difflib
import functools
import importlib.util
import itertools
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import weakref
from typing import Any, Callable, Dict, Iterator, List, Mapping, Optional, Sequence, TextIO, Tuple, Union


def _why_not_importable() -> str:
    """What this Python lacks for Slalom; empty if nothing is missing."""
    package = os.path.dirname(os.path.abspath(__file__))
    this = f"{sys.executable} is Python {sys.version_info[0]}.{sys.version_info[1]}"
    names = [re.match(r"_slalom\.cpython-(\d)(\d+)", name) for name in os.listdir(package)]
    built = [f"{name[1]}.{name[2]}" for name in names if name]
    if built and f"{sys.version_info[0]}.{sys.version_info[1]}" not in built:
        return f"{this}; expected Python {' or '.join(built)}, for which Slalom was built"
    if importlib.util.find_spec("numpy") is None:
        return f"{this}, without NumPy; expected NumPy for it (pip install numpy), or a Python that has it"
    return ""


if not _why_not_importable():
    from ._slalom import Error, Scenario, __version__, read_scenarios, write_scenarios
    from . import _slalom
elif sys.argv[:1] != ["-m"]:  # that is python -m slalom, which only looks for a program
    raise ImportError("slalom: " + _why_not_importable())

__all__ = [
    "Certificate",
    "Error",
    "Figure",
    "Results",
    "Scenario",
    "TRAJECTORY_COLUMNS",
    "UnknownColumn",
    "barrier_filter",
    "certify",
    "evaluate",
    "generate",
    "mrpt_holonomic",
    "onnx",
    "plugin",
    "read_results",
    "read_scenarios",
    "tune",
    "write_scenarios",
]

#: Columns of the arrays in Results.trajectories.
TRAJECTORY_COLUMNS = (
    "t",
    "x",
    "y",
    "phi",
    "v",
    "w",
    "command_v",
    "command_w",
    "vy",
    "command_vy",
    "traveled",
)


#: A class, a class and its options, or keys as in an .ini: see docs/methods/methods.md.
Method = Union[type, Tuple[type, Dict[str, Any]], Dict[str, Any]]


#: True: a bar on a terminal or in a notebook. False: none. Or a function that is called with the phase,
#: the number of its steps that are done, and in total.
Progress = Union[bool, Callable[[str, int, int], None]]


class UnknownColumn(KeyError):
    """A misspelled column; the nearest one is suggested."""

    def __str__(self) -> str:
        return str(self.args[0])


class Columns(Dict[str, Any]):
    """Values by the name of a column. Raises UnknownColumn for others."""

    def __missing__(self, key: str) -> Any:
        near = difflib.get_close_matches(str(key), self, 1)
        hint = f"did you mean '{near[0]}'?" if near else "expected one of " + ", ".join(self)
        raise UnknownColumn(f"no column '{key}'; {hint}")


class Figure(str):
    """A figure as SVG, which notebooks show."""

    def _repr_svg_(self) -> str:
        return str(self)

    def __repr__(self) -> str:
        return f"<slalom.Figure, {len(self)} characters of SVG>"


class Results(Columns):
    """The results by column, one value per run, in the order of scenario, method and repetition.
    As text it is a summary of the methods.

    pandas.DataFrame(results) is a data frame. Metrics and descriptors are float64 arrays, NaN where
    a value is not available; `reasons[column][row]`, and the column "reasons", say why. `timing` has columns of
    wall-clock figures, which differ from run to run. `trajectories` has for each run an
    array of samples with TRAJECTORY_COLUMNS, or is None.
    """

    def __init__(
        self,
        columns: Dict[str, Any],
        timing: Dict[str, Any],
        reasons: Dict[str, Dict[int, str]],
        trajectories: Optional[List[Any]],
        table: _slalom.ResultTable,
        path: str,
    ) -> None:
        super().__init__(columns)
        self.timing = Columns(timing)
        self.reasons: Dict[str, Dict[int, str]] = Columns(reasons)
        self.trajectories = trajectories
        self._table = table
        self._path = path

    def __repr__(self) -> str:
        return _slalom.summary(self._table, self._path)

    @property
    def manifest(self) -> Dict[str, str]:
        """The settings by "SECTION.KEY", and the versions of the software, as texts."""
        return self._table.manifest

    def table(self, rows: str, columns: Sequence[str], confidence: float = 0.95) -> str:
        """Tables of metrics in bins of a descriptor, one per method, as text. `rows` is "all",
        "density:4" (bins of equal width), "density:q4" (with equal numbers of scenarios) or
        "density:0,0.1,0.2" (edges)."""
        return _slalom.cross_table(self._table, rows, columns, confidence)

    def save(self, path: str) -> None:
        """Writes a result file (.results), with the trajectories, for read_results() and slalom-analyze."""
        _slalom.save_results(self._path, os.fspath(path))

    def compare(
        self,
        *others: Results,
        metrics: Optional[Sequence[str]] = None,
        baseline: Optional[str] = None,
        method: Optional[str] = None,
        relevant: Optional[float] = None,
        power: Optional[float] = None,
        confidence: Optional[float] = None,
    ) -> str:
        """Paired comparisons of the methods as text: of all pairs, with `baseline` only, or with the
        same methods in other results; the arguments are the options of slalom-analyze compare."""
        options = dict(
            metric=metrics,
            baseline=baseline,
            method=method,
            relevant=relevant,
            power=power,
            confidence=confidence,
        )
        return _analyze("compare", [self, *others], options)

    def report(
        self,
        folder: str,
        *,
        rows: Optional[str] = None,
        columns: Optional[Sequence[str]] = None,
        confidence: Optional[float] = None,
    ) -> str:
        """Writes a report of web pages into the folder, or into one file FILE.html, and returns the path of the first page."""
        options = dict(rows=rows, columns=columns, confidence=confidence, output=os.path.abspath(folder))
        _analyze("report", [self], options)
        return folder if folder.endswith(".html") else os.path.join(folder, "index.html")

    def figure(self, path: Optional[str] = None, **options: Any) -> Optional[Figure]:
        """A figure of these runs: the arguments are the options of slalom-analyze figure, such as
        metric="success", by="density:q4", or outcomes=True. With a path (.svg, .pdf or .png) it is
        written there instead."""
        if path is not None:
            _analyze("figure", [self], dict(options, output=os.path.abspath(path)))
            return None
        with tempfile.TemporaryDirectory(prefix="slalom-") as folder:
            path = os.path.join(folder, "figure.svg")
            _analyze("figure", [self], dict(options, output=path))
            with open(path, encoding="utf-8") as file:
                return Figure(file.read())


def _analyze(verb: str, results: Sequence[Results], options: Dict[str, Any]) -> str:
    """What slalom-analyze prints, with short names for the files of evaluate(). Raises Error with
    its message."""
    folder = _evaluation_folder()
    paths = [one._path for one in results]
    names = [os.path.basename(path) if os.path.dirname(path) == folder else path for path in paths]
    try:
        words = [_find_program("slalom-analyze"), verb, *names]
    except FileNotFoundError as error:
        raise Error(str(error)) from None
    for name, value in options.items():
        if value is not None and value is not False:
            is_list = isinstance(value, (list, tuple))
            text = ",".join(map(str, value)) if is_list else value
            words.append(f"--{name}" if value is True else f"--{name}={text}")
    done = subprocess.run(words, capture_output=True, encoding="utf-8", cwd=folder)
    if done.returncode != 0:
        raise Error(done.stderr.strip().replace("slalom-analyze: ", "", 1))
    return done.stdout


def _find_program(name: str) -> str:
    """The path of a program of the same version: in a wheel, built, installed, or on PATH. Raises
    FileNotFoundError."""
    package = os.path.dirname(os.path.abspath(__file__))
    for folder in ("bundle/bin", "../../../bin", "../../../../bin"):
        path = os.path.abspath(os.path.join(package, folder, name))
        if os.path.isfile(path):
            return path
    found = shutil.which(name)
    if found is None:
        raise FileNotFoundError(f"{name} is not installed; expected the package slalom")
    return found


def read_results(path: str, *, trajectories: bool = False) -> Results:
    """Reads a result file (.results), or a folder with the shards of a campaign. Raises Error."""
    return Results(*_slalom.read_results(os.path.abspath(path), trajectories))


def generate(
    family: str,
    count: int,
    seed: int = 1,
    *,
    workers: int = 1,
    walkers: int = 0,
    goal_headings: bool = False,
    robot: Optional[Dict[str, Any]] = None,
    simulation: Optional[Dict[str, Any]] = None,
    progress: Progress = True,
    **options: Any,
) -> List[Scenario]:
    """Generates distinct scenarios that are solvable for the robot.

    `family` is the name of a generator ("random", "maze", ...), `options` are the keys of its section
    in an .ini; `robot` and `simulation` are dicts of the keys of theirs. `walkers` moving obstacles
    are added to each scenario. With `goal_headings` goals have random headings. `workers` is the number of threads; 0 is one per core.
    `progress` as of evaluate().
    """
    sections = {
        "robot": robot,
        "simulation": simulation,
        "scenarios": {"walkers": walkers, "goal_headings": goal_headings},
        "generator." + family: options,
    }
    with _drawn(progress) as report:
        return _slalom.generate(family, count, seed, workers, sections, report)


def evaluate(
    methods: Mapping[str, Method],
    scenarios: Sequence[Scenario],
    *,
    robot: Optional[Dict[str, Any]] = None,
    sensor: Optional[Dict[str, Any]] = None,
    lasers: Optional[Dict[str, Dict[str, Any]]] = None,
    odometry: Optional[Dict[str, Any]] = None,
    simulation: Optional[Dict[str, Any]] = None,
    limits: Optional[Dict[str, Any]] = None,
    tracks: Optional[Dict[str, Any]] = None,
    people: Optional[Dict[str, Any]] = None,
    metrics: Optional[Sequence[str]] = None,
    descriptors: Optional[Sequence[str]] = None,
    seed: int = 1,
    repetitions: int = 1,
    workers: int = 1,
    in_process: bool = False,
    trajectories: bool = False,
    show_output: bool = False,
    progress: Progress = True,
) -> Results:
    """Runs every method in every scenario and computes metrics and descriptors.

    `methods` is a dict from names to classes, pairs of a class and a dict of its options, or what
    barrier_filter(), mrpt_holonomic(), onnx() and plugin() return. `robot`, `sensor`, `odometry`, `simulation`, `limits`,
    `tracks` and `people` are dicts of the keys of these sections in a campaign's .ini, `lasers` a dict of names to the keys
    of [laser.NAME]. Methods run in worker processes, unless
    `in_process`. With `show_output` what they print stands on the terminal (standard error).
    `progress(phase, done, total)` is called meanwhile; True is a bar on a terminal or in a notebook, and
    nothing in a file. Raises Error for invalid arguments, and KeyboardInterrupt after Ctrl-C.
    """
    sections = {
        "robot": robot,
        "sensor": sensor,
        "odometry": odometry,
        "simulation": simulation,
        "limits": {**(limits or {}), "method_errors": True} if show_output else limits,
        "tracks": tracks,
        "people": people,
        **{f"laser.{name}": keys for name, keys in (lasers or {}).items()},
    }
    path = os.path.join(_evaluation_folder(), f"evaluation-{next(_evaluations)}.results")
    global _evaluating
    _evaluating += 1
    if show_output and progress is True:
        progress = False  # a bar would stand between the lines that are shown
    try:
        with _drawn(progress) as report:
            parts = _slalom.evaluate(
                dict(methods),
                list(scenarios),
                sections,
                metrics,
                descriptors,
                seed,
                repetitions,
                workers,
                in_process,
                trajectories,
                report,
                path,
            )
    except BaseException:
        _remove(path)
        raise
    finally:
        _evaluating -= 1
    results = Results(*parts)
    # Copies of the results share the table, and so the file.
    weakref.finalize(results._table, _remove, path)
    return results


#: Numbers in the names of files, by which comparisons tell results from each other.
_evaluations = itertools.count(1)


@functools.lru_cache(maxsize=None)
def _evaluation_folder() -> str:
    """The folder with the result files of this process, which is removed when it ends."""
    folder = tempfile.mkdtemp(prefix="slalom-")
    atexit.register(shutil.rmtree, folder, True)
    return folder


#: Calls of evaluate() that have not ended.
_evaluating = 0


def _print_lines_at_once() -> None:
    """Lets print() of a worker write where its process does: the streams of this process may keep
    text until they are full, or send it to a notebook through descriptors that are closed."""
    if _evaluating:
        _kept_streams.extend((sys.stdout, sys.stderr))  # they would write what they keep once more
        sys.stdout, sys.stderr = (
            open(descriptor, "w", 1, "utf-8", "backslashreplace", closefd=False) for descriptor in (1, 2)
        )


_kept_streams: List[Any] = []
os.register_at_fork(after_in_child=_print_lines_at_once)


def _remove(path: str) -> None:
    with contextlib.suppress(OSError):
        os.remove(path)


def _shows_bars(stream: Optional[TextIO]) -> bool:
    """Whether it is a terminal, or that of a notebook."""
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython else None
    is_terminal = stream is not None and stream.isatty()
    return is_terminal or type(shell).__name__ == "ZMQInteractiveShell"


class _Bar:
    """A line that says how far a long job is, redrawn ten times per second at most."""

    def __init__(self, stream: TextIO, clock: Callable[[], float] = time.monotonic) -> None:
        self._stream = stream
        self._clock = clock
        self._phase = ""
        self._next = 0.0
        self._width = 0

    def __call__(self, phase: str, done: int, total: int) -> None:
        if phase == self._phase and self._clock() < self._next:
            return
        self._phase = phase
        self._next = self._clock() + 0.1
        filled = 20 * done // max(total, 1)
        text = f"{phase} [{'#' * filled}{' ' * (20 - filled)}] {done}/{total}"
        self._draw(text[: shutil.get_terminal_size().columns - 1])

    def clear(self) -> None:
        self._draw("")
        self._stream.write("\r")

    def _draw(self, text: str) -> None:
        self._stream.write("\r" + text.ljust(self._width))
        self._stream.flush()
        self._width = len(text)


@contextlib.contextmanager
def _drawn(progress: Progress) -> Iterator[Optional[Callable[[str, int, int], None]]]:
    """The function to call; a bar is cleared in the end."""
    if callable(progress):
        yield progress
    elif progress and _shows_bars(sys.stderr):
        bar = _Bar(sys.stderr)
        try:
            yield bar
        finally:
            bar.clear()
    else:
        yield None


class Certificate(Dict[str, Any]):
    """A certificate as in a file .certificate.json; `str()` is what it says."""

    def __init__(self, certificate: str, text: str) -> None:
        super().__init__(json.loads(certificate))
        self.text = text

    def __str__(self) -> str:
        return self.text


def certify(
    kind: str,
    method: Method,
    *,
    name: str = "method",
    scenarios: Optional[Dict[str, Any]] = None,
    generators: Optional[Dict[str, Dict[str, Any]]] = None,
    robot: Optional[Dict[str, Any]] = None,
    sensor: Optional[Dict[str, Any]] = None,
    simulation: Optional[Dict[str, Any]] = None,
    limits: Optional[Dict[str, Any]] = None,
    tune: Optional[Dict[str, Any]] = None,
    seed: int = 1,
    workers: int = 1,
    output: str = "",
    **question: Any,
) -> Certificate:
    """Answers a question about the reliability of a method, with a confidence.

    `kind` is "limit", "envelope", "risk" or "standard", `question` what slalom-certify asks for it, such as
    of="passage.width", from_=1.2, to=0.6, step=0.1. `scenarios` and `generators` are dicts of the keys of
    [scenarios] and, by family, of [generator.FAMILY]. With `output` the certificate is written there; that of
    a class cannot be verified, since it does not contain the class.
    """
    sections = {
        "campaign": {"seed": seed},
        "scenarios": scenarios or {"generator": "random"},
        "robot": robot,
        "sensor": sensor,
        "simulation": simulation,
        "limits": limits,
        "tune": tune,
        **{f"generator.{family}": keys for family, keys in (generators or {}).items()},
    }
    fields = {key.rstrip("_"): value for key, value in question.items()}
    if not isinstance(fields.get("reliability", []), (list, tuple)) and kind == "limit":
        fields["reliability"] = [fields["reliability"]]
    return Certificate(
        *_slalom.certify(
            kind, json.dumps({"method": name, **fields}), method, sections, workers, output
        )
    )


def tune(method: Method, **arguments: Any) -> Certificate:
    """Searches better options of a method, as slalom-tune does, and says with which confidence they
    are better than its defaults in scenarios that the search has not seen.

    Arguments are those of certify() and the options of slalom-tune, such as runs=1000. Classes have a
    dict `option_ranges`; `tune` is a dict of the keys of [tune]. The answer has "verdict", and the options
    to use as "recommendation".
    """
    return certify("tune", method, **arguments)


def mrpt_holonomic(class_name: str, plugin: str = "", **options: Any) -> Dict[str, Any]:
    """A method of MRPT's holonomic interface, such as "CHolonomicND", or a class of a plug-in."""
    method = {"adapter": "mrpt_holonomic", "class": class_name, **options}
    if plugin:
        method["plugin"] = _find_plugin(plugin)
    return method


def plugin(library: str, **options: Any) -> Dict[str, Any]:
    """A compiled method: a path, or the name of a shipped one, such as "libslalom_mppi.so"."""
    return {"adapter": "library", "plugin": _find_plugin(library), **options}


def barrier_filter(base: str, **options: Any) -> Dict[str, Any]:
    """The method of that name, whose commands a control barrier function changes where they lead
    to contacts, with the keys of filter = cbf as options."""
    return {"filter": "cbf", "base": base, **options}


def onnx(model: str, **options: Any) -> Dict[str, Any]:
    """A learned policy: a network in an ONNX file, with the keys of adapter = onnx as options."""
    runtime = _find_plugin("runtime/libslalom_onnx_runtime.so")
    return {"adapter": "onnx", "model": os.path.abspath(model), "runtime": runtime, **options}


def _shipped_folders() -> List[str]:
    """Where Slalom's libraries may be: in a wheel, built, installed."""
    package = os.path.dirname(os.path.abspath(__file__))
    folders = ("bundle/lib/slalom", "../../slalom", "../../../slalom")
    return [os.path.abspath(os.path.join(package, folder)) for folder in folders]


def _find_plugin(library: str) -> str:
    """The path of a library: as given, or in the folders where Slalom's methods are."""
    for folder in ("", *_shipped_folders()):
        path = os.path.abspath(os.path.join(folder, library))
        if os.path.isfile(path):
            return path
    return library


if "_slalom" in globals():
    _slalom.set_shipped_folder(next(filter(os.path.isdir, _shipped_folders()), ""))
