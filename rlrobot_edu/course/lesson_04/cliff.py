"""The cliff (Sutton & Barto, example 6.6): a world in which Q-learning and SARSA learn different ways."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from functools import cache
from itertools import pairwise

import gymnasium
import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from rlrobot_edu.learning.history import History
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.show.palette import CURVES, ROLE
from rlrobot_edu.show.picture import Picture

SHAPE = (4, 12)  # rows and columns; state = 12 · row + column
START, GOAL = 36, 47
CLIFF = range(START + 1, GOAL)
MOVES = ("up", "right", "down", "left")  # actions 0 to 3


@cache
def cliff_model(episode_steps: int = 500) -> SampleModel:
    """Gymnasium's ``CliffWalking-v1``, copied from its table of outcomes into a model that learns compiled.

    episode_steps: steps after which an episode is cut off; the original has no such limit
    """
    env = gymnasium.make("CliffWalking-v1")
    pairs = [(s, a) for s in range(env.observation_space.n) for a in range(env.action_space.n)]
    # without slipping every pair has one outcome: probability 1, s', r, terminated
    outcomes = [env.unwrapped.P[s][a][0] for s, a in pairs]
    _, s_next, r, terminated = (np.array(column) for column in zip(*outcomes, strict=True))
    return SampleModel(
        shape=SHAPE,
        n_actions=len(MOVES),
        offsets=np.arange(len(pairs) + 1),
        s_next=s_next.astype(np.int64),
        r=r.astype(float),
        terminated=terminated.astype(bool),
        cumulative=np.ones(len(pairs), dtype=np.int64),
        starts=np.array([START]),
        rewards=np.unique(r).astype(float),
        episode_steps=episode_steps,
    )


def greedy_path(q: np.ndarray) -> tuple[int, ...]:
    """States from start to goal of an agent that always takes its best action and does not learn any more.

    q: array (48, 4). Where the way comes back to a state it has passed, it would go round for ever: it ends there.
    """
    model, path = cliff_model(), [START]
    while path[-1] != GOAL and len(set(path)) == len(path):
        path.append(model.outcomes(path[-1], int(q[path[-1]].argmax()))[0][0])
    return tuple(path)


def count_ways(histories: Sequence[History]) -> dict[str, int]:
    """How many agents keep to the edge of the cliff, leave it, or are lost, when they no longer explore."""
    ways = [greedy_path(history.q) for history in histories]
    arrived = [min(way[1:]) for way in ways if way[-1] == GOAL]  # the smaller the number, the higher the row
    edge = sum(highest // SHAPE[1] == SHAPE[0] - 2 for highest in arrived)
    return {"edge": edge, "off": len(arrived) - edge, "lost": len(ways) - len(arrived)}


def plot_paths(groups: Mapping[str, Sequence[History]]) -> Picture:
    """The ways of agents that no longer explore, one grid a group; the more agents take a move, the thicker its line.

    groups: names and the histories of repetitions of one method
    """
    figure = Picture(figsize=(7.2, 2.7 * len(groups)), layout="constrained")
    figure.alt = "Grids of 4 by 12 cells with the cliff between start and goal."
    grids = figure.subplots(len(groups), 1, squeeze=False)[:, 0]
    for ax, (name, histories), (colour, _) in zip(grids, groups.items(), CURVES, strict=False):
        _draw_grid(ax)
        moves = Counter(move for history in histories for move in pairwise(greedy_path(history.q)))
        for move, agents in moves.items():
            row, column = np.unravel_index(move, SHAPE)
            ax.plot(column, row, color=colour, linewidth=0.5 + 9 * agents / len(histories), solid_capstyle="round")
        ways = count_ways(histories)
        title = f"{name}: {ways['edge']} of {len(histories)} agents walk along the edge, {ways['off']} farther off"
        ax.set_title(title + (f", {ways['lost']} lost" if ways["lost"] else ""))
        figure.alt += f" {ax.get_title()}."
    return figure


def _draw_grid(ax: Axes) -> None:
    """Cells, cliff, start and goal, row 0 on top."""
    rows, columns = SHAPE
    ax.set(xlim=(-0.5, columns - 0.5), ylim=(rows - 0.5, -0.5), aspect="equal", xlabel="column", ylabel="row")
    ax.set_xticks(range(columns))
    ax.set_yticks(range(rows))
    ax.set_xticks(np.arange(columns) - 0.5, minor=True)
    ax.set_yticks(np.arange(rows) - 0.5, minor=True)
    ax.grid(which="minor", alpha=0.4)
    ax.tick_params(which="both", length=0)
    ax.add_patch(Rectangle((0.5, rows - 1.5), len(CLIFF), 1, facecolor=ROLE["wall"], hatch="xx", alpha=0.6))
    box = {"facecolor": "white", "edgecolor": "none", "pad": 2}
    ax.text((columns - 1) / 2, rows - 1, "the cliff: −100, back to the start", ha="center", va="center", bbox=box)
    for state, word in ((START, "start"), (GOAL, "goal")):
        row, column = np.unravel_index(state, SHAPE)
        ax.text(column, row + 0.28, word, ha="center", va="center", fontsize=9)
