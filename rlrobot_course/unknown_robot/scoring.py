"""What a drive of the unknown robot is worth: between chance, 0, and the best that we can find for it, 100."""

import hmac
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from joblib import Parallel, delayed
from numpy.typing import NDArray

from rlrobot_course.unknown_robot.body import SecretBody, rewards_of
from rlrobot_course.unknown_robot.secret import Secret
from rlrobot_edu import (
    Agent,
    Recording,
    SampleModel,
    Task,
    load_task,
    make_env,
    record,
    value_iteration,
)
from rlrobot_edu.files import load_arrays, save_arrays
from rlrobot_ros.live.served_body import TICK

HOUR = 3600.0  # that a robot is there for; the second half of it counts [s]
PUPILS, LESSONS = 6, 2  # agents that learn in the robot itself, and how many hours each
# a learning rate that changes no Q but where a pair has led to what is unknown: Q = -inf, for the next time
WARY = 1e-12
ENOUGH = 5  # times that a pair must have been tried for the careful plan to choose it


class Score(NamedTuple):
    """Mean rewards a step: `earned` in the drive, by `random` actions, and the best that was `found`."""

    earned: float
    random: float
    found: float

    @property
    def points(self) -> float:
        """0 for chance, 100 for the best found. Not clipped: worse than chance is below 0, better than found above."""
        return 100 * (self.earned - self.random) / (self.found - self.random)


def save_log(path: Path, body: SecretBody, secret: Secret) -> None:
    """Write the first hour of the robot's log, signed with the secret."""
    rewards = np.array(body.log[: round(HOUR / TICK)])
    about = {
        "task": body.task.name,
        "signature": _signature(secret, body.task.name, rewards),
    }
    save_arrays(path, "drive", about, {"rewards": rewards})


def score(log: str | Path, secret: Secret) -> Score:
    """What the second half hour of a logged drive is worth; it takes minutes, in which the rulers are driven.

    Raises ValueError for a log that another secret has signed, that was changed, or that is too short.
    """

    def make(
        about: dict[str, Any], arrays: dict[str, NDArray[np.float64]]
    ) -> tuple[str, str, NDArray[np.float64]]:
        return str(about["task"]), str(about["signature"]), arrays["rewards"]

    name, signature, rewards = load_arrays(log, "drive", make)
    if not hmac.compare_digest(signature, _signature(secret, name, rewards)):
        raise ValueError(
            f"{log}: this secret has not signed this log: another robot's, or it was changed since"
        )
    if len(rewards) < round(HOUR / TICK):
        raise ValueError(
            f"{log}: the robot has driven {len(rewards) * TICK:.0f} s of its {HOUR:.0f} s; drive on"
        )
    task = load_task(name)
    half = rewards[len(rewards) // 2 :]
    return Score(_mean(half, task), *rulers(task, secret))


def rulers(task: Task, secret: Secret, seconds: float = HOUR) -> tuple[float, float]:
    """Mean reward a step, for so long, of random actions and of the best driver that we find who knows the robot.

    Some pupils learn in the robot itself, `LESSONS` times as long. Then each drives and learns on. One more plans on
    what the best of them has recorded, with what was tried `ENOUGH` times alone. The best of all of them counts.
    """
    steps = round(seconds / task.step_time)
    random, _ = _drive(task, secret, Agent(task, "Q+RANDOM", seed=0), 0, steps)
    pupils = Parallel(n_jobs=-1)(
        delayed(_pupil)(task, secret, seed, steps) for seed in range(1, 1 + PUPILS)
    )
    best, recording = max(pupils, key=lambda pupil: float(pupil[0]))
    model = SampleModel.from_recording(recording, unseen="stay")
    planner = Agent(task, "Q+GREEDY", seed=0, alpha=WARY)
    planner.q[:] = np.where(
        model.pair_count >= ENOUGH, value_iteration(model).q, -np.inf
    )
    return random, max(best, _drive(task, secret, planner, 0, steps)[0])


def _pupil(
    task: Task, secret: Secret, seed: int, steps: int
) -> tuple[float, Recording]:
    """What one pupil earns after its lessons, and what was recorded in these."""
    pupil = Agent(task, "TOSL+QBIASSR", seed=seed)
    _, recording = _drive(task, secret, pupil, seed, LESSONS * steps)
    return _drive(task, secret, pupil, 0, steps)[0], recording


def _drive(
    task: Task, secret: Secret, agent: Agent, seed: int, steps: int
) -> tuple[float, Recording]:
    """What an agent earns a step, and the recording."""
    body = SecretBody(task, secret, seed)
    recording = record(agent, make_env(task, link=body), steps=steps)
    return _mean(body.log, task), recording


def _mean(log: NDArray[np.float64] | list[float], task: Task) -> float:
    return float(rewards_of(log, round(task.step_time / TICK)).mean())


def _signature(secret: Secret, task: str, rewards: NDArray[np.float64]) -> str:
    return hmac.new(secret.key, task.encode() + rewards.tobytes(), "sha256").hexdigest()
