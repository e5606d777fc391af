"""A better bias, or a circle? Runs bias_registered.json; writes docs/studies/a_better_bias.md and its figures.

``make bias-study`` does all of it, from nothing. Every finished part is kept in results/better_bias; the same call goes
on from there. ``power`` prints how many robots are needed; ``page`` writes the page anew from better_bias.json.
"""

from __future__ import annotations

import argparse
import json
import math
import time
import zlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from better_bias_methods import LINEAR, OWN
from better_bias_worlds import World, coarse, worlds
from joblib import Parallel, delayed
from scipy import stats

import rlrobot_edu as rl
from rlrobot_edu.files import write_whole
from rlrobot_edu.tools.blind import BLIND

HERE = Path(__file__).parent
REGISTERED: dict[str, Any] = json.loads(
    (HERE / "bias_registered.json").read_text(encoding="utf-8")
)
NUMBERS, STORE = HERE / "better_bias.json", HERE.parent / "results" / "better_bias"
TUNING = REGISTERED["tuning"]
MAZES = [f"maze {number}" for number in range(10)]
RULES = {  # of the program: loop evasion in QBIASSR alone
    "Q+SR": ("Q+SR", {}), "SR, no loop evasion": ("TOSL+SR", {"loop_evasion": False}),
    "Q+SR, no loop evasion": ("Q+SR", {"loop_evasion": False}),
}  # fmt: skip
Finals = dict[str, list[float]]  # final average rewards by label


def learner(world: World, label: str) -> tuple[rl.Method | str, dict[str, Any], World]:
    """Method, settings and world of a label such as ``VBIASSR``, ``coarse, T = 0.1`` or ``tuning SR, T = 3``."""
    if label in RULES:
        method, settings = RULES[label]
        return method, {**world.settings, **settings}, world
    name, _, temperature = label.removeprefix("tuning ").partition(", T = ")
    settings = {**world.settings, "temperature": float(temperature or 1)}
    if name == "blind":
        return BLIND, {**settings, "loop_evasion": False}, world
    if name == "LINEAR":
        return rl.Method(LINEAR, "SR"), settings, world
    if name == "coarse":
        return (
            f"{world.algorithm}+SR",
            settings,
            world._replace(task=coarse(world.task)),
        )
    selection = OWN.get(name, name)
    return rl.Method(world.algorithm, selection), settings, world


def one(name: str, label: str, number: int) -> float:
    """The final average reward of one robot. Its random numbers depend on these three and the registered seed alone."""
    key = zlib.crc32(f"{name}/{label}".encode())
    agent_seed, env_seed = np.random.SeedSequence(
        REGISTERED["seed"], spawn_key=(key, number)
    ).spawn(2)
    method, settings, world = learner(worlds()[name], label)
    with world.env(env_seed) as env:
        agent = rl.Agent(world.task, method, seed=agent_seed, **settings)
        history = rl.learn(
            agent, env, world.steps, episodes=world.episodes, progress=False
        )
    return round(float(history.final_average_reward), 6)


def repetitions(name: str, label: str) -> int:
    """How many robots are registered."""
    if label.startswith("tuning"):
        return TUNING["repetitions"]
    its = REGISTERED["repetitions"]
    changed = REGISTERED["families"]["changed in one thing"]["worlds"]
    return (
        its["a maze"]
        if name in MAZES
        else its["changed"]
        if name in changed
        else its.get(name, its["default"])
    )


def first_labels(name: str) -> list[str]:
    """What runs in a world before the best temperatures are known."""
    families, relatives, again = (
        REGISTERED[part] for part in ("families", "relatives", "reproduction")
    )
    labels: list[str] = []
    if name in MAZES or any(name in family["worlds"] for family in families.values()):
        labels += ["SR", "QBIASSR", "VBIASSR", "blind", "coarse"]
        labels += ["LINEAR"] if worlds()[name].algorithm == "TOSL" else []
    if is_tuned(name):
        labels += [
            "COUNT",
            *(
                tuning(method, t)
                for method in TUNING["methods"]
                for t in TUNING["temperatures"]
            ),
        ]
    if name in relatives["worlds"]:
        labels += ["SR", "VBIASSR", *relatives["names"]]
    if name in again["wheels"]:
        labels += ["SR", "QBIASSR", "VBIASSR", "blind"]
    if name in again["rule"]:
        labels += ["SR", "QBIASSR", "blind", *RULES]
    return list(dict.fromkeys(labels))


