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
import collections
import contextlib
import ctypes
import difflib
import functools
import html
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


from ._library import Call, Error, Handle, find_library, load, numpy, taken_array, to_json, to_settings, whole
from ._methods import FUNCTIONS, described
from ._own import candidates, column, name_of

if sys.argv[:1] != ["-m"]:  # that is python -m slalom, which only looks for a program
    __version__ = load().slalom_version().decode()

__all__ = [
    "Certificate",
    "Error",
    "Figure",
    "Results",
    "Run",
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


#: A class, a function of an observation, a class and its options, or keys as in an .ini: see docs/methods/methods.md.
Method = Union[type, Callable[[Any], Sequence[float]], Tuple[type, Dict[str, Any]], Dict[str, Any]]


#: True: a bar on a terminal or in a notebook. False: none. Or a function that is called with the phase,
#: the number of its steps that are done, and in total.
Progress = Union[bool, Callable[[str, int, int], None]]


class Scenario:
    """One obstacle avoidance problem: a workspace, its obstacles, a start pose and a goal."""

    def __init__(self, scenarios: Handle, index: int) -> None:
        self._place = scenarios, index

    @functools.cached_property
    def _described(self) -> Dict[str, Any]:
        return json.loads(load().slalom_scenario_json(*self._place))

    @property
    def name(self) -> str:
        return self._described["name"]

    @property
    def hash(self) -> str:
        """Of the content, 32 hexadecimal digits."""
        return self._described["hash"]

    @property
    def start(self) -> Tuple[float, float, float]:
        """x, y (m) and heading (rad)."""
        return tuple(self._described["start"])

    @property
    def goal(self) -> Tuple[float, float]:
        """x, y (m)."""
        return tuple(self._described["goal"])

    @property
    def goal_heading(self) -> Optional[float]:
        """rad; None if any will do."""
        return self._described["goal_heading"]

    @property
    def bounds(self) -> Tuple[float, float, float, float]:
        """x_min, y_min, x_max, y_max (m)."""
        return tuple(self._described["bounds"])

    @property
    def movers(self) -> List[Dict[str, Any]]:
        """Moving obstacles: id, radius (m), after ("stop", "loop" or "vanish"), waypoints: a list of
        t (s), x, y (m)."""
        return [{**mover, "waypoints": list(map(tuple, mover["waypoints"]))} for mover in self._described["movers"]]

    def yaml(self) -> str:
        """As in a file .scenario.yaml."""
        return load().slalom_scenario_yaml(*self._place)

    @staticmethod
    def from_yaml(text: str) -> Scenario:
        return _scenarios_of(load().slalom_scenarios_from_yaml(text.encode()))[0]

    def occupancy(self, resolution: float = 0.05) -> Any:
        """Cells [row, column], row 0 at y_min; True where occupied. Grids keep their own cells."""
        rows, columns = ctypes.c_size_t(), ctypes.c_size_t()
        sizes = ctypes.byref(rows), ctypes.byref(columns)
        cells = load().slalom_scenario_occupancy(*self._place, resolution, *sizes)
        return taken_array(cells, "?", (rows.value, columns.value))

    def _repr_svg_(self) -> str:
        return load().slalom_scenario_svg(*self._place)

    def __repr__(self) -> str:
        x, y, _ = self.start
        return (
            f"<slalom.Scenario {self.name} {self.hash[:8]}, start ({x:.2f}, {y:.2f}), "
            f"goal ({self.goal[0]:.2f}, {self.goal[1]:.2f})>"
        )

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Scenario) and self.hash == other.hash

    def __hash__(self) -> int:
        return hash(self.hash)

    def __reduce__(self) -> Any:
        return Scenario.from_yaml, (self.yaml(),)


def _scenarios_of(address: int) -> List[Scenario]:
    handle = Handle(address, "slalom_scenarios_free")
    return [Scenario(handle, index) for index in range(load().slalom_scenarios_size(handle))]


