"""Rows that a model has not seen: what it says of them, and whether the step before tells more than it does."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.models.recording import Recording

SHUFFLES = (
    99  # so that states which tell all are suspected in one of a hundred recordings
)


class HeldBack(NamedTuple):
    """What the model of the first four fifths of a recording says of the last fifth, shown in words.

    rows: how many were held back; new_rows: those of them whose pair (s, a) the model does not know
    pairs_tried: different pairs in the others; pairs_known: pairs that the model knows
    reward, reward_foretold: mean reward of these others, and what the model says of their pairs
    guessed: probability that the model gave to what came next, on average
    guessed_from_two: the same where the step before counts, too; both are of rows whose two steps are known
    gained_by_chance: the most that the step before gained where it cannot tell anything, since what came next was
        shuffled among the rows of each pair; NaN if no two steps are known
    """

    rows: int
    new_rows: int
    pairs_tried: int
    pairs_known: int
    reward: float
    reward_foretold: float
    guessed: float
    guessed_from_two: float
    gained_by_chance: float

    @property
    def verdict(self) -> str:
        """What may be concluded, in a sentence."""
        gained = self.guessed_from_two - self.guessed
        if gained > self.gained_by_chance:
            return (
                "The step before tells what comes next better than the state alone: states lump together what differs, "
                "so the model may promise what no robot can keep. Cut the bins more finely, or add an input."
            )
        if np.isnan(gained) or 2 * self.pairs_tried < self.pairs_known:
            return (
                "Too few pairs were tried in these rows to tell; measure on the robot."
            )
        return "Nothing odd in these rows. That is no proof: measure on the robot."

    def __repr__(self) -> str:
        return f"""\
rows held back       {self.rows}, the last fifth; the model is made of the others
pairs (s, a) tried   {self.pairs_tried} of {self.pairs_known} that the model knows; {self.new_rows} rows try others
mean reward          {self.reward:.3f} a step, foretold {self.reward_foretold:.3f}
what comes next      guessed right {self.guessed:.1%}, from this step and the one before {self.guessed_from_two:.1%} \
(by chance {self.gained_by_chance:+.1%})
{self.verdict}"""


def hold_back(recording: Recording) -> HeldBack:
    """Compare the last fifth of the rows with what the model of the others says, see `SampleModel.hold_back`."""
    n_first = len(recording) * 4 // 5
    if n_first == 0:
        raise ValueError(
            "a recording of 1 row has no fifth to hold back; give a longer one"
        )
    first = np.arange(n_first)
    last = np.arange(n_first, len(recording))
    pair = recording.s * recording.source.actions.n + recording.a
    before = np.append(-1, pair[:-1])
    before[recording.step == 0] = -1  # nothing comes before an episode
    two_steps = _numbered(before, pair)
    after = _numbered(recording.s_next, recording.r, recording.terminated)

    known = last[np.isin(pair[last], pair[first])]
    foretold = _mean_by_key(pair[first], recording.r[first], pair[known])
    both_known = last[np.isin(two_steps[last], two_steps[first])]
    guessed = _guessed(pair, after, first, both_known)
    guessed_from_two = _guessed(two_steps, after, first, both_known)
    gains = []
    rng = np.random.default_rng(0)
    by_pair = np.argsort(pair, kind="stable")
    for _ in range(SHUFFLES):
        shuffled = np.empty_like(after)
        shuffled[by_pair] = after[np.argsort(pair + rng.random(len(pair)))]
        gains.append(
            _guessed(two_steps, shuffled, first, both_known)
            - _guessed(pair, shuffled, first, both_known)
        )
    return HeldBack(
        rows=len(last),
        new_rows=len(last) - len(known),
        pairs_tried=len(np.unique(pair[known])),
        pairs_known=len(np.unique(pair[first])),
        reward=_mean(recording.r[known]),
        reward_foretold=_mean(foretold),
        guessed=guessed,
        guessed_from_two=guessed_from_two,
        gained_by_chance=max(gains),
    )


def _mean(numbers: NDArray[np.float64]) -> float:
    return float(numbers.mean()) if len(numbers) else np.nan


def _numbered(*columns: NDArray[np.generic]) -> NDArray[np.intp]:
    """A number for each different row of these columns, arrays (n,); array (n,)."""
    rows = np.stack([column.astype(np.float64) for column in columns])
    return np.unique(rows, axis=1, return_inverse=True)[1].ravel()


def _mean_by_key(
    keys: NDArray[np.int64], numbers: NDArray[np.float64], asked: NDArray[np.int64]
) -> NDArray[np.float64]:
    """The mean of the numbers, array (n,), that have the same key as each one asked for, which all are among them."""
    distinct, place = np.unique(keys, return_inverse=True)
    means = np.bincount(place, numbers) / np.bincount(place)
    return means[np.searchsorted(distinct, asked)]


def _guessed(
    keys: NDArray[np.int64],
    after: NDArray[np.intp],
    first: NDArray[np.intp],
    asked: NDArray[np.intp],
) -> float:
    """How often what came after a row `asked` came after the `first` rows of its key: the share, a mean over rows."""
    same = keys * (after.max() + 1) + after
    times = _times(same[first], same[asked])
    return _mean(times / _times(keys[first], keys[asked]))


def _times(numbers: NDArray[np.int64], asked: NDArray[np.int64]) -> NDArray[np.intp]:
    """How often each number asked for is among the others, array (asked,)."""
    ordered = np.sort(numbers)
    after = np.searchsorted(ordered, asked, side="right")
    return after - np.searchsorted(ordered, asked, side="left")
