"""Further wrong answers of lesson 04: errors far from their cause, and mistakes that once had no hint."""

# what is wrong stays as learners write it
# ruff: noqa: F821, RUF059


def update_chooses_itself(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    a_next = choose(q, s_next)
    target = r if terminated else r + gamma * q[s_next, a_next]
    q[s, a] += alpha * (target - q[s, a])


def update_max_of_one(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    target = r if terminated else r + gamma * max(q[s_next, a_next])
    q[s, a] += alpha * (target - q[s, a])


def update_old_value_of_a_next(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    target = r if terminated else r + gamma * q[s_next, a_next]
    q[s, a] += alpha * (target - q[s_next, a_next])


def update_calls_the_update_of_02(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    update(q, s, a, r, s_next, terminated, alpha, gamma)


def update_if_a_next_0_is(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    target = r
    if a_next and not terminated:
        target += gamma * q[s_next, a_next]
    q[s, a] += alpha * (target - q[s, a])


def update_mean_of_max_and_a(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    target = r if terminated else r + gamma * (q[s_next, a_next] + q[s_next].max()) / 2
    q[s, a] += alpha * (target - q[s, a])


def learn_update_of_q_learning(env, q, choose, update, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s_next, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s_next, terminated)
        s = s_next
        if terminated or truncated:
            s = env.reset()


def learn_choose_arguments_swapped(env, q, choose, update, steps):
    s = env.reset()
    a = choose(s, q)
    for _ in range(steps):
        s_next, r, terminated, truncated = env.step(a)


def learn_a_next_from_choose_before(env, q, choose, update, steps):
    s = env.reset()
    a = choose(q, s)
    for _ in range(steps):
        a_next = choose(q, s)
        s_next, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s_next, a_next, terminated)
        s, a = s_next, a_next
        if terminated or truncated:
            s = env.reset()
            a = choose(q, s)


def learn_update_swapped_terminated_a_next(env, q, choose, update, steps):
    s = env.reset()
    a = choose(q, s)
    for _ in range(steps):
        s_next, r, terminated, truncated = env.step(a)
        a_next = choose(q, s_next)
        update(q, s, a, r, s_next, terminated, a_next)
        s, a = s_next, a_next
        if terminated or truncated:
            s = env.reset()
            a = choose(q, s)


def learn_action_list(env, q, choose, update, steps):
    s = env.reset()
    a = choose(q, s)
    for step in range(steps):
        s_next, r, terminated, truncated = env.step(a)
        a_next[step] = choose(q, s_next)
        update(q, s, a, r, s_next, a_next[step], terminated)


WRONG = {
    "by_hand": [
        (-6 + 0.25 * (-2 + 0.5 * (-40 + 6)), "γ multiplies Q(s', a')"),
        (-6 + 0.5 * (-2 + 0.25 * -40 + 6), "two slips lead here"),
        (-6 + 0.25 * (-2 + 0.5 * (-3 - 5 - 40 - 6) + 6), "this adds up all"),
        (-6 + 0.25 * (-2 + 0.25 * -40 + 6), "γ = 0.5 multiplies Q(s'"),
    ],
    "fall": [
        (0.1**11, "this is the probability"),
        (0.243 * 11, "this is the risk"),
        (13 * 0.025, "probabilities of repeated chances"),
        (1 - 0.025**11, "this is the probability"),
        (1 - 0.1, "this is the probability"),
    ],
    "sarsa_update": [
        (update_chooses_itself, "choose is not needed"),
        (update_max_of_one, "max takes several numbers"),
        (update_old_value_of_a_next, "δ is measured from"),
        (update_calls_the_update_of_02, "update is lesson 02's, and"),
        (update_if_a_next_0_is, "is there an if"),
        (update_mean_of_max_and_a, "this counts the best"),
    ],
    "sarsa_learn": [
        (learn_update_of_q_learning, "update is called with"),
        (learn_choose_arguments_swapped, "choose is called with"),
        (learn_a_next_from_choose_before, "a' is chosen before"),
        (learn_update_swapped_terminated_a_next, "the error came up"),
        (learn_action_list, "a_next has no value"),
    ],
}
