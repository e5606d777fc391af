"""Input and output variables: what a robot perceives and does, in words and units."""

import math
from bisect import bisect_left
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from rlrobot_edu.checks import MOST_BINS, check_index, check_numbers
from rlrobot_edu.keywords import suggests_keywords


def _different(what: str, given: Sequence[float]) -> tuple[float, ...]:
    """The given numbers, finite and all different. Raises ValueError that names `what`."""
    values = check_numbers(what, given, finite=True)
    if len(set(values)) < len(values):
        raise ValueError(
            f"{what} must be different from one another, got {list(values)!s:.200}"
        )
    return values


def _check_texts(owner: str, *texts: object) -> None:
    if not all(isinstance(text, str) and len(text) <= 100 for text in texts):
        raise ValueError(
            f"{owner:.200}: name and unit must be short texts, got {texts!r:.200}"
        )


@dataclass(frozen=True)
class Bin:
    """One interval of an input variable: readings with ``low < reading <= high`` fall into it, also around the circle.

    A sensor's lowest reading belongs to its first bin. Of a variable with `values`, low and high are the value itself.

    ``reading`` is one inside the bin, so a decoded state can be encoded again.
    """

    index: int
    low: float
    high: float
    unit: str
    reading: float

    def __str__(self) -> str:
        span = f"{self.low:g}–{self.high:g}"
        if self.low == self.high:
            span = f"{self.reading:g}"
        return f"{span} {self.unit}" if self.unit else span


