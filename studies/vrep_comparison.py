"""How close is our physics to V-REP's? Compares recordings and writes docs/studies/vrep_comparison.md.

``python studies/vrep_comparison.py``; it needs the recording of the paper's authors, which is not part of the project:
../shared/vrep_recordings/wander_1k_SASR_step.npy, seen from the checkout.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
from joblib import Parallel, delayed
from vrep_worlds import (
    FOUND,
    NOW,
    PRESET,
    STEPS,
    TASK,
    WORLDS,
    Rows,
    World,
    learning,
    same_choices,
)

import rlrobot_edu as rl
from rlrobot_edu.learning.transitions import Transitions

HERE = Path(__file__).parent
DOCS = HERE.parent / "docs"
VREP = HERE.parents[1] / "shared" / "vrep_recordings" / "wander_1k_SASR_step.npy"
VREP_INPUTS = [
    "laser_front",
    "laser_front_left",
    "laser_front_right",
    "laser_left",
    "laser_right",
]
HOUR = 3600
SEEDS = range(6)
REWARDS = (-10.0, -2.0, -0.02, 10.0)
SPINS = (2, 6)  # one wheel forward, the other backward


def vrep_recording() -> rl.Recording:
    """The paper's own recording."""
    return rl.read_recording(
        VREP, legacy=True, task=rl.load_task(TASK), inputs=VREP_INPUTS
    )


def outcomes(
    rows: Rows, of: Callable = lambda s_next, r: (s_next, r)
) -> dict[tuple[int, int], dict]:
    """How often each outcome was seen after each pair (s, a)."""
    counts: dict = {}
    for s, a, s_next, r in zip(
        *(column.tolist() for column in (rows.s, rows.a, rows.s_next, rows.r)),
        strict=True,
    ):
        after = counts.setdefault((s, a), {})
        after[of(s_next, r)] = after.get(of(s_next, r), 0) + 1
    return counts


def often_seen(recordings: list[Rows], least: int = 30) -> set[tuple[int, int]]:
    """The pairs (s, a) with at least `least` visits in each of the recordings."""
    return set.intersection(
        *(
            {
                pair
                for pair, after in outcomes(rows).items()
                if sum(after.values()) >= least
            }
            for rows in recordings
        )
    )


def distance(
    reference: Rows, other: Rows, pairs: set[tuple[int, int]], **of: Callable
) -> float:
    """Mean total variation distance between the outcome distributions of `pairs`, weighted by visits in `reference`.

    0: the same; 1: nothing in common.
    """
    one, two = outcomes(reference, **of), outcomes(other, **of)
    weights, distances = [], []
    for pair in sorted(pairs):
        n, m = sum(one[pair].values()), sum(two[pair].values())
        seen = sorted(one[pair].keys() | two[pair].keys())
        weights.append(n)
        distances.append(
            sum(abs(one[pair].get(o, 0) / n - two[pair].get(o, 0) / m) for o in seen)
            / 2
        )
    return float(np.average(distances, weights=weights))


def joined(parts: list[Transitions]) -> Transitions:
    """Several recordings as one."""
    return Transitions(
        *(np.concatenate(columns) for columns in zip(*parts, strict=True))
    )


def part(rows: Transitions, which: np.ndarray) -> Transitions:
    """Some rows of a recording; which: array (n,) of bool."""
    return Transitions(*(column[which] for column in rows))


def shares(rows: Rows) -> list[float]:
    """Share of each reward."""
    return [float((rows.r == r).mean()) for r in REWARDS]


def row(vrep: Rows, parts: list[Transitions], pairs: set[tuple[int, int]]) -> str:
    """Cells of one row of the page's table; pairs: those that all its rows can be compared by."""
    ours = joined(parts)
    own = often_seen([vrep, ours])
    without_one = [
        distance(vrep, joined([p for p in parts if p is not left_out]), pairs)
        for left_out in parts
    ]
    scatter = math.sqrt(
        (len(parts) - 1) * np.var(without_one)
    )  # the jackknife's standard error
    cells = [
        f"{distance(vrep, ours, own):.3f} ({len(own)})",
        f"{distance(vrep, ours, pairs):.3f} ± {scatter:.3f}",
    ]
    cells += [
        f"{distance(vrep, ours, pairs, of=of):.3f}"
        for of in (lambda s_next, r: r, lambda s_next, r: s_next)
    ]
    return " | ".join([*cells, in_words(shares(ours))])


