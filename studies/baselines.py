"""Tables and neural networks compared: writes baselines.json (the numbers), docs/studies/baselines.md and its figure.

``python studies/baselines.py`` measures for half an hour on two cores and needs ``pip install --group baselines``.
``--quick`` prints the page of two short repetitions and writes nothing; ``--page`` writes the page from the numbers.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import time
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
from joblib import Parallel, delayed

import rlrobot_edu as rl
from rlrobot_course.figures.runs import mean_and_half
from rlrobot_edu.experiments.statistics import Tukey, mean_band
from rlrobot_edu.show.ends import End, name_ends
from rlrobot_edu.show.palette import BLACK, BLUE, CURVES, GREY, LIGHT
from rlrobot_edu.show.picture import Picture

HERE = Path(__file__).parent
DOCS = HERE.parent / "docs"
TASKS, STEPS, REPETITIONS, WINDOW, LAST = (
    ("wander_1k", "navigation_1k"),
    3600,
    10,
    200,
    600,
)
TABLES = ("TOSL+QBIASSR", "Q+SR", "Q+RANDOM")
TABLE_LOOKS = {TABLES[0]: (BLUE, "-"), TABLES[1]: (GREY, "-"), TABLES[2]: (BLACK, ":")}
NETWORK_LOOKS = [
    *CURVES[1:4],
    (LIGHT["input-1"], CURVES[4][1]),
    (LIGHT["input-2"], CURVES[5][1]),
]
# Chosen before the first run, and not tuned: γ as the tables have it, a larger step, and networks that begin to learn
# and stop exploring within an hour of the robot.
DQN_FITTED = {
    "gamma": 0.9, "learning_rate": 1e-3, "train_freq": 1, "target_update_interval": 200, "exploration_fraction": 0.2,
}  # fmt: skip
PPO_FITTED = {"gamma": 0.9, "learning_rate": 1e-3, "n_steps": 128}
# label: (class, what is set, whether it sees the readings themselves)
NETWORKS: dict[str, tuple[str, dict[str, Any], bool]] = {
    "DQN, as it comes": ("DQN", {}, False),
    "DQN, fitted": ("DQN", DQN_FITTED, False),
    "DQN, fitted, sees readings": ("DQN", DQN_FITTED, True),
    "PPO, as it comes": ("PPO", {}, False),
    "PPO, fitted": ("PPO", PPO_FITTED, False),
}


class Watched(gymnasium.Wrapper):
    """An environment that notes each reward and reached goal, and the seconds of CPU that it takes itself."""

    def __init__(self, env: gymnasium.Env) -> None:
        super().__init__(env)
        self.rewards: list[float] = []
        self.goals: list[bool] = []
        self.seconds = 0.0

    def reset(self, **given):
        began = time.process_time()
        answer = self.env.reset(**given)
        self.seconds += time.process_time() - began
        return answer

    def step(self, action):
        began = time.process_time()
        answer = self.env.step(int(action))
        self.seconds += time.process_time() - began
        self.rewards.append(float(answer[1]))
        self.goals.append(answer[2])
        return answer


class Readings(gymnasium.ObservationWrapper):
    """Shows the readings of the task's inputs, scaled to about 1, in place of their bins."""

    def __init__(self, env: gymnasium.Env) -> None:
        super().__init__(env)
        self.inputs = env.unwrapped.task.inputs
        self.observation_space = gymnasium.spaces.Box(
            -np.inf, np.inf, (len(self.inputs),), np.float32
        )
        finite = [[x for x in (v.low, v.high) if np.isfinite(x)] for v in self.inputs]
        self.scales = [max(map(abs, ends), default=1.0) for ends in finite]

    def observation(self, observation):
        readings = self.env.unwrapped._readings
        return np.array(
            [
                readings[v.name] / k
                for v, k in zip(self.inputs, self.scales, strict=True)
            ],
            np.float32,
        )


def run(task: str, method: str, seed: int, steps: int) -> dict[str, Any]:
    """Mean reward a step of each window of steps, goals reached, and seconds of CPU of learning and of the robot."""
    env = Watched(rl.make_env(task, seed=seed))
    if method in NETWORKS:
        learn = _network(env, method, seed, steps)
    else:
        agent = rl.Agent(task, method, seed=seed)
        rl.learn(
            rl.Agent(task, method), rl.make_env(task), 20, progress=False
        )  # the kernels are compiled

        def learn():
            rl.learn(agent, env, steps, progress=False)

    began = time.process_time()
    learn()
    seconds = time.process_time() - began - env.seconds
    share = steps / len(env.rewards)  # PPO takes whole rounds of steps
    rewards = np.array(env.rewards[:steps])
    return {
        "windows": rewards.reshape(-1, WINDOW).mean(axis=1).round(4).tolist(),
        "goals": sum(env.goals[:steps]),
        "learning": round(seconds * share, 3),
        "robot": round(env.seconds * share, 3),
    }


