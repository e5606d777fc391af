"""What a film tells in words: its title, the moments and the steps that tell most, and a caption for each step."""

from collections.abc import Sequence
from itertools import groupby

import numpy as np

from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.describe import (
    amounts_told,
    counted,
    gap_of,
    is_fixed,
    losses,
    path_of,
    sought,
)
from rlrobot_edu.show.numerals import signed

# a gripper that is so near has reached the object, as in the paper [m]
AT_OBJECT = 0.05
REACHED, STAYED, BUMP, LOSS = "reached", "longest stay", "bump", "loss"


def finding(
    scenes: Sequence[Scene], rewards: Sequence[float], task: str = "", rules: str = ""
) -> str:
    """What became of these steps in one sentence.

    rewards: one for each scene; task: what the robot is to do, if that is known; rules: what earns which reward
    """
    stays = stays_in(scenes, rewards, rules)
    text = _earned(rewards) if stays is None else _arrived(scenes, rewards, stays)
    lost = _lost(scenes, rewards)
    if lost:
        text = f"{text}, {lost}"
    if task:
        return f"{task}: {text}"
    return text[0].upper() + text[1:]


def stays_in(
    scenes: Sequence[Scene], rewards: Sequence[float], rules: str
) -> list[range] | None:
    """When the robot was where it is to go: each time from its first scene to its last, counted from 0.

    None if it is to go nowhere, or if nobody can say: of an arm the picture tells, of others the largest reward, where
    the rules explain all that was paid.
    """
    if is_fixed(scenes[0]) and gap_of(scenes[0]) is not None:
        is_there = [_is_at(scene) for scene in scenes]
    else:
        amounts = amounts_told(rules)
        is_told = all(f"{r:g}" in amounts for r in rewards)
        if not sought(scenes[-1]) or not amounts or not is_told:
            return None
        most = max(map(float, amounts))
        is_there = [r == most for r in rewards]
    stays = []
    for there, steps in groupby(range(len(scenes)), lambda i: is_there[i]):
        if there:
            first, *others = steps
            stays.append(range(first, first + len(others) + 1))
    return stays


def _is_at(scene: Scene) -> bool:
    """Whether the gripper has reached the object."""
    gap = gap_of(scene)
    return gap is not None and gap <= AT_OBJECT


def _away(scene: Scene) -> str:
    """How far the gripper is from the object; empty without both."""
    gap = gap_of(scene)
    return "" if gap is None else f"{100 * gap:.0f} cm"


def _arrived(
    scenes: Sequence[Scene], rewards: Sequence[float], stays: list[range]
) -> str:
    """Whether and when a robot that is to go somewhere was there, and what that paid."""
    steps = counted(len(scenes), "step")
    if not stays:
        nearest = nearest_step(scenes)
        if nearest is None:
            return f"not reached in {steps}"
        gap = _away(scenes[nearest])
        return f"not reached in {steps}; nearest in step {nearest + 1}, {gap} away"
    first = stays[0].start
    paid = [rewards[i] for stay in stays for i in stay]
    text = f"reached in step {first + 1}, there in {len(paid)} of {steps}"
    if stays[0].stop == len(scenes) and len(paid) > 1:
        text = f"reached in step {first + 1}, and it stays there to step {len(scenes)}"
    return f"{text} ({_amount(paid)})" if any(paid) else text


def _earned(rewards: Sequence[float]) -> str:
    """How often the robot got the largest reward."""
    rewards = list(rewards)
    most, steps = max(rewards), len(rewards)
    if most <= 0:
        return f"reward {signed(float(np.mean(rewards)))} a step in {counted(steps, 'step')}"
    times = rewards.count(most)
    if times == 1:
        return f"reward {signed(most)} in step {rewards.index(most) + 1} of {steps}"
    return f"reward {signed(most)} in {times} of {steps} steps"


def _lost(scenes: Sequence[Scene], rewards: Sequence[float]) -> str:
    """How often it bumped, or lost much in another way, and what that cost; empty for an arm that lost nothing."""
    lost = losses_in(scenes, rewards)
    if lost:
        is_bump = all(word == BUMP for _, word in lost)
        cost = _amount([rewards[i] for i, _ in lost])
        return f"{counted(len(lost), BUMP if is_bump else LOSS)} ({cost})"
    if is_fixed(scenes[0]):
        return ""
    # to touch a wall may cost nothing
    has_bumped = any(scene.bumped for scene in scenes)
    return "no costly bump" if has_bumped else "no bump"


