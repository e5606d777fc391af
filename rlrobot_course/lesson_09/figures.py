"""The figures of lesson 09: what holds a robot in a loop, and how the temperature frees it."""

from collections.abc import Sequence

import numpy as np

from rlrobot_course.plots import BLUE, GREEN, GREY, ORANGE, VERMILION, Picture, name_rows
from rlrobot_edu.learning.loop import Step
from rlrobot_edu.widgets.kernels import probabilities

TEMPERATURES = np.logspace(-2, np.log10(50), 60)  # from a cold robot to the highest that LRLE sets


def probability_of_best(x: np.ndarray, temperatures: np.ndarray) -> np.ndarray:
    """With what probability softmax takes the best action; x: preferences, array (A,). Returns as many as T given."""
    return np.array([probabilities(x, temperature).max() for temperature in temperatures])


def plot_pull(q_s: np.ndarray, bias: np.ndarray, labels: Sequence[str], q_max: float) -> Picture:
    """What holds the robot in one state: Q and bias of each action, and how often the best is taken at which T.

    q_s, bias: arrays (A,); labels: names of the actions; q_max: normalises, as in paper equations 10 and 11
    """
    x = (q_s + bias) * 100 / q_max
    best = int(x.argmax())
    figure = Picture(figsize=(8.2, 4.3))
    bars, curve = figure.subplots(1, 2, width_ratios=(3, 2))
    rows = np.arange(len(q_s))
    bars.barh(rows - 0.2, q_s, 0.4, color=BLUE, label="Q(s, a): own experience")
    bars.barh(rows + 0.2, bias, 0.4, color=ORANGE, hatch="//", edgecolor="white", label="bias: similar states")
    bars.axvline(0, color=GREY, linewidth=1)
    name_rows(bars, labels)
    bars.set(xlabel="value (reward)", ylabel="action")
    bars.set_title(f"The bias holds it: {bias[best]:+.2f} against Q = {q_s[best]:+.2f}", fontsize=11)
    figure.legend(loc="outside lower left", ncols=2)  # no bar behind it
    p = probability_of_best(x, TEMPERATURES)
    curve.semilogx(TEMPERATURES, p, color=VERMILION)
    curve.axhline(1 / len(x), color=GREY, linestyle=":")
    curve.annotate("pure chance", (TEMPERATURES[0], 1 / len(x)), (0, 3), textcoords="offset points", color="#505050")
    curve.set_xticks([0.01, 0.1, 1, 10, 50], ["0.01", "0.1", "1", "10", "50"])
    curve.set(xlabel="temperature T", ylabel="P(best action)", ylim=(0, 1.05))
    curve.set_title("Only heat loosens its hold", fontsize=11)
    curve.grid(alpha=0.3)
    figure.alt = (
        f"Bars of Q and bias for {len(x)} actions: {labels[best]} has Q {q_s[best]:.2f} and the largest sum, with a "
        f"bias of {bias[best]:.2f}. A curve: it is taken with probability {p[0]:.2f} at T = {TEMPERATURES[0]:g}, "
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
    above.plot(t[~paid], rank[~paid], "x", color=VERMILION, label="reward below 0")
    above.plot(t[paid], rank[paid], "o", color=GREEN, markersize=4, label="reward above 0")
    above.set(ylabel="state, in order\nof first visit")
    above.locator_params(axis="y", integer=True)
    above.legend(loc="upper left")
    below.step(t, heat, where="mid", color=BLUE)
    below.axhline(default, color=GREY, linestyle=":")
    below.annotate(f"default, {default:g}", (t[-1], default), (0, 3), textcoords="offset points", ha="right")
    below.set(xlabel="step", ylabel="temperature T")
    for ax in (above, below):
        ax.grid(alpha=0.3)
        ax.margins(x=0.01)
    figure.suptitle("The temperature rises until the robot leaves the rut")
    figure.alt = (
        f"{len(steps)} steps in {len(order)} states. The temperature first rises at step "
        f"{t[heat > default][0] if (heat > default).any() else 'none'} and reaches {heat.max():.1f}; the first reward "
        f"above 0 comes at step {t[paid][0] if paid.any() else 'none'}."
    )
    return figure