def _network(env, method: str, seed: int, steps: int):
    """The call that learns with one of Stable-Baselines3's methods."""
    import stable_baselines3
    import torch

    torch.set_num_threads(1)
    kind, given, sees_readings = NETWORKS[method]
    network_class = getattr(stable_baselines3, kind)
    network_class("MlpPolicy", rl.make_env("wander_simple"), device="cpu").learn(
        110
    )  # PyTorch is warm
    seen = Readings(env) if sees_readings else env
    network = network_class("MlpPolicy", seen, seed=seed, device="cpu", **given)
    return lambda: network.learn(steps)


def measure(repetitions: int, steps: int) -> dict[str, Any]:
    """All runs, by task and method."""
    jobs = [
        (t, m, seed)
        for seed in range(repetitions)
        for t in TASKS
        for m in (*TABLES, *NETWORKS)
    ]
    runs = Parallel(n_jobs=-1, verbose=5)(delayed(run)(*job, steps) for job in jobs)
    found: dict[str, Any] = {
        task: {method: [] for method in (*TABLES, *NETWORKS)} for task in TASKS
    }
    for (task, method, _), one in zip(jobs, runs, strict=True):
        found[task][method].append(one)
    return {"machine": machine(), "runs": found}


def machine() -> str:
    """The processor, as far as the system tells, and what runs on it."""
    import stable_baselines3
    import torch

    model = platform.processor() or platform.machine()
    if Path("/proc/cpuinfo").is_file():
        lines = Path("/proc/cpuinfo").read_text().splitlines()
        model = next(
            (
                line.split(":")[1].strip()
                for line in lines
                if line.startswith("model name")
            ),
            model,
        )
    versions = f"Stable-Baselines3 {stable_baselines3.__version__}, PyTorch {torch.__version__.partition('+')[0]}"
    return f"{model}, {os.cpu_count()} cores, Python {platform.python_version()}, {versions}"


