"""The final average rewards in the report of the reproduction."""

import csv
from functools import cache
from pathlib import Path

import numpy as np


def rows_of(path: Path) -> list[dict[str, str]]:
    """The rows of a CSV file, each by the names of its columns."""
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


@cache
def averages() -> dict[tuple[str, str], dict[str, np.ndarray]]:
    """Arrays (repetitions,) by method, for each experiment and length, such as ("robot_arm_1k", "10 episodes")."""
    course = Path(__file__).parents[1]
    report = (
        course / "averages.csv"
    )  # in an installed package; in a checkout the report itself is read
    return read_averages(
        report
        if report.is_file()
        else course.parent / "docs" / "reproduction" / "averages.csv"
    )


def read_averages(path: Path) -> dict[tuple[str, str], dict[str, np.ndarray]]:
    """The same from any file that `make reproduce` wrote."""
    found: dict[tuple[str, str], dict[str, list[float]]] = {}
    for row in rows_of(path):
        its = found.setdefault((row["experiment"], row["length"]), {})
        its.setdefault(row["method"], []).append(float(row["final_average_reward"]))
    return {
        key: {method: np.array(x) for method, x in its.items()}
        for key, its in found.items()
    }
