"""Typical wrong answers of lesson 04, written as learners write them, and a word of the hint each must get."""

from rlrobot_edu.course.grading.source import edited


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


def right_loop(env, q, choose, update, steps):
    s = env.reset()
    a = choose(q, s)
    for _ in range(steps):
        s2, r, done, late = env.step(a)
        a2 = choose(q, s2)
        update(q, s, a, r, s2, a2, done)
        if done or late:
            s2 = env.reset()
            a2 = choose(q, s2)
        s, a = s2, a2


# its lines, of which each wrong loop has some in another way
BEGIN = "    a = choose(q, s)\n    for _ in range(steps):\n"
CHOICE = "        a2 = choose(q, s2)\n        update"
ENDED = "        if done or late:\n"
RESET = "            s2 = env.reset()\n"
ANEW = "            a2 = choose(q, s2)\n"
MOVE = "s, a = s2, a2"

LOOPS = [
    ({BEGIN: "    for _ in range(steps):\n        a = choose(q, s)\n", ANEW: "", MOVE: "s = s2"}, "choose twice"),
    ({ANEW: "            a = choose(q, s2)\n", MOVE: "s = s2"}, "old action is taken"),
    ({CHOICE: "        a2 = choose(q, s)\n        update"}, "chosen from s"),
    ({ANEW: ""}, "new first action"),
    ({"s2, a2, done)": "s2, a, done)"}, "hand a_next over"),
    (
        {CHOICE: "        update", "s2, a2, done)": "s2, q[s2].argmax(), done)\n        a2 = choose(q, s2)"},
        "as Q-learning does",
    ),
    (
        {
            CHOICE: "        a2 = None if done or late else choose(q, s2)\n        update",
            "a2, done)": "a2, done or late)",
        },
        "time is up",
    ),
    ({CHOICE: ENDED + RESET + CHOICE, ENDED + RESET + ANEW: ""}, "Update first"),
    ({RESET + ANEW: "            return\n"}, "end of the first one"),
    ({CHOICE: "        a2 = 0 if done or late else choose(q, s2)\n        update"}, "true a'"),
    ({RESET + ANEW: "            s = env.reset()\n            a = choose(q, s)\n"}, "overwritten"),
]

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
    "sarsa_learn": [(edited(right_loop, changes), word) for changes, word in LOOPS],
    "fall": [
        (0.975**11, "not falling at all"),
        (0.275, "do not add up"),
        (1 - (1 - 0.1) ** 11, "one of the four"),
        (0.1 / 4, "eleven such steps"),
        (24.3, "divide the per cent"),
        (1 - (1 - 0.1 / 3) ** 11, "1/4, not 1/3"),
    ],
}
