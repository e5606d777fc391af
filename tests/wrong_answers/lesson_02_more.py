"""Further wrong answers of lesson 02: errors far from their cause, and mistakes that once had no hint."""

# what is wrong stays as learners write it
# ruff: noqa: B007, F821, F841, RUF059

from rlrobot_edu.course.lesson_02.solutions import target


def target_best_starts_at_1(q, r, s_next, terminated, gamma):
    best = -1
    for value in q[s_next]:
        if value > best:
            best = value
    return r if terminated else r + gamma * best


def target_best_starts_at_10(q, r, s_next, terminated, gamma):
    best = -10
    for value in q[s_next]:
        if value > best:
            best = value
    return r if terminated else r + gamma * best


def target_row_of_s(q, r, s_next, terminated, gamma):
    return r if terminated else r + gamma * max(q[s])


def target_a_next(q, r, s_next, terminated, gamma):
    return r if terminated else r + gamma * max(q[s_next, a_next])


def target_max_of_two_arguments(q, r, s_next, terminated, gamma):
    return r if terminated else r + gamma * max(q, s_next)


def update_target_called_with_too_many(q, s, a, r, s_next, terminated, alpha, gamma):
    delta = target(q, s, a, r, s_next, terminated, gamma) - q[s, a]
    q[s, a] += alpha * delta


def update_best_action_learns(q, s, a, r, s_next, terminated, alpha, gamma):
    a = q[s].argmax()
    q[s, a] += alpha * (target(q, r, s_next, terminated, gamma) - q[s, a])


def update_both_ends(q, s, a, r, s_next, terminated, alpha, gamma):
    delta = target(q, r, s_next, terminated, gamma) - q[s, a]
    q[s, a] += alpha * delta
    q[s_next, a] += alpha * delta


def update_twice(q, s, a, r, s_next, terminated, alpha, gamma):
    delta = target(q, r, s_next, terminated, gamma) - q[s, a]
    q[s, a] = q[s, a] + alpha * delta
    q[s, a] += alpha * delta


def update_loop_over_actions(q, s, a, r, s_next, terminated, alpha, gamma):
    for a in range(q.shape[1]):
        q[s, a] += alpha * (target(q, r, s_next, terminated, gamma) - q[s, a])


def update_own_constants(q, s, a, r, s_next, terminated, alpha, gamma):
    alpha, gamma = 0.1, 0.9
    q[s, a] += alpha * (target(q, r, s_next, terminated, gamma) - q[s, a])


def update_writes_q_a(q, s, a, r, s_next, terminated, alpha, gamma):
    q[a] += alpha * (target(q, r, s_next, terminated, gamma) - q[a])


def update_divides(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] += (target(q, r, s_next, terminated, gamma) - q[s, a]) / alpha


def update_delta_squared(q, s, a, r, s_next, terminated, alpha, gamma):
    delta = target(q, r, s_next, terminated, gamma) - q[s, a]
    q[s, a] += alpha * delta**2


def learn_chooses_twice(env, q, choose, update, steps):
    s = env.reset()
    for _ in range(steps):
        s_next, r, terminated, truncated = env.step(choose(q, s))
        update(q, s, choose(q, s), r, s_next, terminated)
        s = s_next
        if terminated or truncated:
            s = env.reset()


def learn_takes_update_s_result_as(env, q, choose, update, steps):
    s = env.reset()
    for step in range(steps):
        a = choose(q, s)
        s_next, r, terminated, truncated = env.step(a)
        q = update(q, s, a, r, s_next, terminated)
        s = env.reset() if terminated or truncated else s_next


def learn_reset_without_brackets(env, q, choose, update, steps):
    s = env.reset
    for step in range(steps):
        a = choose(q, s)
        s_next, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s_next, terminated)
        s = env.reset() if terminated or truncated else s_next


def learn_reward_and_state_exchanged(env, q, choose, update, steps):
    s = env.reset()
    for step in range(steps):
        a = choose(q, s)
        r, s_next, terminated, truncated = env.step(a)
        update(q, s, a, r, s_next, terminated)
        s = env.reset() if terminated or truncated else s_next