def losses_in(
    scenes: Sequence[Scene], rewards: Sequence[float]
) -> list[tuple[int, str]]:
    """Each scene in which it lost much, counted from 0, and whether that was a bump."""
    loses = losses(rewards)
    return [
        (i, BUMP if scene.bumped else LOSS)
        for i, scene in enumerate(scenes)
        if loses[i]
    ]


def _amount(paid: Sequence[float]) -> str:
    """What these steps were paid: each the same, or all together."""
    if len(set(paid)) > 1:
        return f"{signed(sum(paid))} in all"
    return signed(paid[0]) if len(paid) == 1 else f"{signed(paid[0])} each"


def moments_in(
    scenes: Sequence[Scene], rewards: Sequence[float], rules: str
) -> list[tuple[int, str]]:
    """Numbers of scenes, from 0, and a word for each: when it came, when it came to stay longest, its losses."""
    stays = stays_in(scenes, rewards, rules)
    arrivals = []
    if stays:
        longest = max(stays, key=len)
        arrivals.append((stays[0].start, REACHED))
        if longest is not stays[0]:
            arrivals.append((longest.start, STAYED))
    return sorted([*arrivals, *losses_in(scenes, rewards)])


def nearest_step(scenes: Sequence[Scene]) -> int | None:
    """The step, counted from 0, in which a gripper first reached the object; if none did, the one that came nearest.

    None where there is no gripper, or no object.
    """
    gaps = [gap_of(scene) for scene in scenes]
    known = [gap for gap in gaps if gap is not None]
    if len(known) < len(scenes):
        return None
    for i, gap in enumerate(known):
        if gap <= AT_OBJECT:
            return i
    return known.index(min(known))


def key_steps(
    scenes: Sequence[Scene], rewards: Sequence[float], rules: str, most: int
) -> list[int]:
    """The steps, counted from 0, that tell most of a film.

    These are the first, the last, the one that the title names, those with which losses begin, and then those at which
    the robot is farthest from where it is in the others.
    """
    loses = losses(rewards)
    chosen = {0, len(scenes) - 1}
    named = _named_step(scenes, rewards, rules)
    if named is not None:
        chosen.add(named)
    for i, lost in enumerate(loses):
        begins = lost and not (i and loses[i - 1])
        if begins and len(chosen) < most:
            chosen.add(i)
    places = path_of(scenes)
    if len(places) < len(scenes):
        return sorted(chosen)  # in some there is no robot
    while len(chosen) < most:
        others = places[sorted(chosen)]
        apart = np.linalg.norm(places[:, None] - others, axis=2).min(axis=1)
        farthest = int(apart.argmax())
        if apart[farthest] == 0:
            break
        chosen.add(farthest)
    return sorted(chosen)


def _named_step(
    scenes: Sequence[Scene], rewards: Sequence[float], rules: str
) -> int | None:
    """The step, counted from 0, that the title names; None if it names none."""
    stays = stays_in(scenes, rewards, rules)
    if stays:
        return stays[0].start
    if stays is not None:
        return nearest_step(scenes)
    rewards = list(rewards)
    most = max(rewards)
    return rewards.index(most) if most > 0 and rewards.count(most) == 1 else None


def caption(scenes: Sequence[Scene], rewards: Sequence[float], i: int) -> str:
    """What happens in step i, counted from 0, such as ``Step 41: bump, reward −2, sum +87.38``."""
    paid = f"reward {signed(rewards[i])}, sum {signed(float(sum(rewards[: i + 1])))}"
    return f"Step {i + 1}: {', '.join([*_events(scenes, rewards, i), paid])}"


def _events(scenes: Sequence[Scene], rewards: Sequence[float], i: int) -> list[str]:
    """What is to be said of step i besides its reward."""
    scene = scenes[i]
    events = []
    if i == 0:
        events.append("start")
    elif i == len(scenes) - 1:
        events.append("end")
    if losses(rewards)[i]:
        events.append(what_was_lost(scene))
    if _is_at(scene):
        is_first = i == nearest_step(scenes)
        events.append("reaches the object" if is_first else "at the object")
    elif gap_of(scene) is not None:
        events.append(f"{_away(scene)} from the object")
    return events


def what_was_lost(scene: Scene) -> str:
    """The word for a step that lost much."""
    return "bump" if scene.bumped else "a loss"
