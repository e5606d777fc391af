"""Another tape for an exercise, drawn from a seed: an answer that only knows the notebook's numbers is wrong on it."""

from __future__ import annotations

import zlib
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from rlrobot_grading.answers.values import Function
from rlrobot_grading.exercises.exercise import Exercise
from rlrobot_grading.exercises.question import Question

MOST_DRAWN = 3  # tapes until one shows all mistakes; one in fifty does not
Change = Callable[[float], float]


def secret_twin(exercise: Exercise | Question, seed: int) -> Exercise | None:
    """`exercise` with another tape; None where the tape is not what decides: a value, or a designed reward.

    The new tape has the old one's structure, and is drawn again if a typical mistake does not show in it. Where an
    exercise does not say how another case is drawn, all numbers with a fraction change by the same curve, which rises:
    what was equal stays equal, what was in order stays in order, and what lies between 0 and 1 stays there. Cases
    change places where none depends on the one before.
    """
    if type(exercise) is not Exercise:
        return None
    rng = np.random.default_rng(
        [seed, zlib.crc32(exercise.right.__qualname__.encode())]
    )
    for _ in range(MOST_DRAWN):
        twin = _drawn(exercise, rng)
        if all(_shows(twin, wrong) for wrong in twin.wrong_functions):
            break
    return twin


def _shows(exercise: Exercise, wrong: Function) -> bool:
    """Whether a mistake does something else than what is right in some case."""
    return any(
        not right.equals(exercise.mistaken(wrong, i))
        for i, right in enumerate(exercise.expected)
    )


def _drawn(exercise: Exercise, rng: np.random.Generator) -> Exercise:
    if exercise.another is not None:
        tape = [exercise.another(rng, step) for step in exercise.tape]
    else:
        tape = [_changed(step, _curve(rng)) for step in exercise.tape]
    if not exercise.memory:
        tape = [tape[i] for i in rng.permutation(len(tape))]
    return replace(exercise, tape=tape, memory=_changed(exercise.memory, _curve(rng)))


def _curve(rng: np.random.Generator) -> Change:
    """A rising curve through 0 that is steep nowhere: |f(x)| < |x|."""
    straight = rng.uniform(0.75, 0.9)
    bent = rng.uniform(0.02, 0.09)
    return lambda x: straight * x + bent * float(np.tanh(x))


def _changed(value: Any, change: Change) -> Any:
    """A copy of `value` in which the numbers with a fraction are changed; those of a probability still sum to 1."""
    if isinstance(value, np.ndarray) and value.dtype.kind == "f":
        new = np.array([change(x) for x in value.ravel().tolist()]).reshape(value.shape)
        is_probability = (
            value.ndim == 1 and (value >= 0).all() and abs(value.sum() - 1) < 1e-9
        )
        return new / new.sum() if is_probability else new
    if isinstance(value, float):
        return change(value) if np.isfinite(value) else value
    if type(value) in (list, tuple):
        return type(value)(_changed(part, change) for part in value)
    if isinstance(value, Mapping):
        return {key: _changed(part, change) for key, part in value.items()}
    return value
