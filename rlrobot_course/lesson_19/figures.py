"""The figure of lesson 19: what one reward has paid of each value."""

from collections.abc import Sequence

import numpy as np

from rlrobot_course.figures.plots import Picture, centred, draw_weight, in_panels
from rlrobot_edu import Agent
from rlrobot_edu.learning.loop import Step


def shares_of(steps: Sequence[Step], t: int, world: str, lam: float) -> np.ndarray:
    """What step `t` has paid for each value by SARSA(λ) after these steps of one episode; array (n_states, n_actions).

    t: from 1. Q is a sum of the rewards, each times a weight. So it is what Q is where all other rewards are 0.
    """
    agent = Agent(world, "SL+SR", lam=lam)
    for step in steps:
        a_next = 0 if step.a_next is None else step.a_next
        agent.update(
            step.s,
            step.a,
            step.r if step.t + 1 == t else 0.0,
            step.s_next,
            a_next,
            step.terminated,
        )
    return agent.q.copy()


def shares_finding(maps: dict[float, np.ndarray], t: int) -> str:
    """Of how many values a step has a share, by λ. maps: shares of the values, by λ"""
    counts = {lam: int(np.count_nonzero(paid)) for lam, paid in maps.items()}
    said = [f"{n} with λ = {lam:g}" for lam, n in counts.items()]
    return f"Values in which step {t} has a share: {', '.join(said)}"


def plot_shares(
    steps: Sequence[Step], t: int, world: str, lambdas: Sequence[float]
) -> Picture:
    """Maps of what step `t` has paid by SARSA(λ), a panel for each λ: rows are the states that it reached.

    steps: of one episode, from `rl.steps`; t: from 1
    """
    maps = {lam: shares_of(steps, t, world, lam) for lam in lambdas}
    states = np.flatnonzero(np.any(list(maps.values()), axis=(0, 2)))
    most = max(np.abs(paid).max() for paid in maps.values())
    picture = Picture(figsize=(1.4 + 2.8 * len(maps), 2.2 + 0.3 * len(states)))
    r = f"{steps[t - 1].r:g}".replace("-", "−")
    note = f"its share in each value Q(s, a), in points; step {t} was paid {r}; blue raised a value, red lowered it"
    picture.headline(shares_finding(maps, t), note)
    told = (f"λ = {lam:g}: {np.count_nonzero(paid)} values, the largest share {paid.flat[np.abs(paid).argmax()]:.2f}"
            for lam, paid in maps.items())  # fmt: skip
    picture.alt = f"What step {t}, which paid {r}, has paid of each value. {'; '.join(told)}.".replace(
        "-", "−"
    )
    for ax, lam, paid in in_panels(picture, maps, sharey=True):
        for (row, a), share in np.ndenumerate(paid[states]):
            if share:
                draw_weight(ax, a, row, share, most)
            text = f"{share:.2g}".replace("-", "−") if share else "·"
            centred(ax, a, row, text)
        ax.set(
            title=f"λ = {lam:g}",
            xlabel="action",
            xlim=(-0.5, paid.shape[1] - 0.5),
            ylim=(len(states) - 0.5, -0.5),
        )
        ax.set(
            xticks=range(paid.shape[1]), yticks=range(len(states)), yticklabels=states
        )
    picture.axes[0].set_ylabel("state")
    return picture
