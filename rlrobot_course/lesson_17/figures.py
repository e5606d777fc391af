"""The figures of lesson 17 on planning: robots in cells walk, what they know of the way, and what thinking saves."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle
from scipy import stats

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    ROLE,
    Picture,
    centred,
    draw_arrow,
    draw_lattice,
    film_of,
    in_panels,
    plain,
)
from rlrobot_course.figures.rows import CHANCE, Rows, Values, plot_groups
from rlrobot_course.lesson_17.cells import (
    GOAL,
    MOVES,
    SHAPE,
    SHORTEST,
    START,
    WALLS,
    best_way,
    number,
)
from rlrobot_edu.learning.history import History
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.film_card import Reel, card
from rlrobot_edu.show.images import image_of, in_few_colours, png_of
from rlrobot_edu.show.style import HEADLINE, SHADES_OF_BLUE

KEY = "The dot is the robot, and the band behind it the way of its last ten steps."
NO_PLANNER = "no planner"


def draw_cells(ax: Axes, shades: np.ndarray | None = None) -> None:
    """The cells, row 0 on top, with walls, start and goal. shades: array (rows, columns), nan or 0 to 1."""
    draw_lattice(ax, SHAPE)
    ax.set(xticks=[], yticks=[])
    if shades is not None:
        ax.imshow(
            np.ma.masked_invalid(shades),
            cmap=SHADES_OF_BLUE,
            vmin=0,
            vmax=1.6,
            zorder=0,
        )
    for row, column in WALLS:
        ax.add_patch(
            Rectangle(
                (column - 0.5, row - 0.5),
                1,
                1,
                facecolor=ROLE["wall"],
                hatch="xx",
                alpha=0.7,
            )
        )
    for (row, column), word in ((START, "start"), (GOAL, "goal")):
        centred(ax, column, row + 0.36, word, color=BLACK)


@dataclass(frozen=True, eq=False)
class Walks(Displayed):
    """Robots in cells, side by side, as moving pictures: a frame a step, with the way of the last ten.

    walks: name -> what happened, with its transitions kept; steps: how many are shown
    """

    walks: Mapping[str, History]
    steps: int

    def __repr__(self) -> str:
        told = (f"{name}: {self._said(walk)}" for name, walk in self.walks.items())
        return f"<Robots in cells, {self.steps} steps. {'; '.join(told)}>"

    def _as_html(self) -> str:
        """A card with a film of each, which can be paused."""
        reels = []
        for name, walk in self.walks.items():
            shots = [image_of(each) for each in self._pictures(walk)]
            said = self._said(walk)
            moving = film_of(f"Film of a robot in cells. {said}", shots, 64, 200, 3000)
            last = png_of(in_few_colours(shots[-1], 64))
            end = Still(f"The way of the last steps. {said}", last, moving.width)
            reels.append(Reel(moving, [(f"Step {self.steps}: end", end)], name, said))
        width = sum(reel.moving.width for reel in reels)
        return card(self._finding(), "", reels, KEY, width)

    def _finding(self) -> str:
        """Which robot arrives most often."""
        arrivals = {name: self._arrivals(walk) for name, walk in self.walks.items()}
        most = max(arrivals.values())
        best = [name for name, times in arrivals.items() if times == most]
        if len(best) > 1:
            return f"No robot arrives more often than all others in {self.steps} steps"
        return f"The robot with “{best[0]}” arrives most often in {self.steps} steps"

    def _arrivals(self, walk: History) -> int:
        return int(walk.terminated[: self.steps].sum())

    def _said(self, walk: History) -> str:
        """How often it arrives."""
        arrivals = self._arrivals(walk)
        return f"{arrivals} arrival{'s' * int(arrivals != 1)}"

    def _pictures(self, walk: History) -> Iterator[bytes]:
        """A picture for each step."""
        figure = Picture((3.9, 3.2))
        ax = figure.subplots()
        draw_cells(ax)
        (trail,) = ax.plot([], [], "-", color=BLUE, linewidth=6, alpha=0.4)
        (robot,) = ax.plot([], [], "o", color=BLUE, markersize=15)
        for k in range(1, self.steps + 1):
            ends = walk.terminated[:k]
            begin = max([k - 10, 0, *(np.flatnonzero(ends[:-1]) + 1)])
            y, x = np.divmod([walk.s[begin], *walk.s_next[begin:k]], SHAPE[1])
            trail.set_data(x, y - 0.1)
            robot.set_data(x[-1:], y[-1:] - 0.1)
            said = f"step {k} of {self.steps}, arrivals: {ends.sum()}"
            ax.set_title(said, fontsize=HEADLINE)
            yield figure.png()


def known_cells(q: np.ndarray) -> np.ndarray:
    """The cells in which something is known, array (n, 2) of row and column; q: array (35, 4)"""
    return np.argwhere(q.max(axis=1).reshape(SHAPE) > 0)


def beliefs_finding(tables: Mapping[str, np.ndarray]) -> str:
    """In how many cells something is known; of a single table, how long its way is beside the shortest."""
    first, *_, last = tables if len(tables) > 1 else (*tables, *tables)
    if first == last:
        way = best_way(tables[first])
        if way[-1] != GOAL:
            return "It knows no way from the start yet"
        return f"It knows a way of {len(way) - 1} steps; the shortest takes {SHORTEST}"
    few, many = len(known_cells(tables[first])), len(known_cells(tables[last]))
    return (
        f"The news of the goal has reached {many} cells with {last}; {few} with {first}"
    )


def plot_beliefs(tables: Mapping[str, np.ndarray]) -> Picture:
    """An arrow in every cell of which something is known: the best action there, the darker the more it is worth.

    tables: title of a panel -> Q, array (35, 4)
    """
    size = (2.8 * len(tables), 3.9) if len(tables) > 1 else (5.2, 4.4)
    figure, told = Picture(figsize=size), []
    note = "an arrow: the best action that is known; darker: worth more"
    figure.headline(beliefs_finding(tables), note)
    for ax, title, q in in_panels(figure, tables):
        values = q.max(axis=1).reshape(SHAPE)
        draw_cells(ax, np.where(values > 0, values, np.nan))
        for cell in known_cells(q).tolist():
            down, right = MOVES[int(q[number((cell[0], cell[1]))].argmax())]
            tail = (cell[1] - 0.27 * right, cell[0] - 0.1 - 0.27 * down)
            head = (cell[1] + 0.27 * right, cell[0] - 0.1 + 0.27 * down)
            draw_arrow(ax, tail, head, BLACK, 1.3)
        way = best_way(q)
        leads = (
            f"the way from the start takes {len(way) - 1}"
            if way[-1] == GOAL
            else "no way from the start yet"
        )
        known = len(known_cells(q))
        arrows = f"{known} cell{'s' * int(known != 1)} with an arrow"
        ax.set_title(plain(title))
        ax.set_xlabel(f"{arrows}\n{leads}")
        told.append(f"{title}: {arrows}, {leads}")
    figure.alt = (
        f"Grids of {SHAPE[0]} by {SHAPE[1]} cells with walls. {'; '.join(told)}."
    )
    return figure


def saving_finding(needed: Mapping[str, Sequence[int]]) -> str:
    """How many real steps the middle agent of the quickest group needs, and that of the slowest."""
    middle = {name: float(np.median(steps)) for name, steps in needed.items()}
    best, worst = (
        min(middle, key=middle.__getitem__),
        max(middle, key=middle.__getitem__),
    )
    others = [value for name, value in middle.items() if name != best]
    rest = f"with “{worst}”"
    if len(others) > 1 and len(set(others)) == 1:
        rest = "with each of the others"
    return f"The middle agent needs {middle[best]:.0f} real steps with “{best}”, {middle[worst]:.0f} {rest}"


def plot_real_steps(needed: Mapping[str, Sequence[int]]) -> Picture:
    """Dots, one an agent: after how many real steps its way was the shortest; the middle one as a line."""
    note = "real steps from the first arrival to the shortest way; a dot: one agent, line: the middle one; logarithmic"
    rows = Rows(needed, saving_finding(needed), note, log=True)
    for name, steps in needed.items():
        rows.dots(name)
        rows.line(name, float(np.median(steps)), f"{np.median(steps):.0f}")
    told = [
        f"{name}: {len(n)} agents, the middle one {np.median(n):.0f}"
        for name, n in needed.items()
    ]
    rows.picture.alt = f"Dots, one an agent: real steps until its way is the shortest. {'; '.join(told)}."
    return rows.picture


def planners_finding(earned: Mapping[str, Values]) -> str:
    """In which worlds planning helps clearly, by Welch's test; names are "world, planner", or "world, no planner"."""
    helped: dict[str, bool] = {}
    for name, values in earned.items():
        world = name.partition(",")[0]
        without = earned[f"{world}, {NO_PLANNER}"]
        p = stats.ttest_ind(values, without, equal_var=False).pvalue
        is_better = bool(p < CHANCE and np.mean(values) > np.mean(without))
        helped[world] = helped.get(world, False) or is_better
    yes = " and in ".join(world for world in helped if helped[world])
    no = " nor in ".join(world for world in helped if not helped[world])
    if not yes:
        return f"Planning is not shown to help in {no}"
    if not no:
        return f"Planning helps clearly in {yes}"
    return f"Planning helps clearly in {yes}; in {no} it is not shown to"


