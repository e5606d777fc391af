"""The figure of lesson 08 that lesson 19 shows: of which rewards a value is made."""

from collections.abc import Sequence

import numpy as np

from rlrobot_course.figures.plots import (
    Picture,
    centred,
    draw_weight,
    plain,
)
from rlrobot_course.lesson_08.forward_view import online_lambda_return, replay
from rlrobot_edu.learning.size import Size
from rlrobot_edu.show.numerals import with_minus

NAMES = {
    "accumulating": "SARSA(λ), accumulating traces",
    "replacing": "SARSA(λ), replacing traces",
    "dutch": "true online SARSA(λ)",
    "ideal": "the ideal",
}


def pair_over_time(trace: str, steps: Sequence[tuple], alpha: float) -> list[float]:
    """The value of the pair (0, 0) after each step, as an agent with this kind of trace learns it.

    trace: a name in `TRACES`; steps: list of (s, a, r, s', a', terminated) with two states and one action
    alpha: learning rate. γ and λ are the defaults of an `Agent`, 0.9.
    """
    return [
        float(agent.q[0, 0])
        for agent in replay(trace, steps, Size((2,), 1), alpha=alpha)
    ]


def weights(name: str, steps: Sequence[tuple], alpha: float) -> np.ndarray:
    """How much of each reward is in the value of the pair (0, 0), after each step; array (n, n), steps by rewards.

    name: one of `TRACES`, or ``ideal``; steps, alpha: as for `pair_over_time`. Q is a sum of the rewards, each times a
    weight; so a weight is what Q is where this reward alone is 1 and all others are 0.
    """
    columns = []
    for k in range(len(steps)):
        alone = [
            (s, a, float(i == k), *rest) for i, (s, a, _, *rest) in enumerate(steps)
        ]
        if name == "ideal":
            columns.append(
                [
                    q[0, 0]
                    for q in online_lambda_return(
                        alone, np.zeros((2, 1)), alpha, 0.9, 0.9
                    )
                ]
            )
        else:
            columns.append(pair_over_time(name, alone, alpha))
    return np.array(columns).T


def plot_credit(steps: Sequence[tuple], *names: str, alpha: float) -> Picture:
    """Maps of who paid: for each step a row, in it the weight of each reward so far in the value of the pair (0, 0).

    steps, alpha: as for `pair_over_time`; names: of `TRACES`, or ``ideal``, a panel each
    """
    figure, n, told = (
        Picture(figsize=(10, 4.6 * ((len(names) + 1) // 2))),
        len(steps),
        [],
    )
    for ax, name in zip(
        figure.subplots((len(names) + 1) // 2, 2, squeeze=False).flat,
        names,
        strict=False,
    ):
        shown, rewards = (
            weights(name, steps, alpha),
            np.array([r for _, _, r, *_ in steps]),
        )
        most = max(1.0, np.abs(shown).max())
        for (t, k), weight in np.ndenumerate(shown):
            if k <= t:
                draw_weight(ax, k + 1, t + 1, weight, most)
                centred(ax, k + 1, t + 1, with_minus(weight, 2), fontsize=7.5)
        value = float(shown[-1] @ rewards)
        ax.set(
            xlim=(0.5, n + 0.5),
            ylim=(n + 0.5, 0.5),
            xticks=range(1, n + 1),
            yticks=range(1, n + 1),
        )
        ax.set(
            xlabel="reward of step",
            ylabel="after step",
            title=plain(f"{NAMES[name]}: Q = {value:.1f} at the end".replace("-", "−")),
        )
        newest = ", ".join(f"{x:.2f}" for x in shown[-1])
        told.append(
            f"{NAMES[name]}: in the last row the weights are {newest}, and Q is {value:.1f}"
        )
    figure.alt = (
        f"Who paid for Q of one pair, α = {alpha:g}. {'. '.join(told)}.".replace(
            "-", "−"
        )
    )
    return figure
