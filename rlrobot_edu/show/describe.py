"""What all views of a robot share, from above or in 3D: its scenes, its path, a sentence about them."""

import math
import re
from collections import Counter
from collections.abc import Iterable, Sequence

import gymnasium
import numpy as np

from rlrobot_edu.learning.size import Env
from rlrobot_edu.robots.robot import Robot
from rlrobot_edu.robots.scene import Scene, Solid
from rlrobot_edu.show.numerals import signed

JUMP = 0.25  # of the room's width; a robot that moves farther in one step was put there
NEAR = 0.8  # films draw only what a laser finds nearer than this [m]; the paper's robots tell no distances farther off
CLEAR = 5  # a loss is at least this part of the largest gain or loss
AMOUNTS = 4  # that a key tells of those which no rule explains
Scenes = Scene | Sequence[Scene]  # one, or several in the order of time


def robot_of(env: Env) -> Robot:
    """The robot of an environment, behind its wrappers. Raises ValueError if there is none."""
    robot: Robot | None = getattr(getattr(env, "unwrapped", None), "robot", None)
    if robot is None:
        kind = type(env).__name__
        raise ValueError(
            f"there is no robot to look at: give an environment that rl.make_env(task) makes, got {kind}"
        )
    return robot


def as_scenes(given: Scenes | Env) -> list[Scene]:
    """The given scenes, or the one that an environment shows now.

    Raises ValueError if there is none, and for anything else.
    """
    several = []
    if isinstance(given, gymnasium.Env):
        several = [robot_of(given).scene()]
    elif isinstance(given, Scene):
        several = [given]
    elif isinstance(given, Iterable):
        several = list(given)
    if not several or not all(isinstance(scene, Scene) for scene in several):
        kind = type(given).__name__
        raise ValueError(
            f"a picture needs an environment with a robot, or one scene or several, got {kind}"
        )
    return several


def body_of(scene: Scene) -> Solid | None:
    """The part of a robot that its path follows: of an arm its gripper. None if the scene has no robot."""
    for solid in scene.solids:
        if solid.name == "robot/body":
            return solid
    return None


def path_of(scenes: Sequence[Scene]) -> np.ndarray:
    """Where the robot's body was in each scene that has one; array (n, 3) [m]."""
    bodies = map(body_of, scenes)
    places = [body.pose[:3, 3] for body in bodies if body is not None]
    return np.reshape(places, (-1, 3))


def jumps(a: Scene, b: Scene) -> bool:
    """Whether the robot was put from a to b: it is too far for one step."""
    way = path_of((a, b))
    if len(way) < 2:
        return False
    x_min, y_min, x_max, y_max = b.bounds
    distance = float(np.linalg.norm(way[1] - way[0]))
    return distance > JUMP * max(x_max - x_min, y_max - y_min)


def loss_of(rewards: Sequence[float]) -> float | None:
    """The largest reward that counts as a loss, as that of a bump does; None if none of these is one.

    A loss is no less than a fifth of what is gained or lost at most: less is what a step costs anyway. Where all steps
    are paid the same, none of them is a loss.
    """
    if len(set(rewards)) < 2:
        return None
    limit = -max(abs(r) for r in rewards) / CLEAR
    return limit if min(rewards) <= limit else None


def losses(rewards: Sequence[float]) -> list[bool]:
    """Which steps lost much."""
    limit = loss_of(rewards)
    return [limit is not None and r <= limit for r in rewards]


def task_of(env: Env) -> str:
    """What the robot is to do, as its task's file begins, such as ``Wander in a maze``; empty if nothing says so."""
    task = getattr(env.unwrapped, "task", None)
    if task is None:
        return ""
    # a full stop ends it, the point of a number does not
    first, *_ = re.split(r"[:\n]|\.(?=\s|$)", task.description)
    return first.strip()


def rules_of(env: Env) -> str:
    """What earns which reward, as the docstring of the task's file says after ``Rewards:``; empty if it does not."""
    task = getattr(env.unwrapped, "task", None)
    description = task.description if task is not None else ""
    found = re.search(r"^Rewards:\s*(.*?)\.(?=\s|$)", description, re.S | re.M)
    return " ".join(found[1].split()) if found else ""