def learn_while_not_terminated(env, q, choose, update, steps):
    s = env.reset()
    terminated = truncated = False
    while not (terminated or truncated):
        a = choose(q, s)
        s_next, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s_next, terminated)
        s = s_next


def learn_choose_of_s_next(env, q, choose, update, steps):
    s = env.reset()
    s_next = s
    for _ in range(steps):
        a = choose(q, s_next)
        s_next, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s_next, terminated)
        if terminated or truncated:
            s_next = env.reset()


def learn_step_before_choose_s_next(env, q, choose, update, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s_next, r, terminated, truncated = env.step(s, a)
        update(q, s, a, r, s_next, terminated)
        s = env.reset() if terminated or truncated else s_next


def learn_choose_once_per_episode(env, q, choose, update, steps):
    s = env.reset()
    a = choose(q, s)
    for _ in range(steps):
        s_next, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s_next, terminated)
        s = s_next
        if terminated or truncated:
            s = env.reset()
            a = choose(q, s)


def learn_terminated_swapped_with_r(env, q, choose, update, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s_next, terminated, r, truncated = env.step(a)
        update(q, s, a, r, s_next, terminated)
        s = env.reset() if terminated or truncated else s_next


def learn_indentation_reset_after_loop(env, q, choose, update, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s_next, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s_next, terminated)
        s = s_next
    if terminated or truncated:
        s = env.reset()


def learn_env_reset_as_function_of(env, q, choose, update, steps):
    s = reset()
    for _ in range(steps):
        a = choose(q, s)


def learn_step_without_brackets(env, q, choose, update, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s_next, r, terminated, truncated = env.step
        update(q, s, a, r, s_next, terminated)


WRONG = {
    "by_hand": [
        (4 + 0.2 * 10 + 0.9 * 6 - 4, "brackets: α multiplies the"),
        (4 + 0.2 * (10 + 0.9 * (6 - 4)), "brackets: γ multiplies the 6"),
        (4 + 0.2 * (10 - 0.9 * 6 - 4), "what the next state"),
        (4 + 0.9 * (10 + 0.9 * 6 - 4), "this goes 0.9 of the"),
        (4 + 0.2 * (10 + 0.9 * 4 - 4), "what follows is worth"),
        (4.2 * 11.4, "this multiplies 4 + α"),
    ],
    "target": [
        (target_best_starts_at_1, "the search for the"),
        (target_best_starts_at_10, "the search for the"),
        (target_row_of_s, "s is not handed"),
        (target_a_next, "a_next is not known"),
        (target_max_of_two_arguments, "max compares one number"),
    ],
    "update": [
        (update_target_called_with_too_many, "target takes (q, r"),
        (update_best_action_learns, "the action that was"),
        (update_both_ends, "only (s, a) learns"),
        (update_twice, "the update is made"),
        (update_loop_over_actions, "there is no loop"),
        (update_own_constants, "α and γ are"),
        (update_writes_q_a, "more of q changes"),
        (update_divides, "δ is multiplied by"),
        (update_delta_squared, "δ counts as it"),
    ],
    "learn": [
        (learn_chooses_twice, "choose is asked twice"),
        (learn_takes_update_s_result_as, "choose is given None"),
        (learn_reset_without_brackets, "choose is given a"),
        (learn_reward_and_state_exchanged, "the error came up"),
        (learn_while_not_terminated, "the loop ends with"),
        (learn_choose_of_s_next, "the action is chosen"),
        (learn_step_before_choose_s_next, "step takes (a): hand"),
        (learn_choose_once_per_episode, "the action is chosen"),
        (learn_terminated_swapped_with_r, "env.step gives, in this"),
        (learn_indentation_reset_after_loop, "the reset stands behind"),
        (learn_env_reset_as_function_of, "reset belongs to env"),
        (learn_step_without_brackets, "to the right stands"),
    ],
    "look_ahead": [
        (0.94, "nearly: 0.94 to the power"),
        (10 * 0.5**0.1, "the root alone is"),
        (0.5 / 10**0.5, "this is 0.5 divided by"),
    ],
}
