# /// script
# requires-python = ">=3.11"
# dependencies = ["numpy"]
# ///
"""TOSL+QBIASSR in one file: true online SARSA(λ), and a softmax that asks similar states.

The robot of the paper's example lives in four cells. Driving on pays, bumping costs.
Its state is (X, Y, θ, d): its cell, its heading, and whether something is ahead of it.

Run it with `uv run tosl.py`. docs/method.md explains it.
"""

from collections import deque

import numpy as np

ALPHA = 0.1  # learning rate
GAMMA = 0.9  # discount
LAMBDA = 0.9  # decay of the eligibility traces
SMALLEST_TRACE = 0.01
TRACE_STEPS = int(np.log(SMALLEST_TRACE) / np.log(GAMMA * LAMBDA))
TEMPERATURE = 1.0
MAX_TEMPERATURE = 50.0


class Agent:
    """It remembers values and traces, and learns from each step."""

    def __init__(self, shape, n_actions, max_reward, rng):
        self.shape = shape  # how many values each input has
        self.n_states = int(np.prod(shape))
        self.q = np.zeros((self.n_states, n_actions))
        self.q_max = max_reward / (1 - GAMMA)
        self.rng = rng
        self.begin_episode()

    def begin_episode(self):
        """Forget how the robot came here; keep what it has learned."""
        self.e = np.zeros_like(self.q)
        self.q_old = 0.0
        self.register = []  # the states that have a trace, the latest first
        self.recent = deque(maxlen=max(4, min(TRACE_STEPS, self.n_states // 4)))
        self.temperature = TEMPERATURE

    # True online SARSA(λ)

    def update(self, s, a, r, s_next, a_next):
        """Learn from one step."""
        q_sa = self.q[s, a]
        q_next = self.q[s_next, a_next]
        delta = r + GAMMA * q_next - q_sa

        self.register_trace(s)
        self.e[s, a] = (1 - ALPHA) * self.e[s, a] + 1
        self.q += ALPHA * (delta + q_sa - self.q_old) * self.e
        self.q[s, a] -= ALPHA * (q_sa - self.q_old)
        self.q_old = q_next

        self.e *= GAMMA * LAMBDA
        self.e[self.e < SMALLEST_TRACE] = 0

    def register_trace(self, s):
        """Only s and the few states before it have a trace: reduced traces."""
        others = [x for x in self.register if x != s and self.e[x].any()]
        self.register = [s, *others[:TRACE_STEPS]]
        self.e[others[TRACE_STEPS:]] = 0

    # Q-biased softmax regression

    def biases(self, s):
        """For each input: the mean Q of the states that differ from s in it alone."""
        q = self.q.reshape(*self.shape, -1)
        values = np.unravel_index(s, self.shape)
        means = []
        for i in range(len(self.shape)):
            similar = list(values)
            similar[i] = slice(None)  # any value of input i
            means.append(q[tuple(similar)].mean(axis=0))
        return np.array(means)

    def probabilities(self, s):
        """The softmax of Q and bias."""
        bias = self.biases(s).mean(axis=0)
        preference = (self.q[s] + bias) * 100 / self.q_max
        p = np.exp((preference - preference.max()) / self.temperature)
        return p / p.sum()

    def select(self, s):
        """Draw an action."""
        below = np.cumsum(self.probabilities(s))
        a = np.searchsorted(below, self.rng.random(), side="right")
        return min(int(a), len(below) - 1)

    # Low-reward-loop evasion

    def watch_for_loops(self, s, r):
        """Raise the temperature while the robot goes round in circles for nothing."""
        self.recent.append((s, r))
        states = [state for state, _ in self.recent]
        redundancy = len(states) / len(set(states))
        is_full = len(states) == self.recent.maxlen
        was_here = states.count(s) > 1
        is_poor = sum(reward for _, reward in self.recent) < 0
        if is_full and was_here and is_poor and redundancy > 2:
            hotter = self.temperature + 0.25 * redundancy
            self.temperature = min(hotter, MAX_TEMPERATURE)
        else:
            self.temperature = TEMPERATURE


def learn(agent, world, n_episodes):
    """Let the agent learn; yield the state and the reward after each step."""
    for _ in range(n_episodes):
        agent.begin_episode()
        s = world.reset()
        a = agent.select(s)
        for _ in range(world.episode_steps):
            s_next, r = world.step(a)
            agent.watch_for_loops(s_next, r)
            a_next = agent.select(s_next)
            agent.update(s, a, r, s_next, a_next)
            yield s_next, r
            s, a = s_next, a_next


class FourCells:
    """The paper's example; the box and the rewards are ours. X never falls, so episodes are short."""

    shape = (2, 2, 3, 2)  # X, Y, θ, d: 24 states
    actions = ("advance", "spin left", "spin right")
    episode_steps = 30
    cells = ((0, 0), (0, 1), (1, 0), (1, 1))
    headings = (0, 90, -90)  # degrees

    def __init__(self, rng):
        self.rng = rng

    def reset(self):
        self.cell = (0, 0)
        self.heading = 0
        self.box = (1, 1)
        return self.state()

    def step(self, a):
        r = -0.02
        if self.actions[a] == "spin left":
            self.heading = min(self.heading + 90, 90)
        elif self.actions[a] == "spin right":
            self.heading = max(self.heading - 90, -90)
        elif self.is_free(self.cell_ahead()):
            self.cell = self.cell_ahead()
            r = 10.0
        else:
            r = -2.0
        if self.rng.random() < 0.1:
            self.move_box()
        return self.state(), r

    def state(self):
        x, y = self.cell
        is_blocked = not self.is_free(self.cell_ahead())
        return self.number(x, y, self.heading, is_blocked)

    def number(self, x, y, heading, is_blocked):
        values = (x, y, self.headings.index(heading), int(is_blocked))
        return int(np.ravel_multi_index(values, self.shape))

    def cell_ahead(self):
        x, y = self.cell
        return {0: (x + 1, y), 90: (x, y + 1), -90: (x, y - 1)}[self.heading]

    def is_free(self, cell):
        return cell in self.cells and cell != self.box

    def move_box(self):
        free = [c for c in self.cells if c not in (self.cell, self.box)]
        self.box = free[self.rng.integers(len(free))]


def new_robot(seed):
    """An agent that knows nothing, and a world of its own."""
    world = FourCells(np.random.default_rng([seed, 0]))
    rng = np.random.default_rng([seed, 1])
    return Agent(world.shape, len(world.actions), 10.0, rng), world


def print_curve(n_robots=12, n_episodes=12):
    """How much each episode pays."""
    rewards = []
    for seed in range(n_robots):
        agent, world = new_robot(seed)
        rewards += [r for _, r in learn(agent, world, n_episodes)]
    means = np.reshape(rewards, (n_robots, n_episodes, -1)).mean(axis=(0, 2))
    print(f"Reward a step, episode by episode, mean of {n_robots} robots\n")
    for number, mean in enumerate(means, start=1):
        print(f"{number:4} {mean:6.2f} {'█' * round(20 * mean)}")


def print_bias(seed=2):
    """What similar states say when a robot is in (1, 1, 90°, blocked) for the first time.

    This robot comes there later than most, so similar states have something to say.
    """
    agent, world = new_robot(seed)
    place = world.number(1, 1, 90, is_blocked=True)
    n_steps = 0
    for s, _ in learn(agent, world, n_episodes=100):
        n_steps += 1
        if s == place:
            break
    biases = agent.biases(place)
    print(f"After {n_steps} steps: for the first time in (1, 1, 90°, blocked)\n")
    print(" " * 16, *(f"{action:>10}" for action in world.actions))
    print_row("Q", agent.q[place])
    for name, bias in zip("XYθd", biases, strict=True):
        print_row(f"bias of {name}", bias)
    print_row("bias, their mean", biases.mean(axis=0))
    print_row("probability", agent.probabilities(place))


def print_row(name, numbers):
    print(f"{name:16}", *(f"{x:10.2f}" for x in numbers))


if __name__ == "__main__":
    print_curve()
    print()
    print_bias()
