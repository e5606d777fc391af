"""The figures of lesson 08: three kinds of trace, what each learns, Q_old, and of which rewards a value is made."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.ticker import MaxNLocator

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    GREY,
    PURPLE,
    RED,
    Picture,
    centred,
    chart,
    draw_weight,
    plain,
)
from rlrobot_course.figures.runs import error_bars
from rlrobot_course.figures.words import as_sentence
from rlrobot_course.lesson_08.forward_view import TRACES, online_lambda_return, replay
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

    trace: a name in `TRACES`; steps, alpha: as for `plot_one_pair`
    """
    return [
        float(agent.q[0, 0])
        for agent in replay(trace, steps, Size((2,), 1), alpha=alpha)
    ]


def plot_one_pair(steps: Sequence[tuple], *traces: str, alpha: float) -> Picture:
    """The value of the pair (0, 0), as the online λ-return algorithm and agents with these kinds of trace learn it.

    steps: list of (s, a, r, s', a', terminated) with two states and one action; traces: names in `TRACES`;
    alpha: learning rate. γ and λ are the defaults of an `Agent`, 0.9.
    """
    t = np.arange(1, len(steps) + 1)
    ideal = [
        q[0, 0] for q in online_lambda_return(steps, np.zeros((2, 1)), alpha, 0.9, 0.9)
    ]
    curves = {trace: pair_over_time(trace, steps, alpha) for trace in traces}
    figure, ax = chart(
        (6.5, 4.4),
        "step",
        "",
        farthest_off(curves, ideal[-1]),
        grid="y",
        note=f"Q(open, ahead) after each step, α = {alpha:g}; dotted: a bump",
    )
    ax.plot(t, ideal, color=BLACK, linewidth=5, alpha=0.35)
    ends = [End(float(ideal[-1]), f"ideal\n{with_minus(ideal[-1], 1)}", BLACK)]
    said = [f"The ideal ends at {ideal[-1]:.1f}"]
    for trace, values in curves.items():
        ax.plot(t, values, **LOOK[trace], markersize=5)
        name = f"{trace}\n{with_minus(values[-1], 1)}"
        ends.append(End(values[-1], name, str(LOOK[trace]["color"])))
        said.append(f"{NAMES[trace]} at {values[-1]:.1f}")
    ax.axhline(0, color=GREY, linewidth=0.8)
    for bump in [i for i, (_, _, r, *_) in zip(t, steps, strict=True) if r < 0]:
        ax.axvline(bump, color=GREY, linestyle=":", zorder=0)
    ax.xaxis.set_major_locator(MaxNLocator(integer=True))
    ax.margins(x=0.02)
    name_ends(ax, ends)
    figure.alt = (
        f"Q of one pair over {len(steps)} steps, α = {alpha:g}. {'; '.join(said)}."
    )
    return figure


def farthest_off(curves: Mapping[str, Sequence[float]], ideal: float) -> str:
    """Which traces end farthest from the ideal, as a sentence. curves: values after each step, by the traces' name"""
    off = {trace: abs(values[-1] - ideal) for trace, values in curves.items()}
    worst = max(off, key=off.__getitem__)
    end = with_minus(curves[worst][-1])
    return f"{as_sentence(worst)} traces end at {end}, the ideal at {with_minus(ideal)}"


def weights(name: str, steps: Sequence[tuple], alpha: float) -> np.ndarray:
    """How much of each reward is in the value of the pair (0, 0), after each step; array (n, n), steps by rewards.

    name: one of `TRACES`, or ``ideal``; steps: as for `plot_one_pair`. Q is a sum of the rewards, each times a weight;
    so a weight is what Q is where this reward alone is 1 and all others are 0.
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

    steps, alpha: as for `plot_one_pair`; names: of `TRACES`, or ``ideal``, a panel each
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


def trace_over_time(
    trace: str, visits: Sequence[bool], alpha: float, lam: float = 0.9
) -> np.ndarray:
    """One pair's trace at each step, as Q is updated with it; array (n,).

    trace: ``accumulating``, ``replacing`` or ``dutch``; visits: list (n,), whether the pair is visited in each step
    alpha, lam: learning rate and trace decay. γ is the default of an `Agent`, 0.9.
    """
    if lam == 0:
        return np.array(
            visits, dtype=float
        )  # a fresh trace is 1, and nothing is left of the one before
    steps = [(0 if visited else 1, 0, 0.0, 1, 0, False) for visited in visits]
    agents = replay(trace, steps, Size((2,), 1), alpha=alpha, lam=lam, traces="full")
    return np.array(
        [agent.e[0, 0] / (0.9 * lam) for agent in agents]
    )  # the kernels let it fade after the update


def plot_traces(visits: Sequence[bool], alpha: float) -> Picture:
    """One pair's trace over the steps, accumulating, replacing and dutch, and the limit 1/α.

    visits: list (n,), whether the pair is visited in each step; alpha: learning rate
    """
    curves = {trace: trace_over_time(trace, visits, alpha) for trace in TRACES}
    figure, ax = chart(
        (6.5, 4.2),
        "step",
        "",
        who_overshoots(curves, alpha),
        grid="y",
        note=f"trace e(s, a) of one pair at the update, α = {alpha:g}; tick: the pair is visited",
    )
    t = np.arange(1, len(visits) + 1)
    ends, said = [], []
    for trace, e in curves.items():
        ax.plot(t, e, **LOOK[trace], markersize=4)
        ends.append(End(float(e[-1]), trace, str(LOOK[trace]["color"])))
        said.append(f"{trace} {e.max():.1f}")
    ax.xaxis.set_major_locator(MaxNLocator(integer=True))
    seen = t[np.array(visits)]
    ax.plot(seen, np.full(len(seen), -0.25), "|", color=BLACK, markersize=8)
    ax.axhline(1 / alpha, color=BLACK, linewidth=1, linestyle=(0, (1, 1)))
    ends.append(End(1 / alpha, "α · e = 1", BLACK))
    ax.margins(x=0.02)
    name_ends(ax, ends)
    figure.alt = (
        f"Trace of a pair that is visited {sum(visits)} times in {len(visits)} steps, with α = {alpha:g}. Largest "
        f"values: {', '.join(said)}. α · e is above 1 where the trace is above {1 / alpha:g}."
    )
    return figure


def who_overshoots(curves: Mapping[str, np.ndarray], alpha: float) -> str:
    """Whose α · e exceeds 1, and how far, as a sentence. curves: traces over the steps, by their names"""
    most = {trace: float(e.max()) * alpha for trace, e in curves.items()}
    over = [trace for trace in curves if most[trace] > 1]
    if not over:
        return "No trace makes α · e exceed 1"
    only = "only " if len(over) == 1 else ""
    text = f"{only}{' and '.join(over)} traces make α · e exceed 1: up to {max(most.values()):.1f}"
    return as_sentence(text)


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
