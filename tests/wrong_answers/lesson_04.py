"""Typical wrong answers of lesson 04, written as learners write them, and a word of the hint each must get."""

import numpy as np


def update_max(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    target = r if terminated else r + gamma * max(q[s_next])
    q[s, a] = (1 - alpha) * q[s, a] + alpha * target


def update_past_the_end(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    delta = r + gamma * q[s_next][a_next] - q[s][a]
    q[s][a] += alpha * delta


def update_old_action(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    target = r if terminated else r + gamma * q[s_next, a]
    q[s, a] += alpha * (target - q[s, a])


def update_wrong_row(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    q_next = q[s, a_next] * (not terminated)
    q[s, a] += alpha * (r + gamma * q_next - q[s, a])


def update_no_gamma(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    q_next = 0 if terminated else q[s_next, a_next]
    q[s, a] += alpha * (r + q_next - q[s, a])


def update_assigns(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    q_next = 0 if terminated else q[s_next, a_next]
    q[s, a] = alpha * (r + gamma * q_next - q[s, a])


def update_not_at_the_end(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    if terminated:
        return
    q[s, a] += alpha * (r + gamma * q[s_next, a_next] - q[s, a])


def learn_as_in_lesson_02(env, q, choose, update, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s2, r, done, late = env.step(a)
        a2 = choose(q, s2)
        update(q, s, a, r, s2, a2, done)
        s = s2
        if done or late:
            s = env.reset()


def learn_resets_before_it_learns(env, q, choose, update, steps):
    s = env.reset()
    a = choose(q, s)
    for _ in range(steps):
        s2, r, done, late = env.step(a)
        if done or late:
            s2 = env.reset()
        a2 = choose(q, s2)
        update(q, s, a, r, s2, a2, done)
        s, a = s2, a2


def learn_never_takes_it(env, q, choose, update, steps):
    s = env.reset()
    a = choose(q, s)
    for _ in range(steps):
        s2, r, done, late = env.step(a)
        a2 = choose(q, s2)
        update(q, s, a, r, s2, a2, done)
        if done or late:
            s, a = (start := env.reset()), choose(q, start)
        else:
            s = s2


def learn_from_old_state(env, q, choose, update, steps):
    s, done, late = None, True, False
    for _ in range(steps):
        if done or late:
            s = env.reset()
            a = choose(q, s)
        s2, r, done, late = env.step(a)
        a2 = choose(q, s)
        update(q, s, a, r, s2, a2, done)
        s, a = s2, a2


def learn_keeps_action(env, q, choose, update, steps):
    s = env.reset()
    a = choose(q, s)
    for _ in range(steps):
        s2, r, done, late = env.step(a)
        a2 = choose(q, s2)
        update(q, s, a, r, s2, a2, done)
        if done or late:
            s2 = env.reset()
        s = s2
        a = a2


def learn_wrong_argument(env, q, choose, update, steps):
    s, done, late = None, True, False
    for _ in range(steps):
        if done or late:
            s = env.reset()
            a = choose(q, s)
        s2, r, done, late = env.step(a)
        a2 = None if done else choose(q, s2)
        update(q, s, a, r, s2, a, done)
        s, a = s2, a2


def learn_greedy_target(env, q, choose, update, steps):
    s = env.reset()
    a = choose(q, s)
    for _ in range(steps):
        s2, r, done, late = env.step(a)
        update(q, s, a, r, s2, np.argmax(q[s2]), done)
        s, a = s2, choose(q, s2)
        if done or late:
            s = env.reset()
            a = choose(q, s)


def learn_no_truncated(env, q, choose, update, steps):
    s = env.reset()
    a = choose(q, s)
    for _ in range(steps):
        s2, r, done, late = env.step(a)
        over = done or late
        a2 = None if over else choose(q, s2)
        update(q, s, a, r, s2, a2, over)
        s, a = s2, a2
        if over:
            s = env.reset()
            a = choose(q, s)


def update_returns(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    target = r if terminated else r + gamma * q[s_next, a_next]
    return q[s, a] + alpha * (target - q[s, a])


def update_loses_old_value_at_the_end(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    if terminated:
        q[s, a] += alpha * r
    else:
        q[s, a] += alpha * (r + gamma * q[s_next, a_next] - q[s, a])


def update_skips_no_reward(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    if r:
        target = r if terminated else r + gamma * q[s_next, a_next]
        q[s, a] += alpha * (target - q[s, a])


def update_changed_places(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    target = r if terminated else r + gamma * q[a_next, s_next]
    q[a, s] += alpha * (target - q[a, s])


def learn_one_episode(env, q, choose, update, steps):
    s = env.reset()
    a = choose(q, s)
    for _ in range(steps):
        s2, r, done, late = env.step(a)
        a2 = choose(q, s2)
        update(q, s, a, r, s2, a2, done)
        if done or late:
            return
        s, a = s2, a2


def learn_no_choice_when_truncated(env, q, choose, update, steps):
    s = env.reset()
    a = choose(q, s)
    for _ in range(steps):
        s2, r, done, late = env.step(a)
        a2 = 0 if done or late else choose(q, s2)
        update(q, s, a, r, s2, a2, done)
        if done or late:
            s2 = env.reset()
            a2 = choose(q, s2)
        s, a = s2, a2


def learn_overwrites_the_reset(env, q, choose, update, steps):
    s = env.reset()
    a = choose(q, s)
    for _ in range(steps):
        s2, r, done, late = env.step(a)
        a2 = choose(q, s2)
        update(q, s, a, r, s2, a2, done)
        if done or late:
            s = env.reset()
            a = choose(q, s)
        s, a = s2, a2


WRONG = {
    "by_hand": [
        (-5.375, "Q-learning"),
        (-22, "target itself"),
        (-15, "forgot γ"),
        (-11.5, "target minus the old"),
        (-16, "TD error δ"),
        (-4, "step α · δ"),
        (-9.75, "counts in full"),
        (-9.5, "reward is missing"),
        (10, "sign"),
    ],
    "sarsa_update": [
        (update_max, "good or bad"),
        (update_past_the_end, "past the end"),
        (update_old_action, "old action"),
        (update_wrong_row, "not q[s, a_next]"),
        (update_no_gamma, "forgot γ"),
        (update_assigns, "+= instead of ="),
        (update_not_at_the_end, "teaches, too"),
        (update_returns, "nothing has changed"),
        (update_loses_old_value_at_the_end, "old value"),
        (update_skips_no_reward, "r is 0"),
        (update_changed_places, "state comes first"),
    ],
    "sarsa_learn": [
        (learn_as_in_lesson_02, "choose twice"),
        (learn_never_takes_it, "old action is taken"),
        (learn_from_old_state, "chosen from s"),
        (learn_keeps_action, "new first action"),
        (learn_wrong_argument, "hand a_next over"),
        (learn_greedy_target, "as Q-learning does"),
        (learn_no_truncated, "time is up"),
        (learn_resets_before_it_learns, "Update first"),
        (learn_one_episode, "end of the first one"),
        (learn_no_choice_when_truncated, "true a'"),
        (learn_overwrites_the_reset, "overwritten"),
    ],
    "fall": [
        (0.975**11, "not falling at all"),
        (0.275, "do not add up"),
        (1 - (1 - 0.1) ** 11, "one of the four"),
        (0.1 / 4, "eleven such steps"),
        (24.3, "divide the per cent"),
        (1 - (1 - 0.1 / 3) ** 11, "1/4, not 1/3"),
    ],
}
