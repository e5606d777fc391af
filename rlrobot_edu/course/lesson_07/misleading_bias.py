"""When the bias misleads: an agent forgets one state, similar states advise it badly, and it learns anew."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.bias_explorer.bias_marks import marks_of, state_words
from rlrobot_edu.course.bias_explorer.bias_numbers import bias_numbers
from rlrobot_edu.course.bias_explorer.bias_still import draw_means
from rlrobot_edu.course.lesson_07.arrivals import Arrivals, draw_by_visits, mean_by_visits, watch_arrivals
from rlrobot_edu.environments import make_env
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import learn
from rlrobot_edu.learning.softmax import probabilities
from rlrobot_edu.models.planning import value_iteration
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.show.palette import BLUE, GREY
from rlrobot_edu.show.picture import Picture
from rlrobot_edu.task.task import Task

LEARNERS = {"TOSL+SR": (GREY, "s--"), "TOSL+QBIASSR": (BLUE, "o-")}


def plot_misleading_bias(
    task: Task,
    model: SampleModel,
    state: int,
    *,
    before: int = 1000,
    after: int = 1500,
    repetitions: int = 20,
    seed: int = 0,
) -> Picture:
    """How probable the best action of `state` is, as the state is visited again after all about it was forgotten.

    TOSL+QBIASSR learns for `before` steps and Q(state) is set to 0. Two agents go on from this table for `after`
    steps, with and without the bias. Left: what the sets of the state think when it is forgotten. Right: the
    probability of the action that value iteration finds best, by visits. Means of the repetitions, 95 % intervals.
    task, model: the task and the sample model of it; seed: of all repetitions
    """
    marks = marks_of(task)
    actions = [task.actions.label(a) for a in range(task.actions.n)]
    best = int(value_iteration(model).q[state].argmax())
    tables, found = [], {method: [] for method in LEARNERS}
    for seeds in (child.spawn(6) for child in np.random.SeedSequence(seed).spawn(repetitions)):
        teacher = Agent(model, seed=seeds[0])
        learn(teacher, make_env(model, seeds[1]), before, progress=False)
        q = teacher.q.copy()
        q[state] = 0.0
        tables.append(q)
        for i, method in enumerate(LEARNERS):
            agent = Agent(model, method, seed=seeds[2 + 2 * i])
            agent.q[...] = q
            seen = watch_arrivals(agent, make_env(model, seeds[3 + 2 * i]), after)
            found[method].append(_chance_by_visits(agent, seen, state, best))

    figure = Picture(figsize=(9.5, 4.2), layout="constrained")
    left, right = figure.subplots(1, 2)
    thought = bias_numbers(task, np.mean(tables, axis=0), state, teacher.memory.parameters.q_scale, 1.0)
    draw_means(left, thought, marks, actions)
    advice = actions[int(thought.bias.argmax())]
    left.set_title(f"State {state} forgotten: best is {actions[best]},\nits bias is largest for {advice}", fontsize=11)
    words = [draw_by_visits(right, 100 * np.array(found[name]), name, *look) for name, look in LEARNERS.items()]
    right.axhline(100 / len(actions), color="black", linewidth=0.8, linestyle=":", label="a guess")
    right.set(ylabel=f"probability of {actions[best]} (%)", ylim=(0, 105))
    without, biased = (100 * np.nanmean(np.array(runs)[:, 0]) for runs in found.values())
    right.set_title(f"On the first visit: {without:.0f} % without,\n{biased:.0f} % with the bias", fontsize=11)
    right.legend()
    note = f"means of {repetitions} agents that forgot the state after {before} steps, and 95 % intervals"
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
    scale, temperature = agent.memory.parameters.q_scale, agent.memory.parameters.temperature
    chance = [probabilities(row * scale, temperature)[best] for row in x]
    return mean_by_visits(seen.visits[here], np.array(chance, dtype=float))