def is_tuned(name: str) -> bool:
    """Whether each method gets its best temperature in this world."""
    return any(
        name in family["worlds"]
        for family in REGISTERED["families"].values()
        if family["at best T"]
    )


def tuning(method: str, temperature: float) -> str:
    """The label of tuning runs."""
    return f"tuning {method}, T = {temperature:g}"


def at_best(finals: Mapping[str, list[float]], method: str) -> str:
    """The label of this method at the temperature that was best in the tuning runs."""
    best = max(TUNING["temperatures"], key=lambda t: np.mean(finals[tuning(method, t)]))
    return method if best == 1 else f"{method}, T = {best:g}"


def run(name: str, labels: list[str], finals: Finals, n_jobs: int) -> None:
    """Run what is missing of these labels, and keep it after each one."""
    for label in labels:
        done = finals.get(label, [])
        missing = range(len(done), repetitions(name, label))
        if missing:
            finals[label] = done + Parallel(n_jobs)(
                delayed(one)(name, label, number) for number in missing
            )
            STORE.mkdir(parents=True, exist_ok=True)
            write_whole(STORE / f"{name}.json", json.dumps(finals, ensure_ascii=False))


def run_all(n_jobs: int) -> None:
    """All worlds, and the numbers together in one file."""
    found: dict[str, Any] = {}
    began = time.perf_counter()
    for name in sorted(worlds(), key=lambda name: not worlds()[name].is_fast):
        path = STORE / f"{name}.json"
        finals: Finals = (
            json.loads(path.read_text(encoding="utf-8")) if path.is_file() else {}
        )
        run(name, first_labels(name), finals, n_jobs)
        if is_tuned(name):
            run(
                name,
                [at_best(finals, method) for method in TUNING["methods"]],
                finals,
                n_jobs,
            )
        found[name] = {label: finals[label] for label in sorted(finals)}
        means = {
            label: round(float(np.mean(x)), 2)
            for label, x in finals.items()
            if "tuning" not in label
        }
        print(f"{time.perf_counter() - began:.0f} s: {name}: {means}", flush=True)
        lines = (
            f"{json.dumps(name, ensure_ascii=False)}: {json.dumps(its)}"
            for name, its in found.items()
        )
        write_whole(NUMBERS, "{\n" + ",\n".join(lines) + "\n}\n")


def power() -> None:
    """How many robots of each method find a difference, for the SDs in blind.json, in Holm's first step over 28."""
    level, wanted = 0.05 / 28, 0.9
    for name, its in json.loads(
        (HERE / "blind.json").read_text(encoding="utf-8")
    ).items():
        sds = {label: float(np.std(x, ddof=1)) for label, x in its["finals"].items()}
        other = sds.get("QBIASSR", sds["VBIASSR"])
        told = []
        for difference in (0.5, 1.0):
            n = next(
                n
                for n in range(3, 2000)
                if chance(difference, sds["VBIASSR"], other, n, level) >= wanted
            )
            told.append(f"{n} robots for {difference}")
        n = REGISTERED["repetitions"]["default"]
        found = chance(1.0, sds["VBIASSR"], other, n, level)
        print(
            f"{name}: SDs {sds['VBIASSR']:.2f} and {other:.2f}: {', '.join(told)}; {n} find 1.0 with {found:.3f}"
        )


def chance(difference: float, sd: float, other: float, n: int, level: float) -> float:
    """The power of Welch's test with n robots in each group."""
    error = math.sqrt((sd**2 + other**2) / n)
    df = (n - 1) * (sd**2 + other**2) ** 2 / (sd**4 + other**4)
    limit = stats.t.ppf(1 - level / 2, df)
    return float(
        stats.nct.sf(limit, df, difference / error)
    )  # the wrong direction adds nothing that counts


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("what", choices=("all", "power", "run", "page"))
    parser.add_argument("--n-jobs", type=int, default=-1)
    given = parser.parse_args()
    if given.what == "power":
        power()
    if given.what in ("all", "run"):
        run_all(given.n_jobs)
    if given.what in ("all", "page"):
        from better_bias_page import write_page

        print(write_page(json.loads(NUMBERS.read_text(encoding="utf-8"))))


if __name__ == "__main__":
    main()
