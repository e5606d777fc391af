"""Exercises of assignment 3: a return of n steps, traces, TD(λ) in three forms, Watkins's Q(λ)."""

from __future__ import annotations

from typing import Any

import numpy as np

from rlrobot_edu.course.assignment_3 import mistakes, solutions
from rlrobot_edu.course.grading.exercise import Exercise

REWARDS = [1.0, -2.5, 0.5, 3.0, 1.5]
VALUES = [4.0, 2.5, -1.0, 0.5, 6.0, 50.0]  # the last is of where nothing follows, and tempts those who look there

n_step_return = Exercise(
    task="return n rewards from step t on, discounted, and then what the state promises that follows",
    right=solutions.n_step_return,
    returns="G",
    tape=[
        {"rewards": REWARDS, "values": VALUES, "t": t, "n": n, "gamma": gamma}
        for t, n, gamma in ((0, 1, 0.5), (0, 3, 0.9), (1, 2, 0.8), (2, 3, 0.9), (3, 4, 0.7), (4, 1, 0.6), (1, 3, 0.95),
                            (3, 1, 0.4))
    ],
    mistakes=mistakes.N_STEP,
    hints=(
        "Two parts: the rewards of at most n steps, and a value, where the episode goes on after them.",
        "The rewards are those of the steps t to min(t + n, len(rewards)) − 1; the one of step k counts gamma ** (k - "
        "t) times.",
        "Below the sum: if t + n < len(rewards): g += gamma**n * values[t + n].",
    ),
    gained="From n = 1, which is TD, to the whole episode, which is the return itself: one function.",
)  # fmt: skip


def on_paths(kinds: tuple[str, ...], **more: Any) -> list[dict[str, Any]]:
    """A case for each path, with the kinds of traces in turn."""
    paths = ([2], [1, 2, 1], [1, 2, 1], [3, 3, 3, 0], [0, 1, 2, 1, 1, 3], [0, 1, 2, 1, 1, 3])
    decays = (0.5, 0.9, 0.9, 0.75, 0.6, 0.6)
    return [
        {"path": path, "n_states": 4, "decay": decay, "kind": kinds[i % len(kinds)], **more}
        for i, (path, decay) in enumerate(zip(paths, decays, strict=True))
    ]


KINDS = ("accumulating", "replacing")

trace_after = Exercise(
    task="return the traces of all states after the last visit of the path",
    right=solutions.trace_after,
    returns="e",
    tape=on_paths(KINDS),
    mistakes=mistakes.TRACE,
    hints=(
        "Walk along the path once more: in each step all traces fade, and then the visited state's grows or is set.",
        "e = np.zeros(n_states); for s in path: first e *= decay, then the visit.",
        'The visit: e[s] = e[s] + 1 if kind == "accumulating" else …',
    ),
    gained="A trace is a memory that fades. All that differs between the kinds is what a second visit does to it.",
)

EPISODES = (
    ([1, 2, 3], [1.5, -0.5]),
    ([2, 1, 2, 0], [0.5, 2.5, 1.25]),
    ([2, 1, 2, 0], [0.5, 2.5, 1.25]),
    ([1, 1, 2, 1, 3], [-1.5, 0.25, 0.75, 4.5]),
    ([1, 1, 2, 1, 3], [-1.5, 0.25, 0.75, 4.5]),
    ([2, 0], [2.5]),
)
ALPHAS, GAMMAS, LAMBDAS = (
    (0.5, 0.25, 0.4, 0.1, 0.3, 0.2),
    (0.9, 0.8, 0.95, 0.9, 0.7, 0.9),
    (0.8, 0.5, 0.9, 0.7, 0.6, 0.3),
)
V_START = np.array([7.0, 1.5, -0.5, 9.0])  # of 0 and 3, where the episodes end, the values tempt, too


def on_episodes(**more: tuple[Any, ...]) -> list[dict[str, Any]]:
    """A step of a tape for each episode."""
    columns = {"alpha": ALPHAS, "gamma": GAMMAS, "lam": LAMBDAS, **more}
    return [
        {"path": path, "rewards": rewards} | {name: column[i] for name, column in columns.items()}
        for i, (path, rewards) in enumerate(EPISODES)
    ]