def _list_of(scenarios: Sequence[Scenario]) -> Handle:
    given = [] if isinstance(scenarios, Scenario) else list(scenarios)
    if isinstance(scenarios, Scenario) or not all(isinstance(one, Scenario) for one in given):
        raise Error(f"scenarios: {scenarios!r} is not a list of scenarios; expected that of generate() or read_scenarios()")
    handle = Handle(load().slalom_scenarios_new(), "slalom_scenarios_free")
    for scenario in given:
        load().slalom_scenarios_add(handle, *scenario._place)
    return handle


def read_scenarios(path: str) -> List[Scenario]:
    """Reads a list (.scenarios) or a scenario (.yaml). Raises Error."""
    return _scenarios_of(load().slalom_scenarios_read(os.fsencode(path)))


def write_scenarios(path: str, scenarios: Sequence[Scenario]) -> None:
    """Writes a list. Raises Error."""
    load().slalom_scenarios_write(_list_of(scenarios), os.fsencode(path))


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


_Sample = collections.namedtuple("_Sample", TRAJECTORY_COLUMNS)  # type: ignore[misc]


class Run:
    """A run of results, for a metric: `run["path_length"]` is its value in a column."""

    def __init__(self, results: Results, row: int, scenario: Scenario) -> None:
        self._results, self._row = results, row
        self.scenario = scenario
        self.method: str = results["method"][row]
        self.repetition = int(results["repetition"][row])
        self.outcome: str = results["outcome"][row]

    @functools.cached_property
    def trajectory(self) -> Any:
        """Samples with TRAJECTORY_COLUMNS."""
        kept = self._results.trajectories
        return _trajectory(self._results._table, self._row) if kept is None else kept[self._row]

    @property
    def samples(self) -> List[Any]:
        """The same as named tuples: `run.samples[-1].x`."""
        width = len(TRAJECTORY_COLUMNS)
        return [_Sample(*(self.trajectory[row, i] for i in range(width))) for row in range(len(self.trajectory))]

    def __getitem__(self, name: str) -> Any:
        return self._results[name][self._row]

    def __repr__(self) -> str:
        return f"<slalom.Run {self.scenario.hash[:8]}/{self.method}/{self.repetition}, {self.outcome}>"


