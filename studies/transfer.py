"""Does it help to transfer knowledge? Measures four carries and writes docs/studies/transfer.md.

``python studies/transfer.py`` takes some ten minutes on two cores; ``--quick`` shows within one that it works,
and writes
nothing. ``--kept FOLDER`` keeps the rewards in a folder, or takes them from there. ``--figure`` runs nothing, and draws
the figure anew from the tables of the page.
"""

from __future__ import annotations

import argparse
import re
from pathlib import Path
from typing import NamedTuple

import numpy as np
from in_markdown import in_markdown
from joblib import Parallel, delayed
from scipy import stats
from transfer_figure import figure

import rlrobot_edu as rl
from rlrobot_course.lesson_21.transfer import carried_over, transfer
from rlrobot_edu.experiments.tables import Table

DOCS = Path(__file__).parents[1] / "docs"
METHOD, REPETITIONS, SOURCE_STEPS, MODEL_STEPS = "TOSL+QBIASSR", 20, 3600, 36_000
HORIZONS = (100, 300, 1000, 3600)
WAYS = ("from scratch", "carried over", "carried over, halved", "number for number")


class Carry(NamedTuple):
    """From where to where: tasks, engine of the target (None is the first), and how long the target is learned.

    ways: how many of `WAYS` are tried; number for number only where both have as many bins and actions
    """

    name: str
    source: str
    target: str
    from_model: bool = False
    engine: str | None = None
    steps: int = 3600
    ways: int = 3


CARRIES = (
    Carry("sample model to simulator", "wander_1k", "wander_1k", from_model=True),
    Carry("pymunk to PyBullet", "wander_1k", "wander_1k", engine="pybullet", steps=300),
    Carry("Pioneer to Giraff", "wander_1k", "giraff_wander_1k", ways=4),
    Carry("wander_1k to wander_4k", "wander_1k", "wander_4k"),
    Carry(
        "the same robot and task, to compare with", "wander_1k", "wander_1k", steps=300
    ),
)


