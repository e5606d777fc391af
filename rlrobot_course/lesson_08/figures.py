"""The figures of lesson 08: what each kind of trace earns, and of which rewards a value is made."""

from collections.abc import Mapping, Sequence

import numpy as np

from rlrobot_course.figures.plots import (
    BLUE,
    PURPLE,
    RED,
    Picture,
    centred,
    chart,
    draw_weight,
    plain,
)
from rlrobot_course.figures.runs import error_bars
from rlrobot_course.lesson_08.forward_view import online_lambda_return, replay
from rlrobot_edu.learning.size import Size
from rlrobot_edu.show.ends import End, name_ends
from rlrobot_edu.show.numerals import with_minus

NAMES = {
    "accumulating": "SARSA(λ), accumulating traces",
    "replacing": "SARSA(λ), replacing traces",
    "dutch": "true online SARSA(λ)",
}
SHORT = {name: name for name in NAMES} | {"dutch": "true online"}
CREDITED = {**NAMES, "ideal": "the ideal"}
# colour, dashes and mark of each kind of trace, the same in every picture of the lesson
LOOK = {
    "accumulating": {"color": RED, "linestyle": "--", "marker": "^"},
    "replacing": {"color": PURPLE, "linestyle": "-.", "marker": "s"},
    "dutch": {"color": BLUE, "linestyle": "-", "marker": "o"},
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
            title=plain(
                f"{CREDITED[name]}: Q = {value:.1f} at the end".replace("-", "−")
            ),
        )
        newest = ", ".join(f"{x:.2f}" for x in shown[-1])
        told.append(
            f"{CREDITED[name]}: in the last row the weights are {newest}, and Q is {value:.1f}"
        )
    figure.alt = (
        f"Who paid for Q of one pair, α = {alpha:g}. {'. '.join(told)}.".replace(
            "-", "−"
        )
    )
    return figure


def plot_over_alpha(
    alphas: Sequence[float], rewards: Mapping[str, np.ndarray]
) -> Picture:
    """Average reward over the learning rate, one curve for each kind of trace, with 95 % intervals.

    alphas: list (k,); rewards: arrays (k, repetitions) by the name of the trace, as in `forward_view.TRACES`
    """
    repetitions = np.shape(next(iter(rewards.values())))[1]
    last = {trace: float(np.mean(of_each[-1])) for trace, of_each in rewards.items()}
    figure, ax = chart(
        (6.5, 4.2),
        "learning rate α",
        "",
        best_and_worst(last, alphas[-1]),
        grid="y",
        note=f"average reward a step; mark: mean of {repetitions} agents, line: its 95 % interval",
    )
    ends, said = [], []
    # so that the intervals of one α do not hide each other
    aside = 0.008 * np.ptp(alphas)
    for i, (trace, averages) in enumerate(rewards.items()):
        mean, reach = error_bars(np.asarray(averages).T)
        places = np.asarray(alphas) + (i - 1) * aside
        ax.errorbar(places, mean, reach, **LOOK[trace], capsize=3)
        name = f"{SHORT[trace]}\n{mean[-1]:.2f}"
        ends.append(End(float(mean[-1]), name, str(LOOK[trace]["color"])))
        said.append(f"{NAMES[trace]} {mean[0]:.1f} to {mean[-1]:.1f}")
    low, high = ax.get_ylim()
    ax.set_ylim(min(0, low), 1.1 * high)
    ax.set_xticks(alphas)
    name_ends(ax, ends)
    figure.alt = (
        f"Average reward for α from {alphas[0]:g} to {alphas[-1]:g}: {'; '.join(said)}."
    )
    return figure


def best_and_worst(earned: Mapping[str, float], alpha: float) -> str:
    """Which traces earn most and which least, as a sentence. earned: means by the name of the trace, with this α"""
    best, worst = (
        max(earned, key=earned.__getitem__),
        min(earned, key=earned.__getitem__),
    )
    return (
        f"At α = {alpha:g}, {SHORT[best]} traces earn most, {earned[best]:.2f} a step; "
        f"{SHORT[worst]} ones {earned[worst]:.2f}"
    )
