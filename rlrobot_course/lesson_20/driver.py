"""Drivers by if-then, who press the buttons of the pad where no person does."""

from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np

from rlrobot_course.thread.rows import pressed_again
from rlrobot_edu import Recording, make_env
from rlrobot_edu.robots.robot_env import RobotEnv
from rlrobot_edu.task.robot_cards import FRONT_LASERS
from rlrobot_edu.widgets.driving.pad import Pad

AHEAD, LEFT, RIGHT, N_ACTIONS = 8, 2, 6, 9  # of wander_1k
NEAR = 0.35  # ahead of the robot: time to turn [m]
SLIP = 0.1  # how often the finger lands on any button
ENOUGH = 100  # steps that make a lesson

Driver = Callable[[Mapping[str, float], np.random.Generator], int]


def _is_blocked(lasers: Mapping[str, float]) -> bool:
    return min(lasers[name] for name in FRONT_LASERS) < NEAR


def careful(lasers: Mapping[str, float], rng: np.random.Generator) -> int:
    """Goes ahead, and turns away from the nearer wall. One step in ten is a slip."""
    if rng.random() < SLIP:
        return int(rng.integers(N_ACTIONS))
    left = lasers["laser_front_left"] + lasers["laser_left"]
    right = lasers["laser_front_right"] + lasers["laser_right"]
    if _is_blocked(lasers):
        return RIGHT if left < right else LEFT
    return AHEAD


def clumsy(lasers: Mapping[str, float], rng: np.random.Generator) -> int:
    """The same eyes, and wrong hands: turns towards the nearer wall, and then pushes on. Slips as often."""
    if rng.random() < SLIP:
        return int(rng.integers(N_ACTIONS))
    if _is_blocked(lasers):
        return AHEAD
    if (
        min(lasers["laser_left"], lasers["laser_right"]) < 2 * NEAR
        and rng.random() < 0.5
    ):
        return LEFT if lasers["laser_left"] < lasers["laser_right"] else RIGHT
    return AHEAD


def stubborn(_: Mapping[str, float], __: np.random.Generator) -> int:
    """Knows one button: ahead."""
    return AHEAD


def drive(driver: Driver, steps: int = 300, seed: int = 0) -> Pad:
    """A pad with the robot of wander_1k on which `driver` has pressed a button `steps` times."""
    rng = np.random.default_rng(seed)
    with make_env("wander_1k", seed=seed) as env:
        pad = Pad(env)
        robot = env.unwrapped
        assert isinstance(robot, RobotEnv)
        for _ in range(steps):
            pad.press(driver(robot.robot.readings, rng))
    return pad


def lesson_of(pad: Pad, folder: str | Path = "my_lesson") -> tuple[str, Recording, Pad]:
    """Whose lesson it is, the lesson, and the pad to film: what `pad` has, what `folder` has kept, or the stand-in's.

    A lesson of at least 100 steps on the pad is kept in `folder`, beside the notebooks.
    """
    if len(pad) >= ENOUGH:
        pad.recording.save(folder)
        return "you", pad.recording, pad
    too_few = (
        f" (you drove {len(pad)} steps; a lesson takes {ENOUGH})" if len(pad) else ""
    )
    if Path(folder, "datapackage.json").exists():
        kept = Recording.load(folder, task="wander_1k")
        return f"you, before{too_few}", kept, pressed_again(kept, "wander_1k")
    stand_in = drive(careful)
    return f"our stand-in{too_few}", stand_in.recording, stand_in
