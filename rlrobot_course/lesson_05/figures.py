"""The figures of lesson 05: which states have a say in one state, what their bias is worth, and when it misleads."""

from itertools import zip_longest

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from rlrobot_course.lesson_05.arrivals import (
    GROUP_LABELS,
    Arrivals,
    mean_by_visits,
    quality,
    share_of_bias,
    watch_arrivals,
)
from rlrobot_course.plots import BLACK, BLUE, GREY, PURPLE, Picture, plain
from rlrobot_course.runs import error_bars
from rlrobot_edu import Agent, SampleModel, Task, learn, load_task, make_env, value_iteration
from rlrobot_edu.task.variables import Bin
from rlrobot_edu.widgets.bias_explorer.bias import bias_numbers
from rlrobot_edu.widgets.bias_explorer.marks import Mark, marks_of
from rlrobot_edu.widgets.bias_explorer.words import name_text, state_words, value_words
from rlrobot_edu.widgets.kernels import probabilities

BEFORE, AFTER = 1000, 1500  # steps of learning, before all about a state is forgotten, and after it
LEARNERS = {"TOSL+SR": (GREY, "s--"), "TOSL+QBIASSR": (BLUE, "o-")}


def plot_similar_states(s: int) -> Picture:
    """The sets of state `s` of worked_example, one a row: the states that share all inputs with it but one.

    `s` itself is in each row. The arrow is the robot: it stands in the cell (X, Y) and points where the robot looks, θ.
    A thick bar before its tip: something is ahead (d = 1); a dotted one: the way is free. Raises ValueError if there
    is no such state.
    """
    task = load_task("worked_example")
    sets = task.states.siblings(s)
    figure = Picture(figsize=(5.2, 5.8))
    maps = figure.subplots(len(sets), 3)
    for row, (name, states), mark in zip(maps, sets.items(), marks_of(task).values(), strict=True):
        for ax, k in zip_longest(row, map(int, states)):
            ax.set_axis_off()
            if k is not None:
                _draw_pose(ax, task.states.decode(k), mark)
                value = f"{name_text(name)} = {value_words(task.states.decode(k)[name])}"
                ax.set_title(f"{mark.sign} {value}: state {k}", fontsize=10, weight="bold" if k == s else "normal")
    figure.suptitle(f"State {s} ({state_words(task, s)}) is in each of its sets", fontsize=11)
    words = "; ".join(f"{name_text(name)}: {', '.join(map(str, states))}" for name, states in sets.items())
    figure.alt = f"Small maps of the four cells with the robot, a row for each set of state {s}. {words}."
    return figure


def _draw_pose(ax: Axes, bins: dict[str, Bin], mark: Mark) -> None:
    """Four cells, the robot as an arrow in one of them, and before it a bar: thick if the way is blocked."""
    x, y, theta, blocked = (bins[name].reading for name in ("X", "Y", "theta", "d"))
    for column in (0, 1):
        for row in (0, 1):
            here = (column, row) == (x, y)
            ax.add_patch(Rectangle((column - 0.5, row - 0.5), 1, 1, facecolor=mark.colour if here else "white",
                                   edgecolor=GREY, linewidth=0.8))  # fmt: skip
    along = np.array([np.cos(np.radians(theta)), np.sin(np.radians(theta))])
    across, middle = np.array([-along[1], along[0]]), np.array([x, y])
    ax.annotate("", middle + 0.32 * along, middle - 0.32 * along,
                arrowprops={"arrowstyle": "-|>", "color": BLACK, "linewidth": 2})  # fmt: skip
    bar = np.array([middle + 0.42 * along + side * 0.35 * across for side in (-1, 1)])
    ax.plot(*bar.T, color=BLACK, linewidth=4 if blocked else 1.2, linestyle="-" if blocked else ":")
    ax.set(xlim=(-0.6, 1.6), ylim=(-0.6, 1.6), aspect="equal")