@suggests_keywords
@dataclass(frozen=True)
class InputVariable:
    """A reading of the robot and how it is cut into bins. Give exactly one of `cuts`, `sectors` and `values`.

    Parameters
    ----------
    name : str
        The robot's sensor that is read.
    cuts : sequence of float [unit], optional
        Increasing cut points c1 < … < ck; x <= c1 is bin 0, ck < x is bin k.
    unit : str
        The sensor's unit, such as ``m``.
    sectors : int, optional
        Number of equal sectors of the circle; sector 0 is centred on angle 0 [rad], numbers grow to the left.
    values : sequence of float [unit], optional
        The readings themselves, for a sensor that is discrete already; bin i is values[i].
    low, high : float [unit]
        Range of valid readings, taken from the robot where a task leaves it open.

    Raises
    ------
    ValueError
        If the bins are not well defined.
    """

    name: str
    cuts: Sequence[float] | None = None
    unit: str = ""
    sectors: int | None = None
    values: Sequence[float] | None = None
    low: float = -math.inf
    high: float = math.inf

    def __post_init__(self) -> None:
        owner = f"input {self.name!r:.200}"
        _check_texts(owner, self.name, self.unit)
        check_numbers(f"{owner}: low and high", (self.low, self.high))
        given = [
            kind
            for kind in ("cuts", "sectors", "values")
            if getattr(self, kind) is not None
        ]
        if len(given) != 1:
            found = " and ".join(given) or "none"
            raise ValueError(
                f"{owner}: give exactly one of cuts, sectors and values, not {found}"
            )
        if self.cuts is not None:
            cuts = check_numbers(f"{owner}: cuts", self.cuts, finite=True)
            # The dataclass is frozen: only object.__setattr__ can still set its fields.
            object.__setattr__(self, "cuts", cuts)
            got = f"got {list(cuts)!s:.200}"
            if any(b <= a for a, b in pairwise(cuts)):
                raise ValueError(
                    f"{owner}: cuts must increase from left to right without repeats, {got}"
                )
            if not (self.low < cuts[0] and cuts[-1] < self.high):
                raise ValueError(
                    f"{owner}: cuts must lie inside the sensor's range {self._range}, {got}"
                )
        elif self.values is not None:
            values = _different(f"{owner}: values", self.values)
            object.__setattr__(self, "values", values)
        elif not (isinstance(self.sectors, int) and 2 <= self.sectors <= MOST_BINS):
            limits = f"an integer of at least 2 and at most {MOST_BINS:,}"
            raise ValueError(
                f"{owner}: sectors must be {limits}, got {self.sectors!r:.200}"
            )

    @property
    def _range(self) -> str:
        return f"{float(self.low):g} to {float(self.high):g} {self.unit}"

    @property
    def n_bins(self) -> int:
        """Number of bins."""
        if self.cuts is not None:
            return len(self.cuts) + 1
        return self.sectors or len(self.values or ())

    def bin(self, reading: float) -> int:
        """Number of the bin that a reading falls into.

        Parameters
        ----------
        reading : float [unit]
            The sensor's number.

        Returns
        -------
        int
            0 to n_bins − 1.

        Raises
        ------
        ValueError
            If the reading is NaN or out of range.
        """
        try:
            reading = math.ldexp(reading, 0)  # unlike float(), it takes no text
        except (TypeError, ValueError, OverflowError):
            raise ValueError(
                f"input {self.name!r}: reading {reading!r:.200} is not a number"
            ) from None
        is_inside = self.low <= reading <= self.high  # false for NaN as well
        if not (is_inside and math.isfinite(reading)):
            raise ValueError(
                f"input {self.name!r}: reading {reading:g} is outside {self._range}; check the sensor"
            )
        if self.cuts is not None:
            return bisect_left(self.cuts, reading)
        if self.sectors is not None:
            turned = reading * self.sectors / (2 * math.pi)
            return math.ceil(turned - 0.5) % self.sectors
        if self.values is None or reading not in self.values:
            raise ValueError(
                f"input {self.name!r}: reading {reading:g} is none of {self.values!s:.200}"
            )
        return self.values.index(reading)

    def decode(self, index: int) -> Bin:
        """The bin with this number, and a reading inside it.

        Parameters
        ----------
        index : int
            0 to n_bins − 1.

        Returns
        -------
        Bin
            Its limits and a reading [unit].

        Raises
        ------
        ValueError
            If there is no such bin.
        """
        index = check_index("bin", index, self.n_bins)
        if self.values is not None:
            value = self.values[index]
            return Bin(index, value, value, self.unit, value)
        if self.sectors is not None:
            width = 2 * math.pi / self.sectors
            centre = math.remainder(index * width, 2 * math.pi)
            return Bin(index, centre - width / 2, centre + width / 2, self.unit, centre)
        limits = (self.low, *(self.cuts or ()), self.high)
        low, high = limits[index : index + 2]
        reading = high
        if not math.isfinite(high):
            reading = max(low + 1.0, math.nextafter(low, math.inf))
        return Bin(index, low, high, self.unit, reading)


@suggests_keywords
@dataclass(frozen=True)
class OutputVariable:
    """A command to the robot, and the values that it may take.

    Parameters
    ----------
    name : str
        The robot's actuator.
    values : sequence of float [unit]
        The possible commands, in the order of the actions.
    unit : str
        The actuator's unit, such as ``rad/s``.
    words : sequence of str, optional
        A name for each value, for an output whose numbers say little by themselves.

    Raises
    ------
    ValueError
        If the values or the words are not well defined.
    """

    name: str
    values: Sequence[float]
    unit: str = ""
    words: Sequence[str] | None = None

    def __post_init__(self) -> None:
        owner = f"output {self.name!r:.200}"
        _check_texts(owner, self.name, self.unit)
        values = _different(f"{owner}: values", self.values)
        # The dataclass is frozen: only object.__setattr__ can still set its fields.
        object.__setattr__(self, "values", values)
        if self.words is not None:
            words = tuple(self.words) if isinstance(self.words, list | tuple) else ()
            are_texts = all(isinstance(word, str) for word in words)
            if len(words) != len(values) or not are_texts:
                expected = f"one text for each of the {len(values)} values"
                raise ValueError(
                    f"{owner}: words must be {expected}, got {self.words!r:.200}"
                )
            object.__setattr__(self, "words", words)


Variable = InputVariable | OutputVariable
