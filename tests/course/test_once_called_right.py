"""Wrong answers that a whole course of checks once called right: each is a way of its own to be wrong."""

import copy

import numpy as np
import pytest
from test_checks import exercises
from test_tapes_tell import text_of

from rlrobot_course.assignment_2.exercises import double_update
from rlrobot_course.exercises.design import FREE
from rlrobot_course.lesson_10.exercises import (
    choose,
    new_temperature,
    true_online_update,
)


def draw_by_rounded_u(p, u):
    u = round(u, 2)
    return next(a for a, total in enumerate(np.cumsum(p)) if u < total)


def draw_in_hundredths(p, u):
    total = 0
    for a in range(len(p)):
        total += round(100 * p[a])
        if int(100 * u) < total:
            return a
    return len(p) - 1


def draw_in_tenths(p, u):
    for a, total in enumerate(np.cumsum(p)):
        if round(10 * u, 6) < round(10 * total, 1):
            return a
    return len(p) - 1


def draw_from_a_hundred_tickets(p, u):
    tickets = [a for a in range(len(p)) for _ in range(round(100 * p[a]))]
    return tickets[int(len(tickets) * u)]


def evades(pushed, length):
    """A learner that evades loops: what it pushes for a reward, and how long its queues are."""

    def learn_and_evade(
        env, shape, n_actions, r_max, steps, rng, alpha, gamma, lam, default
    ):
        q = np.zeros((np.prod(shape), n_actions))
        e, q_old = np.zeros_like(q), 0.0
        states, rewards, temperature = [], [], default

        def act(s):
            return choose(q, shape, s, temperature, r_max, gamma, rng.random())

        s = env.reset()
        a = act(s)
        for _ in range(steps):
            s_next, r, terminated, truncated = env.step(a)
            states = [*states, s_next][-length(len(q)) :]
            rewards = [*rewards, pushed(r)][-length(len(q)) :]
            if len(states) == length(len(q)):
                temperature = new_temperature(
                    temperature, states, rewards, s_next, default
                )
            a_next = act(s_next)
            q_old = true_online_update(
                q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam
            )
            s, a = s_next, a_next
            if terminated or truncated:
                e[:], q_old = 0.0, 0.0
                states, rewards, temperature = [], [], default
                s = env.reset()
                a = act(s)
        return q

    return learn_and_evade


