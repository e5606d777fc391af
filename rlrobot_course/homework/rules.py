"""What counts how much: points of exercises, part of the cases, hints, late days; from a file of the instructor's."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from rlrobot_course.homework.text import text_of


@dataclass(frozen=True)
class Rules:
    """By default each exercise counts 1 point, for an answer that is right in every case.

    points: of exercises, by their names; partial: whether an answer that is right in some cases gets part of its points
    hint_off: part of an exercise's points that each of its hints costs
    late_off: part of all points that each day costs after `late_free` days, `late_most` at most
    """

    points: Mapping[str, float] = field(default_factory=dict)
    partial: bool = False
    hint_off: float = 0.0
    late_off: float = 0.0
    late_free: float = 0.0
    late_most: float = 1.0

    def points_of(self, exercise: str) -> float:
        """Points of an exercise."""
        return self.points.get(exercise, 1.0)

    def off(self, days: float, points: float) -> float:
        """Points that come off so many points after so many days."""
        return round(points * min(self.late_most, self.late_off * max(0.0, days - self.late_free)), 2)


NO_RULES = Rules()
PARTS = ("hint_off", "late_off", "late_most")  # of points


def read_rules(path: str) -> Rules:
    """The rules of a TOML file. Raises OSError, or ValueError if it says anything else than rules."""
    try:
        told = tomllib.loads(text_of(path))
    except ValueError as error:
        raise ValueError(f"{path} is no TOML file: {error}") from None
    known: dict[str, Any] = vars(NO_RULES)
    for name, value in told.items():
        if name == "points":
            fits = isinstance(value, dict) and all(map(_is_amount, value.values()))
        else:
            fits = isinstance(value, bool) if name == "partial" else _is_amount(value)
        if name not in known or not fits:
            raise ValueError(f"{path}: {name} = {value!r} is no rule; there are {', '.join(known)}, not below 0")
        if name in PARTS and value > 1:
            raise ValueError(f"{path}: {name} = {value!r} is more than all; write 0.1 for 10 %")
    return Rules(**told)


def _is_amount(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and 0 <= value < 1e9
