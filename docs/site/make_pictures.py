"""Make the pictures of the README: ``make pictures [TASKS="arm_1k …"]``. The same pictures every time.

For each task: the robot at work after it has learned, from above, and the learning curves of TOSL+QBIASSR and of a
robot that acts at random, means of 10 repetitions. For wander_1k also a film, and the stepper.
"""

import sys
from pathlib import Path

import rlrobot_edu as rl

HERE = Path(__file__).parents[1] / "pictures"
STEPS = 3600


def picture_of(name: str) -> None:
    """The robot from above, with the path of its last 100 steps."""
    env = rl.make_env(name, seed=0)
    agent = rl.Agent(name, "TOSL+QBIASSR", seed=0)
    rl.learn(agent, env, steps=STEPS, progress=False)
    film = rl.film(agent, env, steps=100)
    average = sum(film.rewards) / len(film.rewards)
    title = f"{len(film.frames)} steps, average reward {average:+.2f} per step"
    save(rl.plot_scene(film.frames, title=title), f"{name}.png", dpi=60)
    if name == "wander_1k":
        film.gif(HERE / f"{name}.gif")


def curves_of(name: str) -> None:
    """Learning curves beside chance."""
    methods = ("TOSL+QBIASSR", "Q+RANDOM")
    curves = [rl.repeat(name, method, repetitions=10, steps=STEPS) for method in methods]
    labels = ["TOSL+QBIASSR", "at random"]
    save(rl.plot_learning(*curves, labels=labels, title=name), f"{name}_learning.png", dpi=60)


def stepper() -> None:
    """One step of the paper's method, as the stepper shows it."""
    env = rl.make_env("wander_1k", seed=0)
    save(rl.Stepper(rl.Agent("wander_1k", "TOSL+QBIASSR", seed=0), env, at=40).picture(), "stepper.png", dpi=80)


def save(figure, name: str, dpi: float) -> None:
    figure.savefig(HERE / name, dpi=dpi, metadata={"Software": None})
    print(f"{name}: {figure.alt}", flush=True)


if __name__ == "__main__":
    for name in sys.argv[1:] or rl.available_tasks():
        picture_of(name)
        curves_of(name)
        if name == "wander_1k":
            stepper()
