"""Other right answers, written unlike the solutions: a second opinion on them, and every check must take them, too."""

import cmath
import math

import numpy as np
from right_answers_of_assignments import ASSIGNMENTS

from rlrobot_edu.learning.selections.greedy import add_share
from rlrobot_edu.widgets.kernels import bias_of, probabilities


def reward(before, after):
    if after["laser_front_left"] < 0.10 or after["laser_front_right"] < 0.10:
        return -2.0
    way = math.dist((before["x"], before["y"]), (after["x"], after["y"]))
    return 10.0 if way > 0.07 else 0.0


def discounted_return(rewards, gamma):
    g = 0
    for r in reversed(rewards):
        g = r + gamma * g
    return g


def update(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] = (1 - alpha) * q[s, a] + alpha * (
        r + gamma * np.max(q[s_next]) * (not terminated)
    )


def learn(env, q, choose, update, steps):
    s = env.reset()
    while steps:
        a = choose(q, s)
        s_next, r, *ends = env.step(a)
        update(q, s, a, r, s_next, ends[0])
        s = env.reset() if any(ends) else s_next
        steps -= 1


def epsilon_greedy(q_s, epsilon):
    p = np.full(len(q_s), epsilon / len(q_s))
    add_share(p, q_s, q_s.max(), 1.0 - epsilon)
    return p