def once(
    carry: Carry, number: int, steps: int, source_steps: int
) -> tuple[np.ndarray, float]:
    """Rewards of a repetition, array (ways, steps); and the share of the target's pairs that were known.

    The source agent is its own in each repetition, and so are the random numbers of each way.
    """
    seeds = np.random.SeedSequence(0, spawn_key=(CARRIES.index(carry), number)).spawn(
        2 + 2 * carry.ways
    )
    world = (
        rl.SampleModel.from_recording(rl.read_recording(carry.source))
        if carry.from_model
        else carry.source
    )
    source = rl.Agent(carry.source, METHOD, seed=seeds[0])
    with rl.make_env(world, seeds[1]) as env:
        rl.learn(
            source,
            env,
            steps=source_steps
            * (MODEL_STEPS // SOURCE_STEPS if carry.from_model else 1),
            progress=False,
        )
    rewards, share = np.empty((carry.ways, steps)), 0.0
    for i, way in enumerate(WAYS[: carry.ways]):
        agent_seed, env_seed = seeds[2 + 2 * i : 4 + 2 * i]
        agent = rl.Agent(carry.target, METHOD, seed=agent_seed)
        if way == "number for number":
            agent.q[:] = source.q
        elif i:
            agent = transfer(source, carry.target, seed=agent_seed)
            agent.q[:] *= 0.5 if way.endswith("halved") else 1.0
            share = carried_over(source, agent.task)[1].mean()
        with rl.make_env(carry.target, env_seed, engine=carry.engine) as env:
            rewards[i] = rl.learn(agent, env, steps=steps, progress=False).rewards
    return rewards, share


PAGE = """# Does it help to transfer knowledge?

`transfer` of lesson 21 begins a new agent with the Q of another: bins by the overlap of their physical intervals,
actions by the robot's motion. We measured four transfers, and one to the same robot for comparison. Each time {n}
source agents learn ({method}, the default parameters, {source_steps:,} steps, in the sample model of one recording
{model_steps:,}), each by itself. From each of them one agent of the target begins, and another begins from scratch. All
have random numbers of their own. Every step is one second, so {source_steps:,} steps are an hour. Written by `python
studies/transfer.py`.

![{alt}](../pictures/transfer.png)

Means of the average reward, with half of their 95 % interval (Student's t); the bars in the figure are 95 % intervals,
too. p is that of a two-sided Mann–Whitney U test against the agents from scratch, which assumes no shape of the
distributions: some agents get stuck, so the distributions are not normal. *Better in* is the share of pairs of agents,
one of each kind, in which the one with knowledge earned more (50 %: no difference). *Significant* means p < 0.05 /
{tests}, for the {tests} tests on this page (Bonferroni). *Halved* is the transfer with all Q times ½, as if the
temperature were twice as high at first: a way to rely less on what was learned elsewhere.

{tables}

Share of the target's pairs (s, a) that rest on visited ones of the source, mean: {shares}.

{verdict}
"""

VERDICT = """## What it shows

- *wander_1k to wander_4k* gains most, and at once: in their first 100 steps the agents with knowledge earn more than
  those from scratch in the last 500 of their hour, {scratch_4k:.2f}. But the hour in which the source learned another
  task is not counted here.
- *Pioneer to Giraff* gains, too, though not in the first 100 steps: in the first 1,000 significantly, plain and halved.
  In the first 300 only the plain transfer is significant, in the whole hour only the halved one. These p are so near to
  the strict limit that other seeds may change this. By its intervals, all that the Giraff calls near (up to 0.25 m) is
  the Pioneer's nearest bin (up to 0.27 m), and its slow speeds lie between the Pioneer's driving and standing still.
  *Number for number* ignores physics: bin 2 is bin 2 and action 8 is action 8, since the Giraff's task is the Pioneer's
  in thirds of 0.25 m instead of 0.80 m. These 20 agents show no gain from that.
- *Sample model to simulator* gains nothing significant. In the model, the source agents finally earn {in_model:.2f} a
  step, the maximum: they have found loops that depend on a single lucky sample, of which `model.diagnose()` warns.
  Their largest values are wrong for the robot. Halving them is not better either.
- *pymunk to PyBullet* gains little, if anything: nothing significant in 300 steps, where agents like them, on *the same
  robot*, earn far more. So the transfer itself does not cause the loss. The curve begins high and falls. In free space
  both engines move the robot alike, to the millimetre; so the cause may be the walls, but we have not shown it.
- *Halved* was not tested against the plain transfer. Its mean is lower in the first 300 steps where the transfer gains
  much (wander_4k, Giraff), and higher in PyBullet, where what was learned is less true. So `transfer` copies Q as it
  is; `agent.q[:] *= 0.5` is one line.

In none of the transfers were agents with knowledge significantly worse. Others may be: an agent with a low temperature
would need long to forget wrong values, and so would one whose source had learned large values that are wrong in the
target.
"""


def measured(
    carry: Carry, folder: Path | None, quick: bool
) -> tuple[np.ndarray, np.ndarray]:
    """Rewards of a carry, array (repetitions, ways, steps), and the shares of known pairs, array (repetitions,)."""
    file = folder and folder / f"{carry.name}.npz"
    if file and file.is_file():
        with np.load(file) as kept:
            return kept["rewards"], kept["shares"]
    repetitions, steps, source_steps = (
        (3, 100, 300) if quick else (REPETITIONS, carry.steps, SOURCE_STEPS)
    )
    done = Parallel(n_jobs=-1)(
        delayed(once)(carry, i, steps, source_steps) for i in range(repetitions)
    )
    rewards, shares = (np.array(part) for part in zip(*done, strict=True))
    if file:
        file.parent.mkdir(exist_ok=True)
        np.savez_compressed(file, rewards=rewards, shares=shares)
    return rewards, shares


def last_hour_in_the_model() -> np.ndarray:
    """Average rewards of the first carry's source agents in their last hour in the model; array (REPETITIONS,)."""
    model = rl.SampleModel.from_recording(rl.read_recording(CARRIES[0].source))
    earned = np.empty(REPETITIONS)
    for i in range(REPETITIONS):
        agent_seed, env_seed = np.random.SeedSequence(0, spawn_key=(0, i)).spawn(2)
        agent = rl.Agent(CARRIES[0].source, METHOD, seed=agent_seed)
        history = rl.learn(
            agent, rl.make_env(model, env_seed), steps=MODEL_STEPS, progress=False
        )
        earned[i] = history.rewards[-3600:].mean()
    return earned


def compared(rewards: np.ndarray, way: int, horizon: int) -> tuple[str, float, float]:
    """Mean and half of its 95 % interval, and against learning from scratch: p and the chance to be better."""
    of, scratch = (rewards[:, i, :horizon].mean(axis=1) for i in (way, 0))
    half = stats.t.ppf(0.975, len(of) - 1) * stats.sem(of)
    test = stats.mannwhitneyu(of, scratch)
    return (
        f"{of.mean():.2f} ± {half:.2f}",
        float(test.pvalue),
        float(test.statistic / len(of) / len(scratch)),
    )


def table(carry: Carry, rewards: np.ndarray, tests: int) -> Table:
    """A row for each way of beginning, a column for each horizon."""
    horizons = [h for h in HORIZONS if h <= rewards.shape[-1]]
    rows = []
    for i, way in enumerate(WAYS[: carry.ways]):
        cells = []
        for horizon in horizons:
            mean, p, better = compared(rewards, i, horizon)
            p_said = (
                "p < 0.0001"
                if p < 1e-4
                else f"p = {p:.4f}"
                if p < 0.01
                else f"p = {p:.2f}"
            )
            mark = " (significant)" if p * tests < 0.05 else ""
            cells.append(
                mean if i == 0 else f"{mean}; {p_said}{mark}; better in {better:.0%}"
            )
        rows.append((way, *cells))
    return Table(carry.name, ("agents", *(f"first {h} steps" for h in horizons)), rows)


def draw() -> None:
    """Draw the figure from the tables of the page, and write its description beside it."""
    path = DOCS / "studies" / "transfer.md"
    page = path.read_text(encoding="utf-8")
    picture = figure(page, [carry.name for carry in CARRIES[:4]])
    (DOCS / "pictures" / "transfer.png").write_bytes(picture.still().data)
    described = f"![{picture.alt}](../pictures/transfer.png)"
    page = re.sub(r"!\[.*\]\(\.\./pictures/transfer\.png\)", described, page)
    path.write_text(page, encoding="utf-8")


def main() -> None:
    """Measure, or take what was measured, and write the page."""
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument(
        "--quick", action="store_true", help="few and short repetitions; writes nothing"
    )
    options.add_argument("--kept", type=Path, help="folder that keeps the rewards")
    options.add_argument(
        "--figure", action="store_true", help="run nothing; draw the figure anew"
    )
    given = options.parse_args()
    if given.figure:
        draw()
        return
    kept, shares = {}, {}
    for carry in CARRIES:
        kept[carry], shares[carry] = measured(carry, given.kept, given.quick)
    tests = sum(
        (c.ways - 1) * (h <= rewards.shape[-1])
        for c, rewards in kept.items()
        for h in HORIZONS
    )
    tables = {
        carry.name: table(carry, rewards, tests) for carry, rewards in kept.items()
    }
    for shown in tables.values():
        print(shown, "\n")
    if given.quick:
        return
    names = {carry.name: f"{shares[carry].mean():.0%}" for carry in CARRIES}
    page = PAGE.format(
        n=REPETITIONS,
        method=METHOD,
        source_steps=SOURCE_STEPS,
        model_steps=MODEL_STEPS,
        verdict=VERDICT.format(
            in_model=last_hour_in_the_model().mean(),
            scratch_4k=kept[CARRIES[3]][:, 0, -500:].mean(),
        ),
        tests=tests,
        alt="",
        shares=", ".join(f"{share} ({name})" for name, share in names.items()),
        tables="\n\n".join(map(in_markdown, tables.values())),
    )
    (DOCS / "studies" / "transfer.md").write_text(page, encoding="utf-8")
    draw()


if __name__ == "__main__":
    main()