def plot_planners(earned: Mapping[str, Values]) -> Picture:
    """What robots earn with each planner in each world. earned: mean reward a step of each robot, by world, planner"""
    return plot_groups(earned, planners_finding(earned), "mean reward a step")


def order_finding(firsts: Mapping[str, np.ndarray]) -> str:
    """How many cells have learned something by each order of thoughts, the most first."""
    known = {title: int((first >= 0).sum()) for title, first in firsts.items()}
    order = sorted(known, key=known.__getitem__, reverse=True)
    said = [f"{known[title]} with {title.partition(':')[0]}" for title in order]
    return f"Cells that have learned something: {', '.join(said)}"


def plot_order(firsts: Mapping[str, np.ndarray]) -> Picture:
    """In each cell the number of the thought that first taught the robot something there; 0 is the real step.

    firsts: title of a panel -> array (35,), -1 where nothing was learned
    """
    figure, told = Picture(figsize=(3.9 * len(firsts), 4.1)), []
    note = "a number: the thought that first taught something in this cell; 0: the real step"
    figure.headline(order_finding(firsts), note)
    for ax, title, first in in_panels(figure, firsts):
        grid, last = first.reshape(SHAPE), max(int(first.max()), 1)
        draw_cells(ax, np.where(grid >= 0, 1 - 0.9 * grid / last, np.nan))
        for row, column in np.argwhere(grid >= 0).tolist():
            centred(ax, column, row - 0.08, str(grid[row, column]), color=BLACK)
        known = np.sort(first[first >= 0])
        told.append(
            f"{title}: {len(known)} cells have learned something, by thought {', '.join(map(str, known))}"
        )
        ax.set_title(plain(title))
        ax.set_xlabel(f"{len(known)} cells have learned something")
    figure.alt = f"Grids of cells with the number of the thought that first taught something there. {'; '.join(told)}."
    return figure
