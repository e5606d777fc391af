"""Make the pictures of the README: ``make pictures [TASKS="arm_1k …"]``. They need Chromium.

For each task: the robot at work after it has learned, in 3D, and the learning curves of TOSL+QBIASSR and of a robot
that acts at random, means of 10 repetitions. For wander_1k also a film, and the stepper.
"""

import io
import sys
from pathlib import Path

from PIL import Image

import rlrobot_edu as rl
from rlrobot_edu.show.film import Film
from rlrobot_edu.show.images import png_of
from rlrobot_edu.show.in3d.photograph import photograph
from rlrobot_edu.show.in3d.visualizer import show_scene
from rlrobot_edu.task.task_file import available_tasks

HERE = Path(__file__).parents[1] / "pictures"
STEPS = 3600
COLOURS = 128  # of the film


def picture_of(name: str) -> None:
    """The robot, with the path of its last 100 steps, green where it was paid."""
    env = rl.make_env(name, seed=0)
    agent = rl.Agent(name, "TOSL+QBIASSR", seed=0)
    rl.learn(agent, env, steps=STEPS, progress=False)
    film = rl.film(agent, env, steps=100)
    (HERE / f"{name}.png").write_bytes(
        png_of(seen(film, len(film.frames)).quantize(256))
    )
    print(f"{name}.png: {film.show3d()}", flush=True)
    if name == "wander_1k":
        last = seen(film, 100).quantize(COLOURS)
        first, *rest = [
            seen(film, n).quantize(palette=last, dither=Image.Dither.NONE)
            for n in range(2, 101, 2)
        ]
        first.save(
            HERE / f"{name}.gif",
            save_all=True,
            append_images=rest,
            loop=0,
            duration=200,
            optimize=True,
        )


def seen(film: Film, steps: int) -> Image.Image:
    """The film after so many steps, in 3D."""
    page = show_scene(film.frames[:steps], film.rewards[:steps]).html
    fine = Image.open(io.BytesIO(photograph(page))).convert("RGB")
    return fine.resize((fine.width // 2, fine.height // 2), Image.Resampling.LANCZOS)


def curves_of(name: str) -> None:
    """Learning curves beside chance."""
    methods = ("TOSL+QBIASSR", "Q+RANDOM")
    curves = [
        rl.repeat(name, method, repetitions=10, steps=STEPS) for method in methods
    ]
    labels = ["TOSL+QBIASSR", "at random"]
    save(
        rl.plot_learning(*curves, labels=labels, title=name),
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
    for name in sys.argv[1:] or available_tasks():
        picture_of(name)
        curves_of(name)
        if name == "wander_1k":
            stepper()
