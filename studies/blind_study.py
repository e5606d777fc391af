"""How much does a robot earn that sees nothing? Measures it; writes blind.json and, from it, docs/studies/blind.md.

``python studies/blind_study.py`` takes some three minutes on two cores; ``--page`` writes the page alone anew.
"""

from __future__ import annotations

import dataclasses
import json
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from in_markdown import in_markdown
from scipy import stats

import rlrobot_edu as rl
from rlrobot_course.lesson_22.vbiassr import VBIASSR
from rlrobot_edu.experiments.tables import Table
from rlrobot_edu.files import write_whole
from rlrobot_edu.task.wheel_commands import no_reversing
from rlrobot_edu.tools.blind import BLIND as SEES_NOTHING

HERE = Path(__file__).parent
DOCS = HERE.parent / "docs"
SEED, REPETITIONS, LEVEL = 0, 30, 0.05
BLIND = "blind"
OTHERS = ("SR", "QBIASSR", "VBIASSR")
# The labels decide the random numbers
METHODS = {label: {"method": f"TOSL+{label}"} for label in OTHERS[:-1]} | {
    "VBIASSR": {"method": rl.Method("TOSL", VBIASSR)}
}
Found = dict[str, dict[str, Any]]


def straight_ahead(wheels: dict[str, float]) -> dict[str, float]:
    """As in the authors' program: both wheels backward means straight ahead at double top speed."""
    if max(wheels.values()) < 0:
        return dict.fromkeys(wheels, 2.0)
    return no_reversing(wheels)


def nine_actions(task: rl.Task) -> rl.Task:
    """The task with three speeds of each wheel, as in wander_1k."""
    outputs = [
        dataclasses.replace(output, values=[-1, 0, 1]) for output in task.outputs
    ]
    return dataclasses.replace(task, outputs=outputs)


class World(NamedTuple):
    """A task, changed or not, and which methods learn in it beside the blind one."""

    task: rl.Task
    steps: int
    others: tuple[str, ...] = OTHERS[-1:]


def worlds() -> dict[str, World]:
    """The worlds by name. SR and QBIASSR learn only where the task is changed."""
    four = rl.load_task("wander_4k")
    return {
        "wander_1k": World(rl.load_task("wander_1k"), 3600),
        "wander_4k": World(four, 3600),
        "wander_4k, both backward is straight ahead": World(
            dataclasses.replace(four, command=straight_ahead), 3600, OTHERS
        ),
        "wander_4k, nine actions": World(nine_actions(four), 3600, OTHERS),
        "giraff_wander_1k": World(rl.load_task("giraff_wander_1k"), 1800),
        "giraff_wander_4k": World(rl.load_task("giraff_wander_4k"), 1800),
    }


def measure() -> Found:
    """Final average rewards by world and method, and what the best single action earns, without end."""
    found: Found = {}
    for name, world in worlds().items():
        methods = {BLIND: {"method": SEES_NOTHING, "loop_evasion": False}}
        methods |= {label: METHODS[label] for label in world.others}
        runs = rl.compare(
            world.task,
            methods,
            REPETITIONS,
            steps=world.steps,
            seed=SEED,
            progress=False,
        )
        finals = {label: np.round(x, 7).tolist() for label, x in runs.final.items()}
        best = max(
            range(world.task.actions.n), key=lambda a: always(world.task, a, 300)
        )
        alone = {
            "wheels": list(world.task.command_for(best).values()),
            "reward": always(world.task, best, world.steps),
        }
        found[name] = {
            "steps": world.steps,
            "seed": SEED,
            "finals": finals,
            "one action": alone,
        }
        print(
            name,
            {label: round(float(np.mean(x)), 2) for label, x in finals.items()},
            alone,
            flush=True,
        )
    return found


def always(task: rl.Task, action: int, steps: int) -> float:
    """Mean reward a step of a robot that does nothing else."""
    with rl.make_env(task, seed=SEED) as env:
        env.reset()
        return round(float(np.mean([env.step(action)[1] for _ in range(steps)])), 4)


