"""The formula behind a question in numbers, and which one change of it gives the number of an answer."""

from __future__ import annotations

import ast
import math
import re
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np

from rlrobot_grading.answers.values import safely, same
from rlrobot_grading.hints.changed import Change, become, changed
from rlrobot_grading.hints.further_changes import further_changes, put_around, renamed
from rlrobot_grading.hints.simple_changes import simple_changes

Variant = tuple[str, Mapping[str, str]]  # in words, and the formula and its parts

UNITS = {
    "a hundred": 100,
    "a hundredth": 0.01,
    "a thousand": 1000,
    "a thousandth": 0.001,
}
FAR_FETCHED = 3  # the rank of changes that give a round number by chance
QUOTED = re.compile(r"“([^”]*)”")
MOST = 2  # changes that give the same number and are told; if there are more, none is


class Changed(NamedTuple):
    """One change in words, how far-fetched it is, the number that it gives, and the one with other quantities."""

    said: str
    rank: int
    value: Any
    elsewhere: Any


class Formula:
    """What is asked, as a learner would write it: ``Formula("Q + α * δ", Q=4, α=0.2, r=10, δ="r - Q")``.

    of: the quantities by their names, in the lesson's symbols: numbers, or formulas of those before them. What does
        not occur in the formula may stand wrongly in it, as another number of the question, or of the lesson's example
    """

    def __init__(self, text: str, **of: Any) -> None:
        self.texts = {
            name: part for name, part in of.items() if isinstance(part, str)
        } | {"": text}
        self.numbers = {
            name: number for name, number in of.items() if not isinstance(number, str)
        }

    @property
    def value(self) -> Any:
        """What is right."""
        return self._worth(self.texts, self.numbers)

    def told(self, answer: Any, near: float) -> str:
        """Which change gives this answer; empty if none does, or if that is not certain. near: relative difference"""
        found: list[Changed] = []
        for change in self.changes:
            if not same(answer, change.value, near):
                continue
            if not any(same(change.elsewhere, other.elsewhere) for other in found):
                found.append(change)
        likely = [change.said for change in found if change.rank == found[0].rank]
        if found and found[0].rank == FAR_FETCHED and _is_round(answer):
            return ""
        if not 1 <= len(likely) <= MOST:
            return ""
        return f"it is as if {', or as if '.join(likely)}."

    @cached_property
    def changes(self) -> list[Changed]:
        """Each change of the formula that makes another number of it, the likely ones first."""
        right = self.value
        other = {
            name: number * (1.37 + 0.0917 * i)
            for i, (name, number) in enumerate(self.numbers.items())
        }
        kinds = self._parts, self._edits, self._other_numbers, self._further_edits
        found = []
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            for rank, kind in enumerate(kinds):
                for said, texts in kind():
                    value = safely(None, self._worth, texts, self.numbers)
                    if value is None or same(value, right, 1e-3):
                        continue
                    elsewhere = safely(None, self._worth, texts, other)
                    found.append(Changed(self._read(said), rank, value, elsewhere))
        return found

    def _read(self, said: str) -> str:
        """What is said, with numbers for the names that stand in no lesson: those of more than one letter."""
        return QUOTED.sub(lambda piece: f"“{self._in_numbers(piece[1])}”", said)

    def _in_numbers(self, piece: str) -> str:
        if len(piece) > 1 and piece in self.texts:
            piece = self.texts[piece]  # how it is made says more than what it is
        tree = ast.parse(piece, mode="eval")
        for node in ast.walk(tree):
            if (
                isinstance(node, ast.Name)
                and len(node.id) > 1
                and node.id in self.values
            ):
                become(node, f"{self.values[node.id]:.5g}")
        return ast.unparse(tree)

    @cached_property
    def values(self) -> dict[str, Any]:
        """The numbers by their names, and those that the parts of the formula make."""
        known = dict(self.numbers)
        for name, text in self.texts.items():
            if name:
                known[name] = self._worth({"": text}, known)
        return known

    def _parts(self) -> Iterator[Variant]:
        """A part of the formula alone, or all of it in another unit."""
        for name, text in self.texts.items():
            if name:
                yield f"you had stopped at “{name}”", self._ending(name)
            for part in ast.walk(ast.parse(text, mode="eval").body):
                if isinstance(part, ast.BinOp):
                    code = ast.unparse(part)
                    yield f"you had stopped at “{code}”", self._ending(code)
        whole = self.texts[""]
        if len(np.shape(self.value)) == 1:
            yield "they stood in reverse order", self._ending(f"({whole})[::-1]")
        for unit, times in UNITS.items():
            said = f"{unit} times as much were asked. In which unit is it"
            yield said, self._ending(f"np.multiply({times}, {whole})")

    def _ending(self, text: str) -> dict[str, str]:
        """The same parts with another formula made of them."""
        return {**self.texts, "": text}

    def _other_numbers(self) -> Iterator[Variant]:
        """One quantity in place of another, or with another sign, or in per cent."""
        spare = [
            name
            for name, n in self.numbers.items()
            if isinstance(n, int | float) and name not in self._used
        ]
        for name in self._used:
            for other in spare:
                said = f"“{other}” stood in place of “{name}”"
                yield said, self._renamed({name: other})
        for one, other in combinations(self._rates, 2):
            said = f"“{one}” and “{other}” had changed places"
            yield said, self._renamed({one: other, other: one})
        for name in self._used:
            yield f"“{name}” had the other sign", self._renamed({name: f"-{name}"})
            if name in self._rates:
                said = f"“{name}” were left out throughout"
                yield said, self._renamed({name: "1"})
            else:
                yield f"“{name}” were 0 throughout", self._renamed({name: "0"})
            yield f"“{name}” were in per cent", self._renamed({name: f"100 * {name}"})

    def _renamed(self, others: Mapping[str, str]) -> dict[str, str]:
        """The formula with something else in place of some quantities."""
        parts = {name: ast.parse(text) for name, text in self.texts.items()}
        return {name: renamed(part, others) for name, part in parts.items()}

    def _edits(self) -> Iterator[Variant]:
        return self._edited(further_changes, simple_changes)

    def _further_edits(self) -> Iterator[Variant]:
        return self._edited(put_around)

    def _edited(
        self, *kinds: Callable[[ast.AST, Sequence[str]], Iterator[Change]]
    ) -> Iterator[Variant]:
        for changes in kinds:
            for name, text in self.texts.items():
                known = self._used if changes is put_around else self._rates
                for said, tree in changed(text, known, changes):
                    yield said, {**self.texts, name: ast.unparse(tree)}

    @cached_property
    def _used(self) -> list[str]:
        """The numbers that occur in the formula."""
        names = {
            node.id
            for text in self.texts.values()
            for node in ast.walk(ast.parse(text))
            if isinstance(node, ast.Name)
        }
        return [
            name
            for name, n in self.numbers.items()
            if name in names and isinstance(n, int | float)
        ]

    @cached_property
    def _rates(self) -> list[str]:
        """Those between 0 and 1, which are taken for one another."""
        return [name for name in self._used if 0 < self.numbers[name] < 1]

    @staticmethod
    def _worth(texts: Mapping[str, str], numbers: Mapping[str, Any]) -> Any:
        known: dict[str, Any] = {"np": np, "ceil": math.ceil, "sum": sum, **numbers}
        for name, text in texts.items():
            known[name] = eval(text, known)
        return known[""]


def _is_round(answer: Any) -> bool:
    """Whether each number of an answer has one or two digits, as many other calculations give."""
    return all(
        float(f"{x:.2g}") == x for x in np.ravel(np.asarray(answer, dtype=float))
    )
