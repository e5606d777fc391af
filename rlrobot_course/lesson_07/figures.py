"""The figures of lesson 07: how a reward spreads, how a trace fades, and who paid for a value."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.patches import Rectangle

from rlrobot_course.plots import BLACK, BLUE, VERMILION, Picture, chart, plain
from rlrobot_edu import Agent, Step


def plot_corridor(values: Mapping[str, np.ndarray], title: str) -> Picture:
    """How far a reward has got in a corridor: one panel a method, one row an episode, one column a cell.

    values: name of the method to array (episodes, cells), Q of each cell after each episode
    """
    highest = max(table.max() for table in values.values())
    picture = Picture(figsize=(0.4 + 4.6 * len(values), 4.0))
    picture.suptitle(plain(title))
    known = (f"{name}: after episode 1, {np.count_nonzero(table[0])} of {table.shape[1]} cells have a value above 0, "
             f"the first of them cell {np.flatnonzero(table[0])[0]}" for name, table in values.items())  # fmt: skip
    picture.alt = f"{title}. {'; '.join(known)}."
    for ax, (name, table) in zip(picture.subplots(1, len(values), squeeze=False)[0], values.items(), strict=True):
        ax.imshow(table, cmap="cividis", vmin=0, vmax=highest, aspect="auto")
        for (row, column), q in np.ndenumerate(table):
            colour = BLACK if q > 0.45 * highest else "white"
            ax.text(column, row, f"{q:.1f}", ha="center", va="center", color=colour, fontsize=8)
        ax.set(title=plain(name), xlabel="cell (the reward lies behind the last one)", ylabel="after episode")
        ax.set_xticks(range(table.shape[1]))
        ax.set_yticks(range(table.shape[0]), range(1, table.shape[0] + 1))
    return picture


def paid_by(steps: Sequence[Step], t: int, world: str, lam: float) -> np.ndarray:
    """What step `t` has paid for each value by SARSA(λ) after these steps of one episode; array (n_states, n_actions).

    Q is a sum of the rewards, each times a weight. So it is what Q is where all other rewards are 0.
    """
    agent = Agent(world, "SL+SR", lam=lam)
    for step in steps:
        a_next = 0 if step.a_next is None else step.a_next
        agent.update(step.s, step.a, step.r if step.t == t else 0.0, step.s_next, a_next, step.terminated)
    return agent.q.copy()


def plot_paid(steps: Sequence[Step], t: int, world: str, lambdas: Sequence[float]) -> Picture:
    """Maps of what step `t` has paid by SARSA(λ), a panel for each λ: rows are the states that it reached.

    steps: of one episode, from `rl.steps`
    """
    maps = {lam: paid_by(steps, t, world, lam) for lam in lambdas}
    states = np.flatnonzero(np.any(list(maps.values()), axis=(0, 2)))
    most = max(np.abs(paid).max() for paid in maps.values())
    picture = Picture(figsize=(1 + 2.6 * len(maps), 1.4 + 0.3 * len(states)))
    told = (f"λ = {lam:g}: {np.count_nonzero(paid)} values, the largest share {paid.flat[np.abs(paid).argmax()]:.2f}"
            for lam, paid in maps.items())  # fmt: skip
    picture.alt = f"What step {t}, which paid {steps[t].r:g}, has paid of each value. {'; '.join(told)}.".replace(
        "-", "−"
    )
    for ax, (lam, paid) in zip(
        picture.subplots(1, len(maps), sharey=True, squeeze=False)[0], maps.items(), strict=True
    ):
        for (row, a), share in np.ndenumerate(paid[states]):
            colour, opacity = (BLUE if share > 0 else VERMILION), 0.1 + 0.6 * np.sqrt(abs(share) / most)
            if share:
                ax.add_patch(Rectangle((a - 0.5, row - 0.5), 1, 1, facecolor=colour, alpha=opacity))
            text = f"{share:.2g}".replace("-", "−") if share else "·"
            ax.text(a, row, text, ha="center", va="center", fontsize=8)
        ax.set(title=f"λ = {lam:g}", xlabel="action", xlim=(-0.5, paid.shape[1] - 0.5), ylim=(len(states) - 0.5, -0.5))
        ax.set(xticks=range(paid.shape[1]), yticks=range(len(states)), yticklabels=states)
    picture.axes[0].set_ylabel("state")
    return picture


def trace_curve(visits: Sequence[int], steps: int, gamma: float, lam: float, accumulating: bool = False) -> np.ndarray:
    """The trace of one pair at each step, as the update of that step uses it; array (steps,).

    visits: steps at which the pair is visited; each visit leaves (γλ)^n after n steps. A replacing trace is what the
    last visit left, an accumulating one the sum of what all of them left. Source: Sutton & Barto, section 12.7.
    """
    since = np.arange(steps) - np.array(sorted(visits))[:, None]
    left = np.where(since >= 0, (gamma * lam) ** np.maximum(since, 0), 0.0)
    return left.sum(axis=0) if accumulating else left.max(axis=0)


def plot_trace(visits: Sequence[int], steps: int = 40, gamma: float = 0.9, lam: float = 0.9) -> Picture:
    """The trace of one pair, replacing and accumulating, with a mark at each visit."""
    replacing = trace_curve(visits, steps, gamma, lam)
    accumulating = trace_curve(visits, steps, gamma, lam, accumulating=True)
    title = "Replacing stops at 1, accumulating adds up"
    picture, ax = chart((6.5, 3.6), "step", "trace e(s, a)", title)
    picture.alt = (
        f"The trace of one pair over {steps} steps, visited at {', '.join(map(str, visits))}. It fades after each "
        f"visit. Replacing never exceeds {replacing.max():.2f}; accumulating reaches {accumulating.max():.2f}."
    )
    t = np.arange(steps)
    ax.plot(t, accumulating, color=VERMILION, linestyle="--", marker="s", markersize=3.5, label="accumulating: e + 1")
    ax.plot(t, replacing, color=BLUE, marker="o", markersize=3.5, label="replacing: 1")
    ax.plot(visits, np.full(len(visits), -0.12), "^", color=BLACK, markersize=7, label="the pair is visited")
    ax.legend(loc="upper right")
    return picture
