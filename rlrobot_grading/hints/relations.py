"""How the right numbers and the learner's are related in every case: the same but for a sign, an order, a factor …"""

from collections.abc import Iterator, Sequence

import numpy as np

from rlrobot_grading.answers.values import same, show

FLOAT32 = 1e-6  # relative difference of a number that had seven digits
DIGITS = range(5)  # after the point, to which an answer may have been rounded


def relations(
    expected: Sequence[np.ndarray], got: Sequence[np.ndarray]
) -> Iterator[str]:
    """Relations between the right numbers and the learner's that hold in every case."""
    pairs = list(zip(expected, got, strict=True))
    if all(same(y, got[0]) for y in got):
        yield f"your function always returns {show(got[0])}, whatever its arguments are."
    if all(same(x, y, FLOAT32) for x, y in pairs):
        yield (
            "your numbers are right in their first digits only. Leave rounding and float32 out: Python's own numbers "
            "have 16 digits."
        )
    for digits in DIGITS:
        if all(same(np.round(x, digits), y) for x, y in pairs):
            after = (
                f"to {digits} digits after the point" if digits else "to whole numbers"
            )
            yield f"your numbers are rounded {after}. Return them as they are: rounding is for showing."
    if all(same(np.trunc(x), y) or same(np.floor(x), y) for x, y in pairs):
        yield "your numbers are whole: what comes after the point is missing, as int(…) and // leave it out."
    if all(same(-x, y) for x, y in pairs):
        yield "the sign is the wrong way round, in every case."
    if all(x.ndim for x in expected) and all(same(x[::-1], y) for x, y in pairs):
        yield "the right numbers, in reverse order."
    if all(x.ndim for x in expected) and all(
        same(np.sort(x), np.sort(y)) for x, y in pairs
    ):
        yield "the right numbers, in another order."
    with np.errstate(invalid="ignore", over="ignore"):  # infinity − infinity
        apart = {round(float(d), 9) for x, y in pairs for d in np.ravel(y - x)}
        times = {
            round(float(t), 9)
            for x, y in pairs
            for t in np.ravel(y[x != 0] / x[x != 0])
        }
    if len(apart) == 1:
        d = apart.pop()
        yield f"your numbers are too {'large' if d > 0 else 'small'} by {show(abs(d))}, always."
    if len(times) == 1 and all(same(x * next(iter(times)), y) for x, y in pairs):
        t = times.pop()
        if t == 0:
            yield "your numbers are 0, always."
        yield f"your numbers are {show(t)} times the right ones, always."