def rules_met(rules: str, rewards: Sequence[float]) -> str:
    """Those of the rules, parted by semicolons, by which something was paid; then what was paid by none of them.

    So a reader can follow each sum. Empty if nothing was paid.
    """
    paid = Counter(f"{r:g}" for r in rewards)
    explained: set[str] = set()
    met = []
    for rule in rules.split("; "):
        its_own = amounts_in(rule)
        if not its_own.isdisjoint(paid):
            met.append(rule)
            explained |= its_own
    told = "; ".join(met).removeprefix("else, ")
    words = [f"Rewards: {told}."] if met else []
    others = [
        f"{signed(float(amount))} in {counted(times, 'step')}"
        for amount, times in paid.most_common()
        if amount not in explained
    ]
    listed = others[:AMOUNTS]
    if len(others) > AMOUNTS:
        listed.append(counted(len(others) - AMOUNTS, "other amount"))
    if listed:
        words.append(f"{'Also' if met else 'Rewards:'} {', '.join(listed)}.")
    return " ".join(words)


def amounts_in(rule: str) -> set[str]:
    """The rewards that a rule names: the numbers behind its first colon, or all if it has none."""
    condition, colon, reward = rule.partition(": ")
    told = reward if colon else condition
    numbers = re.findall(r"(?<![\w.])[-+−]?\d+(?:\.\d+)?", told)
    return {f"{float(number.replace('−', '-')):g}" for number in numbers}


def amounts_told(rules: str) -> set[str]:
    """The rewards that the rules name, parted by semicolons."""
    return {amount for rule in rules.split("; ") for amount in amounts_in(rule)}


def sought(scene: Scene) -> str:
    """What the robot is to reach, as it looks in a picture; empty if there is nothing."""
    roles = {solid.role for solid in scene.solids}
    if "goal" in roles:
        return "The green disc is its goal."
    if "object" in roles and has_arm(scene):
        return "It reaches for the yellow object."
    return ""


def aim_of(scene: Scene) -> str:
    """What the robot is to reach, and what looks like a thing and is none; empty if there is nothing of it."""
    words = [sought(scene)]
    if any(solid.name == "field" for solid in scene.solids):
        words.append("The pale field is only painted on the table.")
    return " ".join(filter(None, words))


def key_words(scene: Scene, rules: str, rewards: Sequence[float]) -> str:
    """What a picture's marks and rewards mean, beside the colours of the way; rules: what earns which reward."""
    words = [aim_of(scene)]
    if len(scene.beams):
        words.append(
            f"An orange line is a laser that finds something within {NEAR:g} m."
        )
    words.append(rules_met(rules, rewards))
    return " ".join(filter(None, words))


def has_arm(scene: Scene) -> bool:
    """Whether the robot is an arm, or has one."""
    return any(solid.name == "robot/upper_arm" for solid in scene.solids)


def gap_of(scene: Scene) -> float | None:
    """How far the point between an arm's fingertips is from the middle of the object [m]; None without both."""
    objects = [solid for solid in scene.solids if solid.role == "object"]
    fingers = [
        solid for solid in scene.solids if solid.name.startswith("robot/gripper_")
    ]
    if not objects or not fingers:
        return None
    ends = [(each.pose @ (each.size[0] / 2, 0, 0, 1))[:3] for each in fingers]
    return math.dist(np.mean(ends, axis=0), objects[0].pose[:3, 3])


def is_fixed(scene: Scene) -> bool:
    """Whether the robot is an arm on a table."""
    return has_arm(scene) and not rolls(scene)


def rolls(scene: Scene) -> bool:
    """Whether the robot has wheels."""
    return any(solid.name.endswith("_wheel") for solid in scene.solids)


def counted(n: int, name: str) -> str:
    """So many things of this name, such as ``2 bumps``."""
    if n == 1:
        return f"1 {name}"
    several = name + ("es" if name.endswith("s") else "s")
    return f"{n} {several}"


def describe(scene: Scene) -> str:
    """The scene in one sentence, for readers who hear a page instead of seeing it."""
    x_min, y_min, x_max, y_max = scene.bounds
    size = f"{x_max - x_min:.1f} by {y_max - y_min:.1f} metres"
    body = body_of(scene)
    if body is None:
        return f"A room of {size}."
    x, y = body.pose[:2, 3]
    yaw = math.degrees(math.atan2(body.pose[1, 0], body.pose[0, 0]))
    if is_fixed(scene):
        return f"A table of {size}, the gripper at x = {x:.2f}, y = {y:.2f}, heading {yaw:.0f} degrees."
    return f"A room of {size}, the robot at x = {x:.1f}, y = {y:.1f}, heading {yaw:.0f} degrees."