class Results(Columns):
    """The results by column, one value per run, in the order of scenario, method and repetition.
    As text it is a summary of the methods; notebooks show the first screen of the report.

    pandas.DataFrame(results) is a data frame. Metrics and descriptors are float64 arrays, NaN where
    a value is not available; `reasons[column][row]`, and the column "reasons", say why. `timing` has columns of
    wall-clock figures, which differ from run to run. `trajectories` has for each run an
    array of samples with TRAJECTORY_COLUMNS, or is None.
    """

    def __init__(self, table: Handle, path: str, trajectories: bool) -> None:
        runs = load().slalom_results_size(table)
        described = json.loads(load().slalom_results_json(table))

        def numbers(ids: List[str]) -> Dict[str, Any]:
            return {one: taken_array(load().slalom_results_numbers(table, one.encode()), "d", (runs,)) for one in ids}

        reasons = {
            one: {int(run): reason for run, reason in described["reasons"][one].items()}
            for one in described["numbers"]
        }
        texts = ("scenario", "scenario_hash", "method", "repetition", "outcome", "detail")
        super().__init__({name: described["columns"][name] for name in texts})
        if numpy is not None:
            self["repetition"] = numpy.array(self["repetition"], dtype=numpy.uint32)
        self["reasons"] = [{one: by_run[run] for one, by_run in reasons.items() if run in by_run} for run in range(runs)]
        self.update(numbers(described["numbers"]))
        self.timing = Columns(numbers(described["timing"]))
        self.reasons: Dict[str, Dict[int, str]] = Columns(reasons)
        #: The settings by "SECTION.KEY", and the versions of the software, as texts.
        self.manifest: Dict[str, str] = described["manifest"]
        self.trajectories = [_trajectory(table, run) for run in range(runs)] if trajectories else None
        self._table = table
        self._path = path

    def __repr__(self) -> str:
        return load().slalom_results_summary(self._table)

    def _repr_html_(self) -> str:
        page = html.escape(load().slalom_results_html(self._table))
        grow = "this.style.height = this.contentDocument.documentElement.scrollHeight + 'px'"
        return f'<iframe srcdoc="{page}" onload="{grow}" style="border: 0; width: 100%; height: 30em"></iframe>'

    @functools.cached_property
    def scenarios(self) -> List[Scenario]:
        """Those of the runs, in the order in which they first occur."""
        return _scenarios_of(load().slalom_results_scenarios(self._table))

    def runs(self) -> Iterator[Run]:
        """The runs in the order of the columns."""
        by_hash = {scenario.hash: scenario for scenario in self.scenarios}
        return (Run(self, row, by_hash[one]) for row, one in enumerate(self["scenario_hash"]))

    def add_metric(
        self,
        function: Callable[[Run], Any],
        *,
        name: Optional[str] = None,
        unit: str = "-",
        better: Optional[str] = None,
        kind: Optional[str] = None,
        low: Optional[float] = None,
        high: Optional[float] = None,
        version: int = 1,
    ) -> None:
        """Adds what the function says of each run as a column, called as the function: a number, or
        None or a text that says why there is none. `better` is "up" or "down", `kind` "rate" (0 or 1), "count", "amount",
        "ratio" or "score" (0 in failures), `low` and `high` bound the possible values. The source of the function stands in the manifest. Raises Error."""
        self._add(column("runs", function, self.runs(), name, unit, better, kind, low, high, version))

    def add_descriptor(
        self,
        function: Callable[[Scenario], Any],
        *,
        name: Optional[str] = None,
        unit: str = "-",
        low: Optional[float] = None,
        high: Optional[float] = None,
        version: int = 1,
    ) -> None:
        """The same of each scenario, for the rows of tables."""
        self._add(column("scenarios", function, self.scenarios, name, unit, None, None, low, high, version))

    def _add(self, added: Dict[str, Any]) -> None:
        path, kept = _new_path(), self.trajectories
        table = Handle(load().slalom_results_add(self._table, to_json(added), os.fsencode(path)), "slalom_results_free")
        weakref.finalize(table, _remove, path)
        Results.__init__(self, table, path, False)
        self.trajectories = kept

    def table(self, rows: str, columns: Sequence[str], confidence: float = 0.95) -> str:
        """Tables of metrics in bins of a descriptor, one per method, as text. `rows` is "all",
        "density:4" (bins of equal width), "density:q4" (with equal numbers of scenarios) or
        "density:0,0.1,0.2" (edges)."""
        return load().slalom_results_table(self._table, rows.encode(), to_json(list(columns)), confidence)

    def save(self, path: str) -> None:
        """Writes a result file (.results), with the trajectories, for read_results() and slalom-analyze."""
        load().slalom_results_save(self._table, os.fsencode(path))

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


    #: As of figure().
    plot = figure


def _trajectory(table: Handle, run: int) -> Any:
    samples = ctypes.c_size_t()
    numbers = load().slalom_results_trajectory(table, run, ctypes.byref(samples))
    return taken_array(numbers, "d", (samples.value, len(TRAJECTORY_COLUMNS)))


def _results(address: int, path: str, trajectories: bool) -> Results:
    return Results(Handle(address, "slalom_results_free"), path, trajectories)


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
            option = "--" + name.replace("_", "-")
            words.append(option if value is True else f"{option}={text}")
    done = subprocess.run(words, capture_output=True, encoding="utf-8", cwd=folder)
    if done.returncode != 0:
        text = re.sub(r" \(see '[^']*'\)", "", done.stderr.strip().replace("slalom-analyze: ", "", 1))
        raise Error(re.sub(r"(?<![^\s\[,])--([a-z][a-z-]*)(?![^\s,;:\]])", lambda m: m[1].replace("-", "_"), text))
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
    path = os.path.abspath(path)
    return _results(load().slalom_results_read(os.fsencode(path)), path, trajectories)


