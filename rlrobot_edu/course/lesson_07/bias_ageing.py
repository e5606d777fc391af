"""How the bias ages: what it is worth in a state, the more often the agent has been there."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.lesson_07.arrivals import draw_by_visits, mean_by_visits, watch_arrivals
from rlrobot_edu.environments import make_env
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.models.planning import value_iteration
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.show.palette import BLUE, GREY, PURPLE
from rlrobot_edu.show.picture import Picture


def quality(q_best: np.ndarray, s: np.ndarray, x: np.ndarray) -> np.ndarray:
    r"""How good it would be to take the action with the largest `x`: 1 the best there is, 0 as good as a guess.

    .. math:: \frac{Q^*(s, \arg\max_a x(a)) - \bar Q^*(s)}{\max_a Q^*(s, a) - \bar Q^*(s)}

    the bar being the mean over the actions; among several largest, any. NaN where every action is equally good.
    q_best: array (n_states, n_actions), Q*; s: array (n,) of states; x: array (n, n_actions). Returns an array (n,).
    """
    row, largest = q_best[s], x == x.max(axis=1, keepdims=True)
    guess = row.mean(axis=1)
    taken = (row * largest).sum(axis=1) / largest.sum(axis=1)
    room = row.max(axis=1) - guess
    return np.divide(taken - guess, room, out=np.full(len(s), np.nan), where=room > 1e-6)


def share_of_bias(q: np.ndarray, bias: np.ndarray) -> np.ndarray:
    """How much of the preference among actions stems from the bias, 0 to 1; NaN where there is no preference yet.

    A preference is as large as the gap between the actions it likes most and least. q, bias: arrays (n, n_actions).
    """
    own, others = np.ptp(q, axis=1), np.ptp(bias, axis=1)
    return np.divide(others, own + others, out=np.full(len(q), np.nan), where=own + others > 1e-9)


def plot_bias_ageing(
    model: SampleModel, method: str = "TOSL+QBIASSR", *, steps: int = 300, repetitions: int = 60, seed: int = 0
) -> Picture:
    """Whenever an agent comes to a state: would its best action by Q + bias be better than its best by Q alone?

    Left: their `quality`, by how often the agent has been in the state before; the judge is value iteration on the
    model. Right: the share of the bias in the preference. Means of the repetitions with 95 % intervals (Student's t).
    The bias never fades: s itself is a member of every set, so that a fixed part of Q(s) is in the bias, too.
    model: the world to learn in; steps, repetitions (at least 2): of each learning process; seed: of all of them
    """
    q_best = value_iteration(model).q
    alone, biased, share = [], [], []
    for agent_seed, env_seed in (child.spawn(2) for child in np.random.SeedSequence(seed).spawn(repetitions)):
        seen = watch_arrivals(Agent(model, method, seed=agent_seed), make_env(model, env_seed), steps)
        alone.append(mean_by_visits(seen.visits, quality(q_best, seen.s, seen.q)))
        biased.append(mean_by_visits(seen.visits, quality(q_best, seen.s, seen.q + seen.bias)))
        share.append(mean_by_visits(seen.visits, 100 * share_of_bias(seen.q, seen.bias)))
    alone, biased, share = np.array(alone), np.array(biased), np.array(share)

    figure = Picture(figsize=(9, 4), layout="constrained")
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
    right.set(ylabel="share of the bias in the preference (%)", ylim=(0, 105))
    right.set_title(f"It does not fade: still {later:.0f} % after 8–15 visits", fontsize=11)
    note = f"{method}: means of {repetitions} agents that learned for {steps} steps, and 95 % intervals"
    figure.supxlabel(note, fontsize=9)
    figure.alt = f"Quality of the best action, and share of the bias, by earlier visits. {'; '.join(words)}. {note}."
    return figure