def plot_bias_ageing(model: SampleModel, *, steps: int = 300, repetitions: int = 60) -> Picture:
    """Whenever an agent comes to a state: would its best action by Q + bias be better than its best by Q alone?

    Left: their `quality`, by how often the agent has been in the state before; the judge is value iteration on the
    model. Right: the share of the bias in both gaps. Means of the repetitions with 95 % intervals (resampling).
    The bias never fades: s itself is a member of every set, so that a fixed part of Q(s) is in the bias, too.
    model: the world to learn in; steps, repetitions (at least 2): of each learning process
    """
    q_best = value_iteration(model).q
    by_visits = []  # of each agent: quality alone, quality with the bias, share of the bias
    for agent_seed, env_seed in (child.spawn(2) for child in np.random.SeedSequence(0).spawn(repetitions)):
        agent = Agent(model, seed=agent_seed, loop_evasion=False)
        seen = watch_arrivals(agent, make_env(model, env_seed), steps)
        values = (
            quality(q_best, seen.s, seen.q),
            quality(q_best, seen.s, seen.q + seen.bias),
            100 * share_of_bias(seen.q, seen.bias),
        )
        by_visits.append([mean_by_visits(seen.visits, column) for column in values])
    alone, biased, share = np.array(by_visits).swapaxes(0, 1)

    figure = Picture(figsize=(9, 4))
    left, right = figure.subplots(1, 2)
    words = [
        draw_by_visits(left, alone, "Q(s) alone", GREY, "s--"),
        draw_by_visits(left, biased, "Q(s) + bias(s)", BLUE, "o-"),
        draw_by_visits(right, share, "share of the bias in %", PURPLE, "D-"),
    ]
    new, without = np.nanmean(biased[:, 0]), np.nanmean(alone[:, 0])
    left.axhline(0, color="black", linewidth=0.8)
    left.set(ylabel="quality of the best action\n(0 = a guess, 1 = the best there is)", ylim=(None, 1.05))
    left.set_title(f"In a new state: {new:.2f} with the bias, {without:.2f} without", fontsize=11)
    left.legend(loc="lower right")
    later = np.nanmean(share[:, 4])
    right.set(ylabel="share of the bias in both gaps (%)", ylim=(0, 105))
    right.set_title(f"It does not fade: still {later:.0f} % after 8–15 visits", fontsize=11)
    note = f"TOSL+QBIASSR: means of {repetitions} agents that learned for {steps} steps, and 95 % intervals"
    figure.supxlabel(note, fontsize=9)
    figure.alt = f"Quality of the best action, and share of the bias, by earlier visits. {'; '.join(words)}. {note}."
    return figure