def generate(
    family: Union[str, Callable[..., Dict[str, Any]]],
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
    in an .ini. Or it is a function of a random.Random and of the options, which returns a candidate: a dict with the keys
    of a scenario in YAML, such as bounds, start, goal and discs. `robot` and `simulation` are dicts of the keys of theirs. `walkers` moving obstacles
    are added to each scenario. With `goal_headings` goals have random headings. `workers` is the number of threads; 0 is one per core.
    `progress` as of evaluate().
    """
    sections = {
        "robot": robot,
        "simulation": simulation,
        "scenarios": {"walkers": walkers, "goal_headings": goal_headings},
    }
    if isinstance(family, str):
        sections["generator." + family] = options
    elif not callable(family):
        raise Error(f"family: {family!r} is not valid; expected the name of a generator, or a function")
    settings = to_json(to_settings(sections))
    numbers = whole("count", count, 1, 2**31 - 1), whole("seed", seed, 0, 2**63 - 1), whole("workers", workers, 0, 1000)
    with _drawn(progress) as report, Call(report) as call:
        if isinstance(family, str):
            made = load().slalom_scenarios_generate(family.encode(), *numbers, settings, call.report, None)
        else:
            name, make = name_of(family, "family").encode(), candidates(family, options, call)
            made = load().slalom_scenarios_generate_own(name, make, *numbers, settings, call.report, None)
    return _scenarios_of(made)


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

    `methods` is a dict from names to classes, functions of an observation, pairs of a class and a dict of its options, or what
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
    path = _new_path()
    global _evaluating
    _evaluating += 1
    if show_output and progress is True:
        progress = False  # a bar would stand between the lines that are shown
    try:
        options = {
            "settings": to_settings(sections),
            "metrics": _ids("metrics", metrics),
            "descriptors": _ids("descriptors", descriptors),
            "seed": whole("seed", seed, 0, 2**63 - 1),
            "repetitions": whole("repetitions", repetitions, 1, 1000000),
            "workers": whole("workers", workers, 0, 1000),
            "in_process": bool(in_process),
            "output": path,
        }
        with described(methods) as given, _drawn(progress) as report, Call(report) as call:
            made = load().slalom_evaluate(
                to_json(given),
                ctypes.addressof(FUNCTIONS),
                _list_of(scenarios),
                to_json(options),
                call.report,
                None,
            )
        results = _results(made, path, trajectories)
    except BaseException:
        _remove(path)
        raise
    finally:
        _evaluating -= 1
    # Copies of the results share the table, and so the file.
    weakref.finalize(results._table, _remove, path)
    return results


def _ids(name: str, given: Optional[Sequence[str]]) -> Optional[List[str]]:
    if isinstance(given, str):
        raise Error(f"{name}: {given!r} is not a list; expected [{given!r}]")
    return None if given is None else list(given)


#: Numbers in the names of files, by which comparisons tell results from each other.
_evaluations = itertools.count(1)


def _new_path() -> str:
    return os.path.join(_evaluation_folder(), f"evaluation-{next(_evaluations)}.results")


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

    def __init__(self, certificate: Dict[str, Any], text: str) -> None:
        super().__init__(certificate)
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
    with described({name: method}) as given, Call():
        answer = json.loads(
            load().slalom_certify(
                kind.encode(),
                to_json({"method": name, **fields}),
                to_json(given[0]),
                ctypes.addressof(FUNCTIONS),
                to_json(to_settings(sections)),
                whole("workers", workers, 0, 1000),
                os.fsencode(output),
            )
        )
    return Certificate(answer["certificate"], answer["text"])


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
        method["plugin"] = find_library(plugin)
    return method


def plugin(library: str, **options: Any) -> Dict[str, Any]:
    """A compiled method: a path, or the name of a shipped one, such as "libslalom_mppi.so"."""
    return {"adapter": "library", "plugin": find_library(library), **options}


def barrier_filter(base: str, **options: Any) -> Dict[str, Any]:
    """The method of that name, whose commands a control barrier function changes where they lead
    to contacts, with the keys of filter = cbf as options."""
    return {"filter": "cbf", "base": base, **options}


def onnx(model: str, **options: Any) -> Dict[str, Any]:
    """A learned policy: a network in an ONNX file, with the keys of adapter = onnx as options."""
    runtime = find_library("runtime/libslalom_onnx_runtime.so")
    return {"adapter": "onnx", "model": os.path.abspath(model), "runtime": runtime, **options}
