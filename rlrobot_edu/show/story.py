"""What a film tells in words: its title, the steps that tell most, and a caption for each of them."""

from collections.abc import Sequence

import numpy as np

from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.describe import counted, gap_of, is_fixed, losses, path_of
from rlrobot_edu.show.numerals import signed

AT_OBJECT = (
    0.05  # a gripper that is so near has reached the object, as in the paper [m]
)


def finding(scenes: Sequence[Scene], rewards: Sequence[float], task: str = "") -> str:
    """What became of these steps in one sentence.

    rewards: one for each scene; task: what the robot is to do, if that is known
    """
    text = (
        _reached(scenes) or f"{_lost(scenes, rewards)}, {_earned(scenes[0], rewards)}"
    )
    if task:
        return f"{task}: {text}"
    return text[0].upper() + text[1:]


def _reached(scenes: Sequence[Scene]) -> str:
    """When an arm on a table reached its object, and whether it stayed; empty for other robots."""
    nearest = nearest_step(scenes)
    if nearest is None or not is_fixed(scenes[0]):
        return ""
    at = [_is_at(scene) for scene in scenes]
    steps = counted(len(scenes), "step")
    if not any(at):
        gap = _away(scenes[nearest])
        return f"not reached in {steps}; nearest in step {nearest + 1}, {gap} away"
    said = f"reached in step {nearest + 1}"
    if not all(at[nearest:]):
        return f"{said}, there in {sum(at)} of {steps}"
    if nearest == len(scenes) - 1:
        return f"{said}, the last one"
    return f"{said}, and it stays there to step {len(scenes)}"


def _is_at(scene: Scene) -> bool:
    """Whether the gripper has reached the object."""
    gap = gap_of(scene)
    return gap is not None and gap <= AT_OBJECT


def _away(scene: Scene) -> str:
    """How far the gripper is from the object; empty without both."""
    gap = gap_of(scene)
    return "" if gap is None else f"{100 * gap:.0f} cm"


def _lost(scenes: Sequence[Scene], rewards: Sequence[float]) -> str:
    """How often the robot bumped, or lost something else."""
    steps = counted(len(rewards), "step")
    loses = losses(rewards)
    bumps = [scene.bumped for scene in scenes]
    if any(loses):
        all_bump = all(
            bump for bump, is_loss in zip(bumps, loses, strict=True) if is_loss
        )
        return f"{counted(sum(loses), 'bump' if all_bump else 'loss')} in {steps}"
    if is_fixed(scenes[0]):
        return steps
    kind = "costly bump" if any(bumps) else "bump"  # to touch a wall may cost nothing
    return f"no {kind} in {steps}"


def _earned(scene: Scene, rewards: Sequence[float]) -> str:
    """How often the robot got the largest reward."""
    rewards = list(rewards)
    most = max(rewards)
    if most <= 0:
        return f"{signed(float(np.mean(rewards)))} a step"
    best, times = best_step(scene, rewards), rewards.count(most)
    if best is None:
        return f"{signed(most)} in {times} of them"
    if times == 1:
        return f"{signed(most)} in step {best + 1}"
    return f"{signed(most)} in {times} of them, first in step {best + 1}"


def best_step(scene: Scene, rewards: Sequence[float]) -> int | None:
    """The step, counted from 0, with the first of the largest rewards; None where it is nothing to look at.

    A robot that drives is paid its largest reward all the time, an arm when it is there.
    """
    rewards = list(rewards)
    most = max(rewards)
    is_rare = is_fixed(scene) or rewards.count(most) == 1
    return rewards.index(most) if most > 0 and is_rare else None


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
    scenes: Sequence[Scene], rewards: Sequence[float], most: int
) -> list[int]:
    """The steps, counted from 0, that tell most of a film.

    These are the first, the last, the one that the title names, those with which losses begin, and then those at which
    the robot is farthest from where it is in the others.
    """
    loses = losses(rewards)
    chosen = {0, len(scenes) - 1}
    named = nearest_step(scenes)
    if named is None:
        named = best_step(scenes[0], rewards)
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
