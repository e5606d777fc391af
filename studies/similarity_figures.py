"""The figures of docs/when_similarity_helps.md; their titles are findings, from the numbers."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from similarity_numbers import LENGTHS, METHOD, Found, estimate, gains, low
from similarity_split import of_order, spectrum_of_noise

from rlrobot_edu.show.palette import BLACK, BLUE, GREY
from rlrobot_edu.show.picture import Picture
from rlrobot_edu.widgets.kernels import bias_of

# The steps of which the title tells are blue.
LINES = (("o", ":", GREY), ("s", "-", BLUE), ("^", "--", BLACK))
RIVALS = {"SR": "SR", "SR, fair T": "SR at T / (2 − k/n)"}
INPUTS = 5  # of the figure of factors, as wander_1k has


def titled(size: tuple[float, float], finding: str, note: str) -> Picture:
    """A picture with a finding as its title, and in grey what is plotted."""
    picture = Picture(size)
    picture.headline(finding, note)
    return picture


def bare(ax: Axes) -> None:
    """Little ink: no frame, faint horizontal lines."""
    ax.spines[:].set_visible(False)
    ax.grid(axis="y", alpha=0.3)
    ax.tick_params(length=0)
    ax.set_axisbelow(True)


def measured_factors() -> np.ndarray:
    """By how much the library's Q + bias exceeds Q for random tables of each order, array (orders,)."""
    shape = (3,) * INPUTS
    noise = np.random.default_rng(0).normal(size=(3**INPUTS, 2))
    found = []
    for k in range(INPUTS + 1):
        q = of_order(noise, shape, k)
        biased = np.array([row + bias_of(q, shape, s) for s, row in enumerate(q)])
        found.append(float((biased * q).sum() / (q * q).sum()))
    return np.array(found)


def factors_picture() -> Picture:
    """Q and the bias on it, by order."""
    its = measured_factors()
    finding = f"× {its[0]:.2g} where no input is needed, × {its[-1]:.2g} where all {INPUTS} are"
    note = f"one table of values for each order; {INPUTS} inputs; computed with the library's bias"
    picture = titled((7.6, 3.6), finding, note)
    ax = picture.subplots()
    bare(ax)
    orders = np.arange(INPUTS + 1)
    ax.bar(orders, np.ones(INPUTS + 1), 0.62, color=GREY, alpha=0.55)
    ax.bar(orders, its - 1, 0.62, bottom=1, color=BLUE)
    for k, factor in enumerate(its):
        ax.text(k, factor + 0.04, f"× {factor:.2g}", ha="center", fontweight="bold")
    ax.text(0, 0.5, "Q", ha="center", va="center", fontsize=12)
    ax.text(0, 1.5, "bias", ha="center", va="center", fontsize=12, color="white")
    names = ["no input", *map(str, orders[1:-1]), f"all {INPUTS} at once"]
    ax.set_xticks(orders, names)
    ax.set(xlabel="how many inputs a part of Q needs", ylim=(0, 2.3), yticks=(0, 1, 2))
    told = ", ".join(f"{factor:.2g}" for factor in its)
    picture.alt = f"Bars for order 0 to {INPUTS}: Q has height 1, and the bias on it makes {told}."
    return picture


def spectra_picture(found: Found) -> Picture:
    """The spectrum of each robot's Q, beside that of random numbers."""
    spectra = found["spectra"]
    robots = len(next(iter(spectra.values()))[METHOD])
    picture = titled(
        (7.6, 3.9),
        spectra_finding(found),
        f"{robots} robots with {METHOD} after an hour: dots; their mean: line; a table of random numbers: grey",
    )
    told = []
    axes = picture.subplots(1, len(spectra), sharey=True)
    for ax, (task, its) in zip(axes, spectra.items(), strict=True):
        shares = 100 * np.array(its[METHOD])
        noise = 100 * spectrum_of_noise(its["shape"])
        orders = np.arange(len(noise))
        bare(ax)
        ax.plot(orders, noise, "_", color=GREY, markersize=19, markeredgewidth=3)
        spread = np.linspace(-0.18, 0.18, robots)
        for k in orders:
            ax.plot(
                k + spread,
                shares[:, k],
                ".",
                color=BLUE,
                alpha=0.5,
                markersize=5,
                clip_on=False,
            )
        ax.plot(orders, shares.mean(axis=0), color=BLUE, linewidth=1.5)
        ax.set_title(f"{task}, n = {len(orders) - 1}", fontsize=11)
        ax.set(xticks=orders, xlabel="order k", ylim=(0, None))
        means = ", ".join(f"{share:.1f}" for share in shares.mean(axis=0))
        told.append(f"{task}: {means}")
    axes[0].set_ylabel("share of the variance of Q [%]")
    picture.alt = f"Shares of the orders in per cent, means. {'; '.join(told)}."
    return picture


def spectra_finding(found: Found) -> str:
    """How much the low orders have in the two tasks with many states."""
    parts = []
    for task in ("wander_1k", "arm_1k"):
        shares = np.array(found["spectra"][task][METHOD])
        parts.append(f"{low(shares):.0f} % in {task}")
    return f"Orders 0 and 1 hold {', '.join(parts)}"


def gain_picture(found: Found) -> Picture:
    """The gain by order: over SR, and over SR at the fair temperature."""
    temperatures = list(found["orders"])
    worlds = gains(found, temperatures[0], "SR").shape[1]
    picture = titled(
        (7.6, 6.4),
        gain_finding(found),
        f"QBIASSR less a rival, {worlds} worlds an order, 95 % intervals; the title: over SR, blue",
    )
    axes = picture.subplots(len(temperatures), len(RIVALS), sharex=True, sharey="row")
    told = []
    for row, temperature in zip(axes, temperatures, strict=True):
        for ax, (rival, name) in zip(row, RIVALS.items(), strict=True):
            its = gains(found, temperature, rival)
            bare(ax)
            ax.axhline(0, color=GREY, linewidth=1)
            for i, (marker, dashes, colour) in enumerate(LINES):
                ends = [estimate(each) for each in its[:, :, i]]
                ax.errorbar(
                    np.arange(len(ends)) + 0.1 * (i - 1),
                    [end.mean for end in ends],
                    [end.half for end in ends],
                    marker=marker,
                    linestyle=dashes,
                    color=colour,
                    label=f"first {LENGTHS[i]:,} steps",
                )
            ax.set_title(f"over {name}, T = {temperature}", fontsize=11)
            middle = ", ".join(f"{each.mean():+.2f}" for each in its[:, :, 1])
            told.append(f"over {name}, T = {temperature}: {middle}".replace("-", "−"))
    for ax in axes[-1]:
        ax.set(xlabel="order k of the rewards")
    # where all curves have fallen
    axes[0, 0].legend(loc="upper right")
    picture.alt = (
        f"Gains for order 0 to 5, in the first {LENGTHS[1]:,} steps. {'; '.join(told)}."
    )
    return picture


def gain_finding(found: Found) -> str:
    """The gain over SR at the ends, in the first 20,000 steps, for each temperature."""
    parts = []
    for temperature in found["orders"]:
        first, *_, last = gains(found, temperature, "SR")[:, :, 1].mean(axis=1)
        parts.append(f"{first:+.2f} to {last:+.2f} (T = {temperature})")
    told = ", ".join(parts).replace("-", "−")
    return f"The gain falls from {told}"