def p_of(found: Mapping[str, Any], label: str) -> float:
    """p of Welch's test of the blind robots against others."""
    return float(
        stats.ttest_ind(
            found["finals"][BLIND], found["finals"][label], equal_var=False
        ).pvalue
    )


def told(values: list[float]) -> str:
    """Mean and half of its 95 % interval (Student's t)."""
    return f"{np.mean(values):.2f} ± {stats.t.ppf(0.975, len(values) - 1) * stats.sem(values):.2f}"


def table(found: Found) -> str:
    """A line for each world."""
    rows = []
    for name, its in found.items():
        finals, alone, p = its["finals"], its["one action"], p_of(its, "VBIASSR")
        wheels = " and ".join(f"{speed:g}" for speed in alone["wheels"])
        rows.append([
            name, str(its["steps"]), *(told(finals[label]) if label in finals else "" for label in (BLIND, *OTHERS)),
            "p < 0.0001" if p < 1e-4 else f"p = {p:.2g}", f"{alone['reward']:.2f} ({wheels} rad/s)",
        ])  # fmt: skip
    head = [
        "world",
        "steps",
        BLIND,
        *OTHERS,
        "blind against VBIASSR",
        "the best single action, for ever",
    ]
    return "\n".join(in_markdown(Table("", head, rows)).splitlines()[2:])


def verdicts(found: Found) -> str:
    """The result in words that follow the numbers."""
    more, less, neither = (
        "more than",
        "less than",
        "neither more nor less, as far as this shows, than",
    )
    said: dict[str, list[str]] = {more: [], less: [], neither: []}
    for name, its in found.items():
        gain = np.mean(its["finals"][BLIND]) - np.mean(its["finals"]["VBIASSR"])
        word = neither if p_of(its, "VBIASSR") >= LEVEL else more if gain > 0 else less
        said[word].append(f"*{name}*")
    return "\n".join(
        f"- It earns {word} VBIASSR in: {'; '.join(names)}."
        for word, names in said.items()
        if names
    )


PAGE = """# How much does a blind robot earn?

A selection may earn much because it knows its states well, or because it soon ignores them and does one thing
everywhere. So here a robot with TOSL+SR learns while all places are one state. It has no loop evasion, which looks at
states. {n} robots each, seed {seed}; mean final average reward ± half of its 95 % interval, p of Welch's test,
uncorrected. SR and QBIASSR were run in two of the worlds only. Written by `python studies/blind_study.py` from
[blind.json](../../studies/blind.json).

{table}

{verdicts}

*Both backward is straight ahead*: in the paper's program both wheels backward drive straight ahead at double top speed;
ours doubles [each wheel's speed](../differences.md), so that two more of the 25 actions of wander_4k drive in a circle.
*Nine actions*: wander_4k with the three speeds of wander_1k, of which no two drive in a circle that pays. *The best
single action* is the best of all in 300 steps.

If one action, repeated for ever, earns as much as any behaviour, the reward does not measure what a selection knows.
The reward of wander_4k only asks the robot to move and not to touch. This study does not show how much of VBIASSR's
gain there comes from circling; [another study](a_better_bias.md) measures what is left where no circle pays.
"""


def page(found: Found) -> str:
    """The page in Markdown."""
    n = len(found["wander_4k"]["finals"][BLIND])
    return PAGE.format(n=n, seed=SEED, table=table(found), verdicts=verdicts(found))


def main() -> None:
    """Measure, unless it has been measured, and write."""
    if "--page" not in sys.argv:
        write_whole(HERE / "blind.json", json.dumps(measure(), indent=0) + "\n")
    found = json.loads((HERE / "blind.json").read_text(encoding="utf-8"))
    write_whole(DOCS / "studies" / "blind.md", page(found))


if __name__ == "__main__":
    main()
