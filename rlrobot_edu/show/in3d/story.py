"""What the page of a film tells: a headline, the moments that its slider marks, and the key of its colours."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import NamedTuple

from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.describe import (
    AMOUNTS,
    NEAR,
    aim_of,
    amounts_in,
    amounts_told,
    counted,
    loss_of,
)
from rlrobot_edu.show.numerals import signed
from rlrobot_edu.show.story import finding, moments_in

UNTOLD = {
    "green": "earned",
    "red": "lost much",
    "grey": "earned nothing or lost little",
}
Key = list[tuple[str, str]]  # colour of a line in the picture, and what it means


class Story(NamedTuple):
    """What is told of some steps.

    headline: what became of them, in a line; moments: numbers of scenes, from 0, and a word for each
    key: what the lines mean; aim: what else is seen
    """

    headline: str
    moments: list[tuple[int, str]]
    key: Key
    aim: str


def story(
    scenes: Sequence[Scene], rewards: Sequence[float], task: str, rules: str
) -> Story:
    """What is told of these steps.

    rewards: one for each scene; task: what the robot is to do, or empty; rules: what earns which reward, or empty
    """
    headline = finding(scenes, rewards, task, rules)
    moments = moments_in(scenes, rewards, rules)
    has_beams = any(len(scene.beams) for scene in scenes)
    told = key(rules, rewards, has_beams)
    return Story(headline, moments, told, aim_of(scenes[-1]))


def key(rules: str, rewards: Sequence[float], has_beams: bool) -> Key:
    """What the colours of the way mean: the rules by which something was paid, and amounts that none of them tells."""
    paid = Counter(f"{r:g}" for r in rewards)
    limit = loss_of(rewards)

    def colour(amounts: set[str]) -> str:
        its_own = [float(amount) for amount in amounts]
        if limit is not None and min(its_own) <= limit:
            return "red"
        return "green" if max(its_own) > 0 else "grey"

    told: Key = []
    for rule in rules.split("; "):
        met = amounts_in(rule) & paid.keys()
        if met:
            told.append((colour(met), rule))
    if told:
        first_colour, first = told[0]
        told[0] = (first_colour, first.removeprefix("else, "))
    explained = amounts_told(rules)
    others = [item for item in paid.most_common() if item[0] not in explained]
    if len(others) <= AMOUNTS:
        for amount, times in others:
            words = f"{signed(float(amount))} in {counted(times, 'step')}"
            told.append((colour({amount}), words))
    else:
        met = {colour({amount}) for amount, _ in others}
        told += [(name, word) for name, word in UNTOLD.items() if name in met]
    if has_beams:
        told.append(("orange", f"a laser finds something within {NEAR:g} m"))
    return told