def as_told(n_states):
    return max(4, min(21, n_states // 4))


def rounded_up(n_states):
    return max(4, min(21, -(-n_states // 4)))


def follows(way, fast=10.0, near=("laser_front", "laser_front_right", "laser_right")):
    """A reward that follows the wall: how it measures its way, what it pays, which lasers it asks for a touch."""

    def follow_reward(before, after):
        dx, dy = after["x"] - before["x"], after["y"] - before["y"]
        if min(after[laser] for laser in near) < 0.05:
            return -2
        beside = 0.10 < after["laser_right"] <= 0.40
        if beside and way(dx, dy) > 0.07:
            return fast
        return 0

    return follow_reward


def pays_by_speed(before, after):
    way = np.hypot(after["x"] - before["x"], after["y"] - before["y"])
    near = min(after["laser_front"], after["laser_front_right"], after["laser_right"])
    if near < 0.05:
        return -1
    beside = 0.10 < after["laser_right"] <= 0.40 and way > 0.07
    return 100 * way * (1 if beside else 0.7)


def value_about_the_mean(q_s, temperature):
    powers = np.exp((q_s - q_s.mean()) / temperature)
    return sum(powers * q_s) / sum(powers)


def learn_by_an_old_sum(env, q1, q2, choose, toss, episodes, alpha, gamma):
    for _ in range(episodes):
        s, over, both = env.reset(), False, q1 + q2
        while not over:
            a = choose(both, s)
            s_next, r, terminated, truncated = env.step(a)
            double_update(q1, q2, s, a, r, s_next, terminated, toss(), alpha, gamma)
            s, over = s_next, terminated or truncated


def watkins_that_clears_the_row(
    q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam
):
    best = 0 if terminated else max(q[s_next])
    greedy = not terminated and q[s_next, a_next] == best
    delta = r + gamma * best - q[s, a]
    e[s] = 0
    e[s, a] = 1
    q += alpha * delta * e
    e *= gamma * lam if greedy else 0


def adds_both(before, after):
    way = np.hypot(after["x"] - before["x"], after["y"] - before["y"])
    near = min(after["laser_front"], after["laser_front_right"], after["laser_right"])
    paid = 0
    if 0.10 < after["laser_right"] <= 0.40 and way > 0.07:
        paid += 10
    if near < 0.05:
        paid -= 2
    return paid


def remembers_what_pays(env, q, seen, choose, update, pick, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s_next, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s_next, terminated)
        if r != 0:
            seen[s, a] = (r, s_next, terminated)
        for pair in pick(seen):
            update(q, *pair, *seen[pair])
        s = s_next
        if terminated or truncated:
            s = env.reset()


ALL_LASERS = tuple(FREE)
WRONG = (
    ("lesson_04", "draw", draw_by_rounded_u),
    ("lesson_04", "draw", draw_in_hundredths),
    ("lesson_04", "draw", draw_in_tenths),
    ("lesson_04", "draw", draw_from_a_hundred_tickets),
    ("lesson_10", "learn_and_evade", evades(np.sign, as_told)),
    ("lesson_10", "learn_and_evade", evades(lambda r: 1 if r > 0 else -1, as_told)),
    ("lesson_10", "learn_and_evade", evades(float, rounded_up)),
    ("lesson_16", "follow_reward", follows(lambda dx, dy: abs(dx) + abs(dy))),
    ("lesson_16", "follow_reward", follows(lambda dx, dy: abs(dx + dy))),
    ("lesson_16", "follow_reward", pays_by_speed),
    ("lesson_16", "follow_reward", follows(np.hypot, near=ALL_LASERS)),
    ("lesson_16", "follow_reward", adds_both),
    ("lesson_17", "dyna", remembers_what_pays),
    ("assignment_2", "policy_value", value_about_the_mean),
    ("assignment_2", "double_learn", learn_by_an_old_sum),
    ("assignment_3", "watkins_update", watkins_that_clears_the_row),
)


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize(
    ("lesson", "name", "answer"),
    WRONG,
    ids=[f"{name}-{i}" for i, (_, name, _) in enumerate(WRONG)],
)
def test_what_was_wrong_and_called_right_is_called_wrong(lesson, name, answer):
    assert exercises(lesson)[name].judge(copy.copy(answer)).status == "wrong"


def half_the_sum(env, q1, q2, choose, toss, episodes, alpha, gamma):
    for _ in range(episodes):
        s, over = env.reset(), False
        while not over:
            a = choose((q1 + q2) / 2, s)
            s_next, r, terminated, truncated = env.step(a)
            double_update(q1, q2, s, a, r, s_next, terminated, toss(), alpha, gamma)
            s, over = s_next, terminated or truncated


# answers that no case can tell from the right one, since they are right, and the words that say so
RIGHT_TOO = (
    ("lesson_10", "learn_and_evade", evades(lambda r: r / 7, as_told), "does as well"),
    ("assignment_2", "double_learn", half_the_sum, "their mean does as well"),
)


@pytest.mark.parametrize(
    ("lesson", "name", "answer", "words"), RIGHT_TOO, ids=[one[1] for one in RIGHT_TOO]
)
def test_what_cannot_be_told_from_the_right_answer_is_right_and_the_page_says_so(
    lesson, name, answer, words
):
    assert exercises(lesson)[name].judge(copy.copy(answer))
    assert words in text_of(lesson)


def fewer(n_states):
    return max(4, min(21, n_states // 5))


def lower_cap(n_states):
    return max(4, min(20, n_states // 4))


def smaller_least(n_states):
    return max(3, min(21, n_states // 4))


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("length", [fewer, lower_cap, smaller_least])
def test_a_queue_of_another_length_is_wrong(length):
    answer = evades(float, length)
    assert exercises("lesson_10")["learn_and_evade"].share(answer) < 1


PUSHED = {
    "its size": abs,
    "at most 1": lambda r: max(-1.0, min(1.0, r)),
    "its square, with its sign": lambda r: r * abs(r),
    "a little more": lambda r: r + 0.1,
    "whether it pays": lambda r: float(r > 0),
    "whole": round,
}


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("pushed", PUSHED)
def test_a_queue_of_something_else_than_rewards_is_wrong(pushed):
    answer = evades(PUSHED[pushed], as_told)
    assert exercises("lesson_10")["learn_and_evade"].share(answer) < 1
