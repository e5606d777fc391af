"""Make the pictures of the README: ``make pictures [TASKS="arm_1k …"]``.

For each task: the robot at work after it has learned, in 3D, and the learning curves of TOSL+QBIASSR and of a robot
that acts at random, means of 10 repetitions. For wander_1k also a film, and the stepper. Of the stage its opening.
"""

import sys
from pathlib import Path

from stage_film import film_of_stage

import rlrobot_edu as rl
from rlrobot_edu.show.painting.room import painted
from rlrobot_edu.task.task_file import available_tasks

HERE = Path(__file__).parents[1] / "pictures"
STAGE = "stage"  # a page, and no task
STEPS = 3600


def picture_of(name: str) -> None:
    """The robot, with the path of its last 100 steps."""
    env = rl.make_env(name, seed=0)
    agent = rl.Agent(name, "TOSL+QBIASSR", seed=0)
    rl.learn(agent, env, steps=STEPS, progress=False)
    film = rl.film(agent, env, steps=100)
    still = painted(film.frames)
    (HERE / f"{name}.png").write_bytes(still.data)
    print(f"{name}.png: {still.alt}", flush=True)
    if name == "wander_1k":
        film.save(HERE / f"{name}.gif")


def curves_of(name: str) -> None:
    """Learning curves beside chance."""
    methods = ("TOSL+QBIASSR", "Q+RANDOM")
    curves = [
        rl.repeat(name, method, repetitions=10, steps=STEPS) for method in methods
    ]
    labels = ["TOSL+QBIASSR", "at random"]
    save(
        rl.plot_learning(*curves, labels=labels),
        f"{name}_learning.png",
        dpi=60,
    )


def stepper() -> None:
    """One step of the paper's method, as the stepper shows it."""
    env = rl.make_env("wander_1k", seed=0)
    save(
        rl.Stepper(rl.Agent("wander_1k", "TOSL+QBIASSR", seed=0), env, at=40).picture(),
        "stepper.png",
        dpi=80,
    )


def save(figure, name: str, dpi: float) -> None:
    figure.savefig(HERE / name, dpi=dpi, metadata={"Software": None})
    print(f"{name}: {figure.alt}", flush=True)


if __name__ == "__main__":
    for name in sys.argv[1:] or [*available_tasks(), STAGE]:
        if name == STAGE:
            film_of_stage(HERE)
            continue
        picture_of(name)
        curves_of(name)
        if name == "wander_1k":
            stepper()
