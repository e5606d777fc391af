"""Exercises of lesson 04: SARSA."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise, Mistake, Question
from rlrobot_edu.course.grading.tapes import Q_START, TAPE
from rlrobot_edu.course.lesson_04.sarsa_loop import sarsa_learn

__all__ = ["by_hand", "expected_target", "fall", "sarsa_learn", "sarsa_update"]

PAST_THE_END = "this bootstraps past the end. After a terminal step nothing follows, so the target is the reward alone."
NO_GAMMA = "you forgot γ, which makes later rewards count less."

by_hand = Question(
    task="the new Q(s, a) after SARSA's update, computed by hand",
    right=-9.1,
    because="−6 + 0.1 · (−1 + 0.9 · (−40) + 6) = −9.1: the careless action that follows counts.",
    mistakes=[
        Mistake("this is Q-learning's answer: it took the best value in s'. SARSA takes that of a', −40.", -5.77),
        Mistake("this is the target itself. With α = 0.1, Q goes only a tenth of the way towards it.", -37.0),
        Mistake("you forgot γ: the value of a' in s' counts 0.9 times.", -9.5),
        Mistake("you added α times the target. The TD error is the target minus the old Q(s, a).", -9.7),
        Mistake("this is the TD error δ. The new Q(s, a) is the old one plus α · δ.", -31.0),
        Mistake("this is the step α · δ. Add it to the old Q(s, a).", -3.1),
        Mistake("this counts the mean over the actions of s'. SARSA looks at one action only, at a'.", -6.715),
        Mistake("the reward is missing: the target is r + γ · Q(s', a').", -9.0),
        Mistake("watch the signs: taking off a negative number adds it.", -10.3),
    ],
)


def _sarsa_update(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    q[s, a] += alpha * (r + gamma * (0.0 if terminated else q[s_next, a_next]) - q[s, a])


def _looks_past_the_end(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    q[s, a] += alpha * (r + gamma * q[s_next, a_next] - q[s, a])


def _is_q_learning(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    q[s, a] += alpha * (r + gamma * (0.0 if terminated else q[s_next].max()) - q[s, a])


def _repeats_the_old_action(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    _sarsa_update(q, s, a, r, s_next, a, terminated, alpha, gamma)


def _looks_at_its_own_state(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    _sarsa_update(q, s, a, r, s, a_next, terminated, alpha, gamma)


def _forgets_gamma(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    _sarsa_update(q, s, a, r, s_next, a_next, terminated, alpha, 1.0)


def _forgets_old_value(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    q[s, a] += alpha * (r + gamma * (0.0 if terminated else q[s_next, a_next]))


def _replaces(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    q[s, a] = alpha * (r + gamma * (0.0 if terminated else q[s_next, a_next]) - q[s, a])


def _jumps(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    _sarsa_update(q, s, a, r, s_next, a_next, terminated, 1.0, gamma)


def _skips_the_end(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    if not terminated:
        _sarsa_update(q, s, a, r, s_next, a_next, terminated, alpha, gamma)


def _updates_the_next_pair(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    q[s_next, a_next] += alpha * (r + gamma * (0.0 if terminated else q[s_next, a_next]) - q[s, a])


def _updates_the_next_action(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    q[s, a_next] += alpha * (r + gamma * (0.0 if terminated else q[s_next, a_next]) - q[s, a_next])


sarsa_update = Exercise(
    task="change q[s, a] by α times SARSA's TD error",
    right=_sarsa_update,
    memory={"q": Q_START},
    tape=[row | {"alpha": 0.1, "gamma": 0.9} for row in TAPE],
    mistakes=[
        Mistake(PAST_THE_END, _looks_past_the_end),
        Mistake("a terminated step teaches, too: its target is the reward alone.", _skips_the_end),
        Mistake("this is Q-learning: it takes the best action of s'. SARSA takes a_next, good or bad.", _is_q_learning),
        Mistake("in s' the action a_next will be taken, not the old action a once more.", _repeats_the_old_action),
        Mistake("a_next is taken in the next state: its value is q[s_next, a_next], not q[s, a_next].",
                _looks_at_its_own_state),
        Mistake(NO_GAMMA, _forgets_gamma),
        Mistake("the TD error is the target minus the old q[s, a]; here the old value is not taken off.",
                _forgets_old_value),
        Mistake("q[s, a] should change by α · δ. You replaced it: write += instead of =.", _replaces),
        Mistake("q[s, a] jumps to the target. It should go only the share α of the way.", _jumps),
        Mistake("the pair that learns is (s, a), where the step began, not (s', a').", _updates_the_next_pair),
        Mistake("the action that learns is a, which was done; a_next is still to come.", _updates_the_next_action),
    ],
)  # fmt: skip


def _expected_target(q, p, r, s_next, terminated, gamma):
    return r + gamma * (0.0 if terminated else p @ q[s_next])


# How probable each action is in s'. The most probable one is not always the best, as after a change of Q.
_POLICIES = ((0.8, 0.1, 0.1), (0.05, 0.05, 0.9), (0.2, 0.5, 0.3), (0.0, 1.0, 0.0), (0.6, 0.3, 0.1))

expected_target = Exercise(
    task="return r + γ · the mean of Q(s', ·), each action weighted with its probability",
    right=_expected_target,
    returns="target",
    tape=[
        {"q": Q_START, "p": np.array(p), "gamma": 0.9} | {name: row[name] for name in ("r", "s_next", "terminated")}
        for p, row in zip(_POLICIES, TAPE, strict=False)
    ],
    mistakes=[
        Mistake(PAST_THE_END, lambda q, p, r, s_next, terminated, gamma: r + gamma * (p @ q[s_next])),
        Mistake(NO_GAMMA, lambda q, p, r, s_next, terminated, gamma: r + (0 if terminated else p @ q[s_next])),
        Mistake(
            "this is Q-learning's target: the best action as if it were certain. Weight every action with p.",
            lambda q, p, r, s_next, terminated, gamma: r + gamma * (0 if terminated else q[s_next].max()),
        ),
        Mistake(
            "here all actions count alike. Those that are likelier should count more: weight each with p.",
            lambda q, p, r, s_next, terminated, gamma: r + gamma * (0 if terminated else q[s_next].mean()),
        ),
        Mistake(
            "this takes the likeliest action as if it were certain. The others happen, too: weight each with p.",
            lambda q, p, r, s_next, terminated, gamma: r + gamma * (0 if terminated else q[s_next, p.argmax()]),
        ),
        Mistake(
            "this is one number for each action. Add the weighted values up: the target is a single number.",
            lambda q, p, r, s_next, terminated, gamma: r + gamma * (0 if terminated else p * q[s_next]),
        ),
        Mistake(
            "weighted twice: p already sums to 1, so the weighted values are added up, not averaged.",
            lambda q, p, r, s_next, terminated, gamma: r + gamma * (0 if terminated else (p * q[s_next]).mean()),
        ),
        Mistake(
            "γ discounts what comes later; the reward of this step counts in full.",
            lambda q, p, r, s_next, terminated, gamma: gamma * (r + (0 if terminated else p @ q[s_next])),
        ),
    ],
)

fall = Question(
    task="how probable at least one fall is on the way along the edge",
    right=1 - 0.975**11,
    because="1 − 0.975¹¹ = 0.243: nearly every fourth walk along the edge ends in the cliff.",
    mistakes=[
        Mistake("this is the probability of not falling at all. Falling is the rest, up to 1.", 0.975**11),
        Mistake("probabilities of repeated chances do not add up: 50 steps would give more than 1. "
                "Compute the probability that no step falls, and take the rest.", 11 * 0.025),
        Mistake("with ε = 0.1 one step in ten explores, but only one of the four actions leads over the edge.",
                1 - 0.9**11),
        Mistake("nearly: this is rounded. Write the expression and let Python compute it.", 0.24),
        Mistake("a probability lies between 0 and 1: divide the per cent by 100.", 100 * (1 - 0.975**11)),
        Mistake("this is the risk of one step. There are eleven such steps.", 0.025),
        Mistake("this is the probability of falling at every one of the eleven steps. Once is enough.", 0.025**11),
        Mistake("exploring picks any of four actions, the best one included: down has the share 1/4, not 1/3.",
                1 - (1 - 0.1 / 3) ** 11),
    ],
)  # fmt: skip