def sarsa_update(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    follows = 0.0 if terminated else q[s_next, a_next]
    q[s, a] = (1 - alpha) * q[s, a] + alpha * r + alpha * gamma * follows


def sarsa_learn(env, q, choose, update, steps):
    s = env.reset()
    a = choose(q, s)
    for _ in range(steps):
        s_next, r, terminated, truncated = env.step(a)
        a_next = (
            None if terminated else choose(q, s_next)
        )  # past the end nothing is chosen
        update(q, s, a, r, s_next, a_next, terminated)
        if terminated or truncated:
            s_next = env.reset()
            a_next = choose(q, s_next)
        s, a = s_next, a_next


def sarsa_lambda_update(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = r - q[s, a] if terminated else r + gamma * q[s_next, a_next] - q[s, a]
    e[s, a] = 1
    for pair in np.ndindex(*q.shape):
        q[pair] += alpha * delta * e[pair]
        e[pair] *= gamma * lam


def true_online_update(
    q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam
):
    """As in Sutton & Barto, section 12.5: the two corrections taken together, δ spelled out."""
    q_sa, q_next = q[s, a], 0.0 if terminated else q[s_next, a_next]
    e[s, a] -= alpha * e[s, a] - 1
    q[:] = q + alpha * (r + gamma * q_next - q_old) * e
    q[s, a] += alpha * (q_old - q_sa)
    e[:] = e * gamma * lam
    return q_next


def siblings(shape, s, i):
    stride = math.prod(shape[i + 1 :])
    first = s - s // stride % shape[i] * stride
    return [first + k * stride for k in range(shape[i])]


def new_temperature(temperature, states, rewards, s, default):
    redundancy = len(states) / len(np.unique(states))
    in_a_loop = s in states[:-1] and np.mean(rewards) < 0 and redundancy > 2
    return min(50.0, temperature + redundancy / 4) if in_a_loop else default


def gripper(arm, biceps, forearm):
    """By complex numbers: the arm's plane first, then the table's."""
    tip = (
        0.12j
        + 0.23j * cmath.exp(-1j * biceps)
        + 0.25 * cmath.exp(-1j * (biceps + forearm))
    )
    on_table = tip.real * cmath.exp(1j * arm)
    return np.array([on_table.real, on_table.imag, tip.imag])


def arm_reward(before, after):
    """Another potential, which is steep near the object."""
    return 10 if after <= 0.05 else 0.2 / after - 0.2 / before


def follow_reward(before, after):
    """The nearer to the middle of the band the better, and only while it drives."""
    if (
        min(
            after[laser]
            for laser in ("laser_right", "laser_front_right", "laser_front")
        )
        < 0.05
    ):
        return -10
    drives = math.dist((before["x"], before["y"]), (after["x"], after["y"])) > 0.07
    return max(0.0, 0.2 - abs(after["laser_right"] - 0.25)) if drives else -0.5


def preferences(q, shape, s, r_max, gamma):
    return (q[s] + bias_of(q, shape, s)) * 100 * (1 - gamma) / r_max


def choose(q, shape, s, temperature, r_max, gamma, u):
    p = probabilities(preferences(q, shape, s, r_max, gamma), temperature)
    return int(np.searchsorted(np.cumsum(p), u, side="right"))


def learn_from(q, rows, alpha, gamma):
    for row in rows:
        update(q, *row, alpha, gamma)


def motion(left, right, radius, separation):
    """From the way of each wheel's rim in a second: the mean is the speed, the difference turns it."""
    rims = np.array([left, right]) * radius
    return [rims.mean(), np.rad2deg(np.diff(rims)[0] / separation)]


def estimate(rows, s, a):
    mine = np.array([row for row in rows if row[:2] == (s, a)]).reshape(-1, 4)
    after, which, count = np.unique(mine[:, 3], return_inverse=True, return_counts=True)
    means = np.bincount(which, weights=mine[:, 2], minlength=len(after)) / count
    return {
        int(x): [n / len(mine), mean]
        for x, n, mean in zip(after, count, means, strict=True)
    }


def sample(rows, s, a, u):
    mine = [i for i in range(len(rows)) if rows[i][0] == s and rows[i][1] == a]
    if not mine:
        return None
    _, _, r, s_next = rows[mine[math.floor(len(mine) * u)]]
    return [s_next, r]


def dyna(env, q, seen, choose, update, pick, steps):
    s = env.reset()
    while steps:
        a = choose(q, s)
        after, r, *ends = env.step(a)
        update(q, s, a, r, after, ends[0])
        seen.update({(s, a): (r, after, ends[0])})
        for x, b in pick(seen):
            reward_then, state_then, ended = seen[x, b]
            update(q, x, b, reward_then, state_then, ended)
        s = env.reset() if any(ends) else after
        steps -= 1


def overlaps(left, right, edges):
    """By how far each edge lies along the target's bin, from 0 at its left end to 1 at its right."""
    return np.diff(np.clip((np.array(edges) - left) / (right - left), 0, 1))


def nearest_ahead(ranges, angle_min, increment):
    """By the angle that is left when whole turns are taken away."""
    r, angles = np.array(ranges), angle_min + increment * np.arange(len(ranges))
    met = np.isfinite(r) & (r > 0)
    is_ahead = np.abs(np.angle(np.exp(1j * angles))) <= np.pi / 3
    return r[met & is_ahead].min(initial=np.inf) if met.any() else np.nan


RIGHT = ASSIGNMENTS | {
    "lesson_01": {
        "bin_of": lambda x, cuts: int(np.searchsorted(cuts, x)),
        "state_number": np.ravel_multi_index,
        "reward": reward,
    },
    "lesson_02": {"discounted_return": discounted_return},
    "lesson_03": {
        "target": lambda q, r, s_next, terminated, gamma: (
            r if terminated else r + gamma * q[s_next].max()
        ),
        "update": update,
        "learn": learn,
    },
    "lesson_04": {
        "epsilon_greedy": epsilon_greedy,
        "draw": lambda p, u: int(np.argmax(np.cumsum(p) > u)),
        "softmax": probabilities,
        "normalise": lambda q_s, r_max, gamma: q_s * 100 * (1 - gamma) / r_max,
    },
    "lesson_06": {
        "sarsa_update": sarsa_update,
        "sarsa_learn": sarsa_learn,
    },
    "lesson_07": {
        "sarsa_lambda_update": sarsa_lambda_update,
    },
    "lesson_08": {
        "dutch": lambda e, alpha: e - alpha * e + 1,
        "settles": 1.649,
        "true_online_update": true_online_update,
    },
    "lesson_05": {
        "siblings": siblings,
        "bias": bias_of,
    },
    "lesson_09": {
        "new_temperature": new_temperature,
    },
    "lesson_10": {
        "preferences": preferences,
        "choose": choose,
    },
    "lesson_11": {"motion": motion},
    "lesson_12": {
        "shaping": lambda phi, phi_next, end, gamma: gamma * phi_next * (not end) - phi
    },
    "lesson_13": {"gripper": gripper, "arm_reward": arm_reward},
    "lesson_14": {"estimate": estimate, "sample": sample, "second_look": 41.8},
    "lesson_15": {
        "p_value": lambda observed, shuffled: float(
            np.mean(np.asarray(shuffled) >= observed)
        ),
    },
    "lesson_16": {
        "follow_reward": follow_reward,
        "size": (192, 18.75),
        "still_safe": 0.245,
        "faults": (3, 1, 4),
    },
    "lesson_20": {"learn_from": learn_from},
    "lesson_17": {"dyna": dyna, "planned_by_hand": 0.9**2 / 8},
    "lesson_21": {"overlaps": overlaps},
    "lesson_22": {"two_biases": [1.75, 3.143]},
    "lesson_18": {
        "who_stops": [3, 4, 1, 2, 4],
        "wheels": lambda v, omega, radius, separation: (
            v / radius + omega * separation / radius * np.array([-0.5, 0.5])
        ),
        "nearest_ahead": nearest_ahead,
        "allowed": lambda v, omega, ahead, age: (
            min(v, v * (ahead >= 0.18)) * (ahead == ahead and age <= 0.5),
            omega if ahead == ahead and age <= 0.5 else 0,
        ),
    },
}
