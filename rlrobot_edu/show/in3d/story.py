"""What the page of a film tells: a headline, the moments that its slider marks, and the key of its colours."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import groupby
from typing import NamedTuple

from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.describe import (
    AMOUNTS,
    NEAR,
    amounts_in,
    loss_of,
    losses,
    rolls,
    sought,
)
from rlrobot_edu.show.numerals import signed

REACHED, STAYED, BUMP, LOSS = "reached", "longest stay", "bump", "loss"
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
    words = [sought(scenes[-1])]
    if any(solid.name == "field" for solid in scenes[-1].solids):
        words.append("The pale field is only painted on the table.")
    aim = " ".join(filter(None, words))
    stays = _stays(scenes, rewards, rules)
    lost = _losses(scenes, rewards)
    earned = _earned(rewards) if stays is None else _reached(stays, rewards)
    headline = ", ".join(filter(None, (earned, _lost(scenes, rewards, lost))))
    headline = f"{task}: {headline}" if task else headline[0].upper() + headline[1:]
    moments = sorted([*_arrivals(stays or []), *lost])
    has_beams = any(len(scene.beams) for scene in scenes)
    return Story(headline, moments, key(rules, rewards, has_beams), aim)


def _stays(
    scenes: Sequence[Scene], rewards: Sequence[float], rules: str
) -> list[range] | None:
    """When the robot was where it is to go: each time from its first scene to its last.

    None if it is to go nowhere, or if the rules do not explain what was paid: then nobody can say.
    """
    amounts = amounts_in_all(rules)
    is_told = all(f"{r:g}" in amounts for r in rewards)
    if not sought(scenes[-1]) or not amounts or not is_told:
        return None
    most = max(map(float, amounts))
    stays = []
    for is_there, steps in groupby(range(len(rewards)), lambda i: rewards[i] == most):
        if is_there:
            first, *others = steps
            stays.append(range(first, first + len(others) + 1))
    return stays


def amounts_in_all(rules: str) -> set[str]:
    """The rewards that the rules name, parted by semicolons."""
    amounts: set[str] = set()
    for rule in rules.split("; "):
        amounts |= amounts_in(rule)
    return amounts


def _reached(stays: list[range], rewards: Sequence[float]) -> str:
    """Whether and when a robot that is to go somewhere was there."""
    steps = len(rewards)
    if not stays:
        return f"not reached in {steps} steps"
    first = stays[0].start
    there = sum(map(len, stays))
    paid = _each(rewards[first], there)
    return f"reached in step {first + 1}, there in {there} of {steps} steps ({paid})"


def _earned(rewards: Sequence[float]) -> str:
    """How often a robot got the largest reward."""
    most, steps = max(rewards), len(rewards)
    if most <= 0:
        return f"reward {signed(sum(rewards) / steps)} a step in {steps} steps"
    return f"reward {signed(most)} in {list(rewards).count(most)} of {steps} steps"


def _lost(
    scenes: Sequence[Scene], rewards: Sequence[float], lost: list[tuple[int, str]]
) -> str:
    """How often it bumped, or lost much in another way, and what that cost; empty for an arm that lost nothing."""
    if lost:
        amounts = [rewards[i] for i, _ in lost]
        kind = BUMP if all(word == BUMP for _, word in lost) else LOSS
        several = {BUMP: "bumps", LOSS: "losses"}[kind]
        count = f"1 {kind}" if len(lost) == 1 else f"{len(lost)} {several}"
        cost = f"{signed(sum(amounts))} in all"
        if len(set(amounts)) == 1:
            cost = _each(amounts[0], len(lost))
        return f"{count} ({cost})"
    if not rolls(scenes[0]):
        return ""
    has_bumped = any(scene.bumped for scene in scenes)
    return "no costly bump" if has_bumped else "no bump"


def _each(reward: float, times: int) -> str:
    return f"{signed(reward)} each" if times > 1 else signed(reward)


def _arrivals(stays: list[range]) -> list[tuple[int, str]]:
    """When it first came, and when it came to stay longest."""
    if not stays:
        return []
    longest = max(stays, key=len)
    arrivals = [(stays[0].start, REACHED)]
    if longest is not stays[0]:
        arrivals.append((longest.start, STAYED))
    return arrivals


def _losses(scenes: Sequence[Scene], rewards: Sequence[float]) -> list[tuple[int, str]]:
    """Each scene in which it lost much, and whether that was a bump."""
    loses = losses(rewards)
    return [
        (i, BUMP if scene.bumped else LOSS)
        for i, scene in enumerate(scenes)
        if loses[i]
    ]


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
    explained = amounts_in_all(rules)
    others = [item for item in paid.most_common() if item[0] not in explained]
    if len(others) <= AMOUNTS:
        for amount, times in others:
            steps = "1 step" if times == 1 else f"{times} steps"
            told.append((colour({amount}), f"{signed(float(amount))} in {steps}"))
    else:
        met = {colour({amount}) for amount, _ in others}
        told += [(name, word) for name, word in UNTOLD.items() if name in met]
    if has_beams:
        told.append(("orange", f"a laser finds something within {NEAR:g} m"))
    return told
