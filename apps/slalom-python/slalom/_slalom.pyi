# SPDX-License-Identifier: BSD-3-Clause
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

import numpy

__version__: str

class Error(ValueError): ...

class Scenario:
    """One obstacle avoidance problem: a workspace, its obstacles, a start pose and a goal."""

    @property
    def name(self) -> str: ...
    @property
    def hash(self) -> str:
        """Of the content, 32 hexadecimal digits."""
    @property
    def start(self) -> Tuple[float, float, float]:
        """x, y (m) and heading (rad)."""
    @property
    def goal(self) -> Tuple[float, float]:
        """x, y (m)."""
    @property
    def goal_heading(self) -> Optional[float]:
        """rad; None if any will do."""
    @property
    def bounds(self) -> Tuple[float, float, float, float]:
        """x_min, y_min, x_max, y_max (m)."""
    @property
    def movers(self) -> List[Dict[str, Any]]:
        """Moving obstacles: id, radius (m), after ("stop", "loop" or "vanish"), waypoints: a list of
        t (s), x, y (m)."""
    def yaml(self) -> str:
        """As in a file .scenario.yaml."""
    @staticmethod
    def from_yaml(text: str) -> "Scenario": ...
    def occupancy(self, resolution: float = 0.05) -> "numpy.ndarray[Any, numpy.dtype[numpy.bool_]]":
        """Cells [row, column], row 0 at y_min; True where occupied. Grids keep their own cells."""
    def _repr_svg_(self) -> str: ...

class ResultTable:
    @property
    def manifest(self) -> Dict[str, str]: ...

_Results = Tuple[
    Dict[str, Any], Dict[str, Any], Dict[str, Dict[int, str]], Optional[List[Any]], ResultTable, str
]

def read_scenarios(path: str) -> List[Scenario]: ...
def write_scenarios(path: str, scenarios: Sequence[Scenario]) -> None: ...
def generate(
    family: str,
    count: int,
    seed: int,
    workers: int,
    sections: Dict[str, Any],
    progress: Optional[Callable[[str, int, int], None]],
) -> List[Scenario]: ...
def set_shipped_folder(folder: str) -> None: ...
def evaluate(
    methods: Dict[str, Any],
    scenarios: Sequence[Scenario],
    sections: Dict[str, Any],
    metrics: Optional[Sequence[str]],
    descriptors: Optional[Sequence[str]],
    seed: int,
    repetitions: int,
    workers: int,
    in_process: bool,
    trajectories: bool,
    progress: Optional[Callable[[str, int, int], None]],
    output: str,
) -> _Results: ...
def read_results(path: str, trajectories: bool) -> _Results: ...
def save_results(path: str, output: str) -> None: ...
def summary(table: ResultTable, path: str) -> str: ...
def certify(
    kind: str, question: str, method: Any, sections: Dict[str, Any], workers: int, output: str
) -> Tuple[str, str]: ...
def cross_table(
    table: ResultTable, rows: str, columns: Sequence[str], confidence: float
) -> str: ...
