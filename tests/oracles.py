"""Independent, slow and plain versions of what the library computes. Tests compare with them, benchmarks race them."""

from __future__ import annotations

import numpy as np

import tosl


def numpy_bias(q, shape, s):
    """QBIASSR's bias by NumPy means along each input's axis of Q (paper algorithm 2); array (A,)."""
    cube = q.reshape(*shape, -1)
    bins = np.unravel_index(s, shape)
    families = [
        cube[(*bins[:i], slice(None), *bins[i + 1 :])].mean(axis=0)
        for i in range(len(shape))
    ]
    return np.mean(families, axis=0)


def numpy_softmax(x, temperature):
    """Boltzmann probabilities of the preferences `x`; array (A,)."""
    p = np.exp((x - x.max()) / temperature)
    return p / p.sum()


class NumpyLoopEvasion:
    """LRLE on a plain list of the recent (state, reward) pairs (paper algorithm 3)."""

    def __init__(self, length, default):
        self.length, self.default, self.temperature, self.recent = (
            length,
            default,
            default,
            [],
        )

    def __call__(self, s, r):
        self.recent = [*self.recent, (s, r)][-self.length :]
        states = [state for state, _ in self.recent]
        redundancy = len(states) / len(set(states))
        if (
            len(states) == self.length
            and states.count(s) > 1
            and np.mean([reward for _, reward in self.recent]) < 0
            and redundancy > 2
        ):
            self.temperature = min(50.0, self.temperature + 0.25 * redundancy)
        else:
            self.temperature = self.default
        return self.temperature


def learn_in_one_file(world, model, steps, rng):
    """Q and rewards of the agent of tosl.py in `world`; shape, actions and rewards are those of a sample model."""
    world.episode_steps = steps
    agent = tosl.Agent(model.shape, model.n_actions, model.r_max, rng)
    rewards = [r for _, r in tosl.learn(agent, world, n_episodes=1)]
    return agent.q, rewards


class NumpyModelWorld:
    """A sample model as a dictionary of outcomes, drawn by NumPy: the world of the plain loop.

    It draws as the library does, so that the same generator gives the same world. Unseen pairs: uniform.
    """

    def __init__(self, model, rng):
        self.model, self.rng, self.table = model, rng, {}
        for pair in range(len(model.offsets) - 1):
            rows = slice(model.offsets[pair], model.offsets[pair + 1])
            if rows.stop > rows.start:
                self.table[pair] = (
                    model.cumulative[rows],
                    model.s_next[rows],
                    model.r[rows],
                )

    def reset(self):
        self.s = self.model.starts[int(self.rng.random() * len(self.model.starts))]
        return self.s

    def step(self, a):
        u, v = self.rng.random(), self.rng.random()
        outcomes = self.table.get(self.s * self.model.n_actions + a)
        if outcomes is None:
            rewards = self.model.rewards
            self.s = int(u * self.model.n_states)
            return self.s, rewards[int(v * len(rewards))]
        cumulative, s_next, r = outcomes
        i = np.searchsorted(cumulative, int(u * cumulative[-1]), side="right")
        self.s = s_next[i]
        return self.s, r[i]


def numpy_q_learning(world, steps, rng, alpha=0.1, gamma=0.9):
    """Q after these steps of Q-learning with softmax regression (temperature 1) in a `NumpyModelWorld`."""
    model = world.model
    q, s = np.zeros((model.n_states, model.n_actions)), world.reset()
    for _ in range(steps):
        p = numpy_softmax(q[s] * 100 * (1 - gamma) / model.r_max, 1.0)
        a = min(
            int(np.searchsorted(np.cumsum(p), rng.random(), side="right")),
            model.n_actions - 1,
        )
        s_next, r = world.step(a)
        q[s, a] += alpha * (r + gamma * q[s_next].max() - q[s, a])
        s = s_next
    return q


def online_lambda_return(transitions, n_states, n_actions, alpha, gamma, lam):
    """Q after every step by the online λ-return algorithm (Sutton & Barto, section 12.4), straight from its definition.

    transitions: list of (s, a, r, s', a', terminated) of one episode. At every horizon h all updates are done again
    from the first step on, with the λ-returns truncated at h. Yields an array (n_states, n_actions) for each step.
    The n-step returns bootstrap with the Q of the horizon that had just reached their last state.
    """
    q_at = [np.zeros((n_states, n_actions))]  # Q at the end of horizon 0, 1, 2, …
    for h in range(1, len(transitions) + 1):
        q = np.zeros((n_states, n_actions))
        for t in range(h):
            s, a, *_ = transitions[t]
            returns = []
            total, discount = 0.0, 1.0
            for n in range(1, h - t + 1):
                _, _, r, s_n, a_n, terminated = transitions[t + n - 1]
                total += discount * r
                discount *= gamma
                # weights of horizon t + n - 1, that is, the values known as that state was reached
                returns.append(
                    total
                    if terminated
                    else total + discount * q_at[t + n - 1][s_n, a_n]
                )
            weights = [(1 - lam) * lam**i for i in range(len(returns) - 1)] + [
                lam ** (len(returns) - 1)
            ]
            q[s, a] += alpha * (np.dot(weights, returns) - q[s, a])
        q_at.append(q)
        yield q