td_episode = Exercise(
    task="learn the values of the states from one recorded episode, by TD(λ) with traces of the given kind",
    right=solutions.td_episode,
    memory={"v": V_START},
    tape=on_episodes(kind=KINDS * 3),
    mistakes=mistakes.EPISODE,
    hints=(
        "For each step of the episode: δ, the traces as in your trace_after, and then all values change at once.",
        "s, s_next = path[t], path[t + 1]; the value of s_next counts 0 in the last step; the traces fade by gamma * "
        "lam, and s is visited.",
        "Last in the loop: v += alpha * delta * e. It changes the array in place.",
    ),
    gained="One δ, and the whole way that led there learns from it.",
)

true_online_episode = Exercise(
    task="learn the values of the states from one recorded episode, by true online TD(λ)",
    right=solutions.true_online_episode,
    memory={"v": V_START},
    tape=on_episodes(),
    mistakes=mistakes.TRUE_ONLINE,
    hints=(
        "The loop is that of td_episode. Three things are new: the dutch trace, the two corrections, and V_old, which "
        "lasts from step to step.",
        "Keep V and V' in variables before v changes. The dutch trace: e[s] = (1 - alpha) * e[s] + 1, after all have "
        "faded.",
        "v += alpha * (delta + v_s - v_old) * e, then v[s] -= alpha * (v_s - v_old), then v_old = v_next.",
    ),
    gained="It does, step by step, exactly what an agent would do that could compute all λ-returns anew in each step.",
)

Q = np.array([[0.5, 2.0, 2.0], [4.0, -1.0, 5.5], [0.75, 0.75, 0.75], [5.0, 6.0, 7.0]])
STEPS = (
    (0, 1, 10.0, 2, 1, False),  # a tie in s', and a' is not the first of the best
    (2, 1, -0.5, 1, 2, False),
    (1, 2, 1.5, 0, 0, False),  # a' explores: cut
    (0, 0, -2.0, 1, 2, False),
    (1, 2, -30.5, 1, 2, False),  # a' was best, and this very step makes it worse
    (1, 2, 0.25, 2, 0, False),
    (2, 0, 2.5, 3, 0, True),
    (0, 2, 1.25, 1, 0, False),
    (1, 0, 0.5, 2, 2, False),
    (2, 2, -1.25, 3, 2, True),
    (1, 1, 4.5, 0, 1, False),
)
COLUMNS = ("s", "a", "r", "s_next", "a_next", "terminated")

watkins_update = Exercise(
    task="Q-learning's update with replacing traces, which are cut where a' is not a best action",
    right=solutions.watkins_update,
    memory={"q": Q, "e": np.zeros_like(Q)},
    tape=[
        dict(zip(COLUMNS, step, strict=True)) | {"alpha": alpha, "gamma": gamma, "lam": lam}
        for step, alpha, gamma, lam in zip(
            STEPS,
            (0.1, 0.5, 0.25, 0.1, 0.4, 0.3, 0.7, 0.05, 0.2, 0.4, 0.3),
            (0.9, 0.5, 0.8, 0.9, 0.9, 0.95, 0.9, 0.6, 0.9, 0.7, 0.8),
            (0.9, 0.8, 0.7, 0.6, 0.9, 0.8, 0.9, 0.5, 0.9, 0.8, 0.7),
            strict=True,
        )
    ],
    mistakes=mistakes.WATKINS,
    hints=(
        "The update is SARSA(λ)'s with Q-learning's δ. Then one question decides what becomes of the traces.",
        "Before q changes: is q[s_next, a_next] equal to the largest of q[s_next]? If so the traces fade, if not, or "
        "at an end, they are 0.",
        "e[s, a] = 1, then q += alpha * delta * e, then e *= gamma * lam if … else 0.",
    ),
    gained="Off-policy with traces: it learns about the best policy, and credits what that policy would have done.",
)
