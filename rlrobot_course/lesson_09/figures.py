"""The figures of lesson 09: what holds a robot in a loop, how the temperature frees it, and what that is worth."""

from collections.abc import Mapping, Sequence

import numpy as np

from rlrobot_course.figures.plots import (
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    RED,
    Picture,
    chart,
    legend_below,
    plain,
)
from rlrobot_course.play.challenge import Score
from rlrobot_edu.learning.loop import Step
from rlrobot_edu.widgets.kernels import probabilities

TEMPERATURES = np.logspace(
    -2, np.log10(50), 60
)  # from a cold robot to the highest that LRLE sets


def probability_of_best(x: np.ndarray, temperatures: np.ndarray) -> np.ndarray:
    """With what probability softmax takes the best action; x: preferences, array (A,). Returns as many as T given."""
    return np.array(
        [probabilities(x, temperature).max() for temperature in temperatures]
    )


def plot_pull(
    q_s: np.ndarray, bias: np.ndarray, labels: Sequence[str], q_max: float
) -> Picture:
    """What holds the robot in one state: Q and bias of its best two actions, and what T makes of it.

    q_s, bias: arrays (A,); labels: names of the actions; q_max: normalises, as in paper equations 10 and 11
    """
    x = (q_s + bias) * 100 / q_max
    best = (-x).argsort(kind="stable")[:2]
    figure = Picture(figsize=(8.2, 3.2))
    bars, curve = figure.subplots(1, 2, width_ratios=(3, 2))
    parts = {"Q(s, a)": q_s, "bias": bias, "sum": q_s + bias}
    for k, (name, values) in enumerate(parts.items()):
        look = {
            "color": (BLUE, ORANGE, GREY)[k],
            "hatch": ("", "//", "..")[k],
            "edgecolor": "white",
        }
        drawn = bars.bar(
            np.arange(2) + 0.27 * (k - 1), values[best], 0.25, label=name, **look
        )
        bars.bar_label(drawn, [f"{value:.2f}" for value in values[best]])
    bars.axhline(0, color=GREY, linewidth=1)
    bars.set_xticks((0, 1), [plain(labels[a]) for a in best])
    bars.margins(y=0.15)
    bars.set(ylabel="value (reward)")
    bars.set_title(f"The bias holds it: {bias[best[0]]:.2f}", fontsize=11)
    figure.legend(loc="outside lower left", ncols=3)
    p = probability_of_best(x, TEMPERATURES)
    curve.semilogx(TEMPERATURES, p, color=RED)
    curve.axhline(1 / len(x), color=GREY, linestyle=":")
    curve.annotate(
        "pure chance",
        (TEMPERATURES[0], 1 / len(x)),
        (0, 3),
        textcoords="offset points",
        color="#505050",
    )
    curve.set_xticks([0.01, 0.1, 1, 10, 50], ["0.01", "0.1", "1", "10", "50"])
    curve.set(
        xlabel="temperature T", ylabel=plain(f"P({labels[best[0]]})"), ylim=(0, 1.05)
    )
    curve.set_title("Only heat loosens its hold", fontsize=11)
    curve.grid(alpha=0.3)
    told = [f"{labels[a]}: Q {q_s[a]:.2f}, bias {bias[a]:.2f}" for a in best]
    figure.alt = (
        f"Bars of Q and bias of the best two of {len(x)} actions, {'; '.join(told)}. A curve: the first is taken with "
        f"probability {p[0]:.2f} at T = {TEMPERATURES[0]:g}, {probability_of_best(x, np.ones(1))[0]:.2f} at T = 1 and "
        f"{p[-1]:.2f} at T = 50."
    )
    return figure


def plot_escape(steps: Sequence[Step], default: float) -> Picture:
    """States, rewards and temperatures of some steps in which LRLE frees a robot.

    steps: from `rl.steps`; default: the temperature outside loops
    """
    t = np.arange(1, len(steps) + 1)
    order: dict[int, int] = {}
    rank = np.array([order.setdefault(step.s, len(order) + 1) for step in steps])
    paid = np.array([step.r > 0 for step in steps])
    heat = np.array([step.temperature for step in steps])
    figure = Picture(figsize=(7, 4.6))
    above, below = figure.subplots(2, 1, sharex=True)
    above.plot(t[~paid], rank[~paid], "x", color=RED, label="reward below 0")
    above.plot(
        t[paid], rank[paid], "o", color=GREEN, markersize=4, label="reward above 0"
    )
    above.set(ylabel="state, in order\nof first visit")
    above.locator_params(axis="y", integer=True)
    above.legend(loc="upper left")
    below.step(t, heat, where="mid", color=BLUE)
    below.axhline(default, color=GREY, linestyle=":")
    below.annotate(
        f"default, {default:g}", (t[0], default), (0, 3), textcoords="offset points"
    )
    below.set(xlabel="step", ylabel="temperature T")
    for ax in (above, below):
        ax.grid(alpha=0.3)
        ax.margins(x=0.01)
    figure.headline("The temperature rises until the robot leaves the rut")
    figure.alt = (
        f"{len(steps)} steps in {len(order)} states. The temperature first rises at step "
        f"{t[heat > default][0] if (heat > default).any() else 'none'} and reaches {heat.max():.1f}; the first reward "
        f"above 0 comes at step {t[paid][0] if paid.any() else 'none'}."
    )
    return figure


def plot_worth(pairs: Mapping[str, tuple[Score, Score]], title: str) -> Picture:
    """What robots earn without loop evasion and with it, two bars with 95 % intervals for each kind of robot.

    pairs: by the name of a kind, its scores without and with
    """
    figure, ax = chart((7, 3.6), "", "reward a step", title, grid="y")
    looks = ({"color": "white", "edgecolor": GREY, "hatch": "//"}, {"color": BLUE})
    for i, (name, look) in enumerate(zip(("without", "with"), looks, strict=True)):
        means, halves = np.array([both[i] for both in pairs.values()]).T
        where = np.arange(len(pairs)) + 0.4 * i - 0.2
        ax.bar(
            where,
            means,
            0.4,
            yerr=halves,
            capsize=4,
            label=f"{name} loop evasion",
            **look,
        )
        for x, mean, half in zip(where, means, halves, strict=True):
            ax.annotate(
                f"{mean:.2f}",
                (x, mean + half),
                (0, 3),
                textcoords="offset points",
                ha="center",
            )
    ax.set_xticks(range(len(pairs)), map(plain, pairs))
    ax.margins(y=0.12)
    legend_below(figure, 2)
    told = "; ".join(
        f"{plain(name)}: {both[0]} without, {both[1]} with"
        for name, both in pairs.items()
    )
    figure.alt = f"Reward a step, means with 95 % intervals, without and with loop evasion. {told}."
    return figure