def rows(runs: dict[str, list[dict[str, Any]]], has_goal: bool) -> str:
    """The rows of one task's table. Significance is Tukey's test over all methods, of the last ten minutes."""
    windows = {
        method: np.array([one["windows"] for one in of]) for method, of in runs.items()
    }
    lasts = {
        method: of[:, -LAST // WINDOW :].mean(axis=1) for method, of in windows.items()
    }
    pairs = {
        pair.second: pair for pair in Tukey.of(lasts).pairs if pair.first == TABLES[0]
    }
    lines = []
    for method, of in windows.items():
        learning = np.array([one["learning"] for one in runs[method]])
        firsts = of[:, : LAST // WINDOW].mean(axis=1)
        numbers = [of.mean(axis=1), firsts, lasts[method], learning]
        cells = ["{:.2f} ± {:.2f}".format(*mean_and_half(values)) for values in numbers]
        cells.append(f"{1000 * learning.mean() / (WINDOW * of.shape[1]):.2f}")
        pair = pairs.get(method)
        cells.append(
            ""
            if pair is None
            else f"{-pair.difference:+.2f}{' (p < 0.01)' * (pair.p < 0.01)}"
        )
        if has_goal:
            cells.append(
                "{:.1f} ± {:.1f}".format(
                    *mean_and_half([one["goals"] for one in runs[method]])
                )
            )
        lines.append(
            f"| {method.replace('Q+RANDOM', 'at random')} | {' | '.join(cells)} |"
        )
    return "\n".join(lines)


def verdict(runs: dict[str, list[dict[str, Any]]]) -> str:
    """A text about the table of one task; its words follow the numbers."""
    lasts = {
        m: np.array([one["windows"][-LAST // WINDOW :] for one in of]).mean(axis=1)
        for m, of in runs.items()
    }
    seconds = {m: np.mean([one["learning"] for one in of]) for m, of in runs.items()}
    best, table = max(NETWORKS, key=lambda method: lasts[method].mean()), TABLES[0]
    pair = next(
        pair
        for pair in Tukey.of(lasts).pairs
        if (pair.first, pair.second) == (table, best)
    )
    more = "more than" if pair.difference < 0 else "less than"
    sure = "which is significant" if pair.p < 0.05 else "which may be chance"
    means = {method: f"{values.mean():.2f}" for method, values in lasts.items()}
    dqn, ppo = (method for method in NETWORKS if "as it comes" in method)
    times = seconds[best] / seconds[table]
    return (
        f'In the last ten minutes the best network is "{best}": with {means[best]} a step it gets {more}\n'
        f"{table}'s {means[table]}, {sure} (Tukey, p = {pair.p:.2g}). Its learning takes {times:.0f} times as long.\n"
        f"As they come, DQN gets {means[dqn]} and PPO {means[ppo]}; Q+SR gets {means[TABLES[1]]}, chance "
        f"{means[TABLES[2]]}."
    )


def page(measured: dict[str, Any]) -> str:
    """The whole page."""
    runs = measured["runs"]
    every = [one for of in runs.values() for several in of.values() for one in several]
    fitted = [
        "`" + ", ".join(f"{k}={v}" for k, v in given.items()) + "`"
        for given in (DQN_FITTED, PPO_FITTED)
    ]
    return (
        (HERE / "baselines_template.md")
        .read_text(encoding="utf-8")
        .format(
            steps=WINDOW * len(every[0]["windows"]),
            repetitions=len(runs[TASKS[0]][TABLES[0]]),
            machine=measured["machine"],
            robot=f"{np.mean([one['robot'] for one in every]):.1f}",
            dqn=fitted[0],
            ppo=fitted[1],
            alt=curves(runs).alt,
            **{
                task: rows(of, rl.load_task(task).goal is not None)
                for task, of in runs.items()
            },
            **{f"{task}_verdict": verdict(of) for task, of in runs.items()},
        )
    )


def curves(runs: dict[str, Any]) -> Picture:
    """Mean reward a step of each method, in windows of steps, a chart a task; tables thick, networks thin."""
    picture = Picture((8.4, 9))
    title = curves_title(runs)
    picture.headline(
        title,
        f"Mean reward a step in windows of {WINDOW} steps; the numbers: the last {LAST} steps. Band: 95 % interval.",
    )
    charts = picture.subplots(len(runs), 1)
    told = []
    ends: list[list[End]] = []
    for ax, (task, of) in zip(charts, runs.items(), strict=True):
        ends.append([])
        networks = iter(NETWORK_LOOKS)
        for method, several in of.items():
            windows = np.array([one["windows"] for one in several])
            is_network = method in NETWORKS
            colour, dashes = next(networks) if is_network else TABLE_LOOKS[method]
            x = WINDOW * (np.arange(windows.shape[1]) + 0.5)
            y = windows.mean(axis=0)
            if method == TABLES[0]:
                ax.fill_between(x, *mean_band(windows), color=colour, alpha=0.2, lw=0)
            ax.plot(x, y, color=colour, linestyle=dashes, lw=1.5 if is_network else 2.4)
            name = "at random" if method == TABLES[-1] else method
            end = f"{lately(several).mean():.1f}".replace("-", "−")
            ends[-1].append(End(y[-1], f"{end} {name}", colour))
            told.append(f"{name} ends at {end} in {task}")
        ax.set_title(task)
        ax.grid(axis="y")
        ax.margins(x=0)
    charts[-1].set_xlabel("step")
    for ax, its in zip(charts, ends, strict=True):
        name_ends(ax, its)
    picture.alt = f"{title}. Mean reward a step. {'; '.join(told)}."
    return picture


def lately(several: list[dict[str, Any]]) -> np.ndarray:
    """The mean reward a step of each robot in its last steps, array (n,)."""
    windows = np.array([one["windows"] for one in several])
    return windows[:, -LAST // WINDOW :].mean(axis=1)


def curves_title(runs: dict[str, Any]) -> str:
    """Where the best network ends in each task, and the paper's method."""
    told = []
    for task, of in runs.items():
        best = max(lately(of[method]).mean() for method in of if method in NETWORKS)
        ours = lately(of[TABLES[0]]).mean()
        told.append(f"{task}: {best:.1f} and {ours:.1f}")
    said = f"Where the best network and {TABLES[0]} end, a step: {'; '.join(told)}"
    return said.replace("-", "−")


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--page", action="store_true")
    asked = parser.parse_args()
    if asked.quick:
        print(page(measure(2, 600)))
        return
    numbers = HERE / "baselines.json"
    if not asked.page:
        numbers.write_text(
            json.dumps(measure(REPETITIONS, STEPS)) + "\n", encoding="utf-8"
        )
    measured = json.loads(numbers.read_text(encoding="utf-8"))
    (DOCS / "studies" / "baselines.md").write_text(page(measured), encoding="utf-8")
    picture = curves(measured["runs"])
    (DOCS / "pictures" / "baselines.png").write_bytes(picture.still().data)
    print(DOCS / "studies" / "baselines.md")


if __name__ == "__main__":
    main()
