"""The mistakes that both learners of lesson 09 share."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.shared_hints import OWN_GAMMA, OWN_R_MAX

UPDATE = "q_old = true_online_update(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam)"

CHOOSE = "choose(q, shape, s, temperature, r_max, gamma, rng.random())"

IN_THE_IF = " " * 12  # before its lines; those before the loop stand further to the left

ON = "s, a = s_next, a_next"

EMPTIED = "e[:], q_old = 0.0, 0.0"

COMMON = {
    "no_bias": Mistake(
        "the actions are chosen without the bias.",
        {CHOOSE: "draw(softmax(q[s] * 100 * (1 - gamma) / r_max, temperature), rng.random())"},
    ),
    "chooses_twice": Mistake(
        "the action a' that you learned from must be the one that is taken next. Here another one is drawn "
        "for the step, so two numbers are drawn where there should be one.",
        {ON: "s, a = s_next, act(s_next)"},
    ),
    "q_learning": Mistake(
        "a' must be chosen before the update, which learns from it; here it learns from the best action.",
        {"a_next = act(s_next)": "a_next = q[s_next].argmax()", ON: "s, a = s_next, act(s_next)"},
    ),
    "keeps_traces_and_q_old": Mistake(
        "as a new episode starts, the traces and Q_old start afresh: e is 0 and Q_old is 0.", {EMPTIED: "pass"}
    ),
    "keeps_q_old": Mistake("as a new episode starts, the traces start afresh: e is 0.", {EMPTIED: "q_old = 0.0"}),
    "keeps_a_after_reset": Mistake(
        "after a reset the robot stands elsewhere: the action that it still holds was meant for another "
        "state. Choose a new one.",
        {f"{IN_THE_IF}a = act(s)": f"{IN_THE_IF}pass"},
    ),
    "never_resets_the_world": Mistake(
        "the world itself must be reset when an episode has ended: s = env.reset().",
        {f"{IN_THE_IF}s = env.reset()": f"{IN_THE_IF}pass"},
    ),
    "throws_the_reset_away": Mistake(
        "env.reset() tells the first state of the new episode: s = env.reset().",
        {f"{IN_THE_IF}s = env.reset()": f"{IN_THE_IF}env.reset()"},
    ),
    "q_old_stays_0": Mistake(
        "Q_old stays at 0 here. Your true_online_update returns the new one: keep it until the episode has ended.",
        {"q_old = true_online_update": "true_online_update"},
    ),
    "never_resets": Mistake(
        "where an episode has ended, reset the world, and choose an action for its first state.",
        {"if terminated or truncated": "if False"},
    ),
    "resets_only_terminated": Mistake(
        "an episode ends in two ways: terminated, or truncated. In both a new one starts.",
        {"if terminated or truncated": "if terminated"},
    ),
    "resets_only_truncated": Mistake(
        "an episode ends in two ways: truncated, or terminated. In both a new one starts.",
        {"if terminated or truncated": "if truncated"},
    ),
    "truncated_as_terminated": Mistake(
        "a truncated episode has only run out of time: the value of s' still counts. The update gets terminated alone.",
        {"a_next, terminated, alpha": "a_next, terminated or truncated, alpha"},
    ),
    "never_terminated": Mistake(
        "where an episode has terminated nothing comes after it: the update must be told, with terminated.",
        {"a_next, terminated, alpha": "a_next, False, alpha"},
    ),
    "truncated_for_terminated": Mistake(
        "the update is told terminated, not truncated: where an episode has only run out of time, the value of s' "
        "still counts.",
        {"a_next, terminated, alpha": "a_next, truncated, alpha"},
    ),
    "no_traces": Mistake(
        "no traces are at work: this is SARSA. Is true_online_update called, and are the traces emptied only where "
        "an episode has ended?",
        {UPDATE: "q[s, a] += alpha * (r + gamma * (not terminated) * q[s_next, a_next] - q[s, a])"},
    ),
    "q_learning_without_traces": Mistake(
        "this is Q-learning, without traces. Learn with your true_online_update, from the a' that is taken.",
        {UPDATE: "q[s, a] += alpha * (r + gamma * (not terminated) * q[s_next].max() - q[s, a])"},
    ),
    "never_updates": Mistake("nothing is learned: true_online_update is missing.", {UPDATE: "pass"}),
    "chooses_from_s": Mistake(
        "a' is chosen in s', the state that the step led to, not in s.", {"act(s_next)": "act(s)"}
    ),
    "stays": Mistake("at the end of a step, s' becomes s.", {ON: "a = a_next"}),
    "keeps_a": Mistake("at the end of a step, a' becomes a.", {ON: "s = s_next"}),
    "keeps_both": Mistake("at the end of a step, s' becomes s and a' becomes a.", {ON: "pass"}),
    "moves_before_update": Mistake(
        "s and a were overwritten before the update, which still needs the old ones.",
        {UPDATE: f"{ON}; {UPDATE}"},
    ),
    "s_for_s_next": Mistake(
        "the update learns from s', s_next, not from s.", {"s_next, a_next, terminated": "s, a_next, terminated"}
    ),
    "a_for_a_next": Mistake(
        "the update learns from a', a_next, not from a.", {"s_next, a_next, terminated": "s_next, a, terminated"}
    ),
    "alpha_and_gamma_swapped": Mistake(
        "alpha and gamma have changed places in the call of true_online_update.",
        {"alpha, gamma, lam)": "gamma, alpha, lam)"},
    ),
    "alpha_and_lambda_swapped": Mistake(
        "alpha and lam have changed places in the call of true_online_update.",
        {"alpha, gamma, lam)": "lam, gamma, alpha)"},
    ),
    "one_number_for_all": Mistake(
        "one random number serves all choices here. Every choice draws its own: rng.random().",
        {
            "e, q_old = np.zeros_like(q), 0.0": "e, q_old, u = np.zeros_like(q), 0.0, rng.random()",
            "rng.random())": "u)",
        },
    ),
    "reset_overwritten": Mistake(
        "after a reset s and a are those of the new episode, and here s' and a' of the old one are put in their place. "
        "Let s, a = s_next, a_next stand before the if.",
        {f"{IN_THE_IF}a = act(s)": f"{IN_THE_IF}a = act(s)\n        {ON}"},
    ),
    "gamma_and_lambda_swapped": Mistake(
        "gamma and lam have changed places in the call of true_online_update.",
        {"alpha, gamma, lam)": "alpha, lam, gamma)"},
    ),
    "r_max_and_gamma_swapped": Mistake(
        "r_max and gamma have changed places in the call of choose.", {"r_max, gamma, rng": "gamma, r_max, rng"}
    ),
    "own_gamma": Mistake(OWN_GAMMA, {"gamma, lam)": "0.9, lam)"}),
    "inverted": Mistake(
        "a new episode starts only where one has ended. Is the if turned round, or always true?",
        {"if terminated or truncated": "if not (terminated or truncated)"},
    ),
    "one_step_too_few": Mistake("there is one step too few.", {"range(steps)": "range(steps - 1)"}),
    "one_step_too_many": Mistake("there is one step too many.", {"range(steps)": "range(steps + 1)"}),
    "one_episode": Mistake(
        "the loop ends with the first episode. It should go on until all steps are done.", {EMPTIED: "break"}
    ),
    "empties_q": Mistake(
        "what has been learned in an episode must stay: it is e and Q_old that start afresh, not q.",
        {EMPTIED: f"{EMPTIED}; q[:] = 0.0"},
    ),
    "begins_with_ones": Mistake("all Q start at 0.", {"q = np.zeros": "q = np.ones"}),
    "own_first_action": Mistake(
        "the first action is chosen like all others.", {"a = act(s)\n    for": "a = 0\n    for"}
    ),
    "by_chance_alone": Mistake(
        "the actions are chosen by chance alone. Call your choose.", {CHOOSE: "int(rng.random() * n_actions)"}
    ),
    "always_the_best": Mistake(
        "the best action is not always taken. Call your choose.",
        {CHOOSE: "int(preferences(q, shape, s, r_max, gamma).argmax())"},
    ),
    "not_normalised": Mistake(
        "the preferences are not normalised where you choose. Call your choose.",
        {CHOOSE: "draw(softmax(q[s] + bias(q, shape, s), temperature), rng.random())"},
    ),
    "no_choice_at_the_end": Mistake(
        "a' is chosen in every step, also in the last one of an episode that was truncated: the update learns from it.",
        {"a_next = act(s_next)": "a_next = a if terminated or truncated else act(s_next)"},
    ),
    "returns_traces": Mistake("the traces are not what is asked: return q.", {"return q": "return e"}),
    "returns_both": Mistake("return q alone.", {"return q": "return q, e"}),
    "traces_are_q": Mistake(
        "e and q are one table here under two names, so each change of one is a change of the other. Make a table "
        "of its own: np.zeros_like(q).",
        {"np.zeros_like(q)": "q"},
    ),
    "traces_begin_with_ones": Mistake(
        "all traces start at 0, too: nobody has been visited yet.", {"np.zeros_like(q)": "np.ones_like(q)"}
    ),
    "return_in_the_loop": Mistake(
        "it ends with the first step. Does return stand inside the loop?", {ON: f"{ON}; return q"}
    ),
    "resets_every_step": Mistake(
        "the world is reset after every step. A new episode starts only where one has ended.",
        {ON: "s, a = env.reset(), a_next"},
    ),
    "acts_by_another": Mistake(
        "the action that is done must be the one that was learned about, a. Here another is drawn for the world.",
        {"env.step(a)": "env.step(act(s))"},
    ),
    "own_r_max": Mistake(OWN_R_MAX, {"r_max, gamma, rng": "10, gamma, rng"}),
    "own_number_of_actions": Mistake(
        "the number of actions is the argument n_actions, not always 3.", {"n_actions": "3"}
    ),
}