def plot_misleading_bias(task: Task, model: SampleModel, state: int, *, repetitions: int = 20) -> Picture:
    """How probable the best action of `state` is, as the state is visited again after all about it was forgotten.

    TOSL+QBIASSR learns for 1,000 steps and Q(state) is set to 0. Two agents go on from this table for 1,500
    steps, with and without the bias. Left: what the sets of the state think when it is forgotten. Right: the
    probability of the action that value iteration finds best, by visits. Means of the repetitions, 95 % intervals.
    task, model: the task and the sample model of it
    """
    actions = [task.actions.label(a) for a in range(task.actions.n)]
    best = int(value_iteration(model).q[state].argmax())
    tables, chances = [], {method: [] for method in LEARNERS}
    for seeds in (child.spawn(6) for child in np.random.SeedSequence(0).spawn(repetitions)):
        teacher = Agent(model, seed=seeds[0], loop_evasion=False)
        learn(teacher, make_env(model, seeds[1]), BEFORE, progress=False)
        q = teacher.q.copy()
        q[state] = 0.0
        tables.append(q)
        for i, method in enumerate(LEARNERS):
            agent = Agent(model, method, seed=seeds[2 + 2 * i], loop_evasion=False)
            agent.q[...] = q
            seen = watch_arrivals(agent, make_env(model, seeds[3 + 2 * i]), AFTER)
            chances[method].append(_chance_by_visits(agent, seen, state, best))

    figure = Picture(figsize=(9.5, 4.2))
    left, right = figure.subplots(1, 2)
    thought = bias_numbers(task, np.mean(tables, axis=0), state, teacher.parameters.q_scale, 1.0)
    bars = [(f"{mark.sign} mean over {name_text(name)}", mark.colour) for name, mark in marks_of(task).items()]
    for i, (row, (label, colour)) in enumerate(
        zip([*thought.means, thought.bias], [*bars, ("bias", BLACK)], strict=True)
    ):
        left.bar(np.arange(len(actions)) + 0.16 * (i - 2), row, 0.16, label=plain(label), color=colour)
    left.set_xticks(range(len(actions)), map(plain, actions))
    left.axhline(0, color="black", linewidth=0.8)
    left.set_ylabel("action value")
    left.legend(fontsize=8.5)
    advice = actions[int(thought.bias.argmax())]
    title = f"State {state} forgotten: best is {actions[best]},\nits bias is largest for {advice}"
    left.set_title(plain(title), fontsize=11)
    words = [draw_by_visits(right, 100 * np.array(chances[name]), name, *look) for name, look in LEARNERS.items()]
    right.axhline(100 / len(actions), color="black", linewidth=0.8, linestyle=":", label="a guess")
    right.set(ylabel=plain(f"probability of {actions[best]} (%)"), ylim=(0, 105))
    without, biased = (100 * np.nanmean(np.array(runs)[:, 0]) for runs in chances.values())
    right.set_title(f"On the first visit: {without:.0f} % without,\n{biased:.0f} % with the bias", fontsize=11)
    right.legend()
    note = f"means of {repetitions} agents that forgot the state after {BEFORE} steps, and 95 % intervals"
    figure.supxlabel(note, fontsize=9)
    figure.alt = (
        f"State {state} of {task.name} ({state_words(task, state)}): the best action is {actions[best]}, the bias is "
        f"largest for {advice}. Probability of {actions[best]} in %, by earlier visits. {'; '.join(words)}. {note}."
    )
    return figure


def _chance_by_visits(agent: Agent, seen: Arrivals, state: int, best: int) -> np.ndarray:
    """Mean probability of the action `best` in `state`, by how often the agent had been there; array (groups,)."""
    here = seen.s == state
    x = seen.q[here] + (0.0 if agent.bias is None else seen.bias[here])
    scale = agent.parameters.q_scale
    chance = [probabilities(row * scale, agent.parameters.temperature)[best] for row in x]
    return mean_by_visits(seen.visits[here], np.array(chance, dtype=float))


def draw_by_visits(ax: Axes, values: np.ndarray, label: str, colour: str, style: str) -> str:
    """A curve over the groups, with 95 % intervals; returns its means in words.

    A group that fewer than half of the repetitions reached is left out: these are not like the others.
    values: array (repetitions, groups); style: mark and dashes
    """
    x, means, reaches = [], [], []
    for g, column in enumerate(values.T):
        known = column[~np.isnan(column)]
        if len(known) > 1 and 2 * len(known) >= len(values):
            mean, reach = error_bars(known)
            x, means, reaches = [*x, g], [*means, mean], [*reaches, reach]
    ax.errorbar(x, means, np.transpose(reaches), fmt=style, color=colour, capsize=4, label=label)
    ax.set_xticks(range(len(GROUP_LABELS)), GROUP_LABELS)
    ax.set_xlim(-0.4, max(x) + 0.4)
    ax.set_xlabel("how often the agent had been in the state before")
    ax.grid(alpha=0.3)
    return f"{label}: " + ", ".join(f"{GROUP_LABELS[g]} {mean:.3g}" for g, mean in zip(x, means, strict=True))