def in_words(numbers: list[float]) -> str:
    """Shares as a cell of a table."""
    return " / ".join(f"{number:.3f}" for number in numbers)


def floors(vrep: Transitions, ours: list[Transitions]) -> dict[str, float]:
    """Distances between recordings of one and the same simulation."""
    step = np.arange(len(vrep.s))
    rows, blocks = (
        [part(vrep, step // size % 2 == i) for i in (0, 1)] for size in (1, 600)
    )
    others = [joined([other for other in ours if other is not one]) for one in ours]
    seeds = [
        distance(one, rest, often_seen([one, rest]))
        for one, rest in zip(ours, others, strict=True)
    ]
    return {
        "floor_15": distance(*rows, often_seen(rows, least=15)),
        "floor_30": distance(*rows, often_seen(rows, least=30)),
        "floor_blocks": distance(*blocks, often_seen(blocks, least=15)),
        "lowest_seed": min(seeds),
        "highest_seed": max(seeds),
    }


PAGE = """# How close is our physics to V-REP's?

The paper's authors recorded 18,000 steps of `wander_1k` in V-REP, chosen by an agent that learned with TOSL+SR. Our
robot does the same task: in each state it takes the same actions as in V-REP, as often. This compares the simulations,
not the agents. For each pair (s, a) seen at least 30 times in both, we take the total variation distance between the
two distributions of the outcome (s' and r), and average with V-REP's visits as weights. 0 means that the simulations
are the same, 1 that they have nothing in common. Written by `python studies/vrep_comparison.py`.

## How low it can get

Even two recordings of the same simulation do not give 0, since samples vary and depend on the robot's place in the
maze.

| two recordings of one simulation | distance |
|---|---|
| V-REP's even rows against its odd rows, pairs with at least 15 visits in each | {floor_15:.3f} |
| the same, at least 30 visits | {floor_30:.3f} |
| V-REP's even against its odd blocks of 10 minutes, at least 15 visits | {floor_blocks:.3f} |
| one of ours against {others} with other seeds, at least 30 visits | {lowest_seed:.3f} to {highest_seed:.3f} |

The last row was measured in the same way as the table below: a perfect simulation of V-REP would show this value there.

## What brings it closer

Our recordings are {n} of 18,000 steps each, taken together. In brackets: the number of pairs. *The same pairs*, and
the columns after it, are the {pairs} that were seen often enough in all rows; ± is the standard error over ours
(jackknife), and V-REP's one recording scatters, too. V-REP's shares of the rewards −10 / −2 / −0.02 / 10 are
{vrep_shares}.

| our world | distance, its own pairs | the same pairs | r alone | s' alone | shares of the rewards |
|---|---|---|---|---|---|
{rows}

{verdict}

Robot and maze have the dimensions in the authors' scene file, lag and friction the values seen there; none of these
numbers was fitted. How walls turn the robot is our choice: a uniform plate, pushed where it touches. We made it after
we had seen such distances for several others, so take the third digit with care. Lag and friction are off by default:
our robot drives exact arcs, which the course can calculate by hand.

## Learning, hour by hour

Mean reward a step of V-REP's agent and of {n} of ours, which learn with TOSL+SR and choose for themselves; in brackets
the lowest and the highest of them.

| hour | V-REP | ours, ideal | ours with `Realism.vrep()` |
|---|---|---|---|
{hours}

V-REP's row is one agent: its recording does not show how much such agents differ there.

## What still differs

- *Momentum.* After "one wheel back, the other still", which means no motion, the state was the same in {vrep_stop:.0%}
  of V-REP's steps, in {our_stop:.0%} of ours and in {preset_stop:.0%} with `Realism.vrep()`: a command that acts late
  lets the robot drive on.
- *Turning.* After turning on the spot the state was the same in {vrep_spin:.0%} of V-REP's steps, in {our_spin:.0%} of
  ours and in {preset_spin:.0%} with `Realism.vrep()`. V-REP's robot turns by 0.46 rad in such a step, where the radius
  of the wheels and their distance say 0.59. After a turn the other way its state was the same in {vrep_other:.0%},
  after one the same way in {vrep_again:.0%}: this suggests late commands rather than other dimensions. But the lag of
  `Realism.vrep()` is too short for it, and with a longer one, we expect, the robot would drive on too far after a stop.
  The cause is open.
- *Turning about one wheel.* Here the ideal robot differs most: the state was the same in {vrep_pivot:.0%} of V-REP's
  steps, in {our_pivot:.0%} of ours and in {preset_pivot:.0%} with `Realism.vrep()`.
"""


def verdict(
    vrep: Transitions,
    recordings: dict[World, list[Transitions]],
    pairs: set[tuple[int, int]],
) -> str:
    """A text about the default and the preset in the table; its words follow the numbers."""
    found, now, preset = (
        distance(vrep, joined(recordings[world]), pairs)
        for world in (FOUND, NOW, PRESET)
    )
    off = [
        max(abs(np.subtract(shares(joined(recordings[w])), shares(vrep))))
        for w in (FOUND, NOW, PRESET)
    ]
    lower = {True: "lower", False: "raise"}
    return (
        f"Maze and robot together {lower[now < found]} the distance by {abs(now - found):.3f}; lag and friction\n"
        f"then {lower[preset < now]} it by {abs(preset - now):.3f}. A reward's share is off by at most {off[0]:.3f}\n"
        f"as found, {off[1]:.3f} now and {off[2]:.3f} with lag and friction."
    )


def after_a_spin(rows: Rows) -> list[float]:
    """How often a spin left the state as it was, after a spin the same way and after one the other way."""
    spins, stayed = np.isin(rows.a, SPINS), rows.s == rows.s_next
    both, again = spins[1:] & spins[:-1], rows.a[1:] == rows.a[:-1]
    return [float(stayed[1:][both & same].mean()) for same in (again, ~again)]


def page() -> str:
    """The whole page. Takes about three minutes on two cores."""
    vrep = vrep_recording().transitions
    parallel = Parallel(n_jobs=-1)
    jobs = parallel(
        delayed(same_choices)(world, seed, vrep)
        for world in WORLDS.values()
        for seed in SEEDS
    )
    n = len(SEEDS)
    recordings = {
        world: jobs[i * n : (i + 1) * n] for i, world in enumerate(WORLDS.values())
    }
    learnt = parallel(
        delayed(learning)(world, seed) for world in (NOW, PRESET) for seed in SEEDS
    )
    hours = [
        np.reshape(rewards, (-1, STEPS // HOUR, HOUR)).mean(axis=2)
        for rewards in (vrep.r, learnt[:n], learnt[n:])
    ]
    pairs = often_seen([vrep, *(joined(parts) for parts in recordings.values())])
    now, preset = joined(recordings[NOW]), joined(recordings[PRESET])

    def stayed(rows: Rows, actions: tuple[int, ...]) -> float:
        chosen = np.isin(rows.a, actions)
        return float((rows.s == rows.s_next)[chosen].mean())

    def hour(i: int) -> str:
        cells = [
            f"{h[:, i].mean():.2f} ({h[:, i].min():.2f} to {h[:, i].max():.2f})"
            for h in hours[1:]
        ]
        return f"| {i + 1} | {hours[0][0, i]:.2f} | {' | '.join(cells)} |"

    return PAGE.format(
        **floors(vrep, recordings[NOW]),
        n=n,
        others=n - 1,
        pairs=len(pairs),
        vrep_shares=in_words(shares(vrep)),
        rows="\n".join(
            f"| {name} | {row(vrep, recordings[world], pairs)} |"
            for name, world in WORLDS.items()
        ),
        verdict=verdict(vrep, recordings, pairs),
        hours="\n".join(map(hour, range(STEPS // HOUR))),
        **{
            f"{who}_{what}": stayed(rows, actions)
            for who, rows in {"vrep": vrep, "our": now, "preset": preset}.items()
            for what, actions in {
                "stop": (1, 3),
                "spin": SPINS,
                "pivot": (5, 7),
            }.items()
        },
        **dict(zip(("vrep_again", "vrep_other"), after_a_spin(vrep), strict=True)),
    )


if __name__ == "__main__":
    (DOCS / "studies" / "vrep_comparison.md").write_text(page(), encoding="utf-8")
    print(DOCS / "studies" / "vrep_comparison.md")
