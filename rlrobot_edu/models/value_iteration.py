"""Planning on a sample model: the best that can be done in it, computed instead of learned."""

import math
from dataclasses import dataclass
from functools import reduce
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse import linalg

from rlrobot_edu.checks import check_between
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.learning.size import Size
from rlrobot_edu.models.sample_model import SampleModel

Numbers = NDArray[np.float64]

MOST_SWEEPS = 20_000
LONGEST = 100_000  # steps of an episode that is planned
FARSIGHTED = 1 - 1e-8  # discount rate at which values tell the average reward of a step


@dataclass(frozen=True, eq=False)
class Plan:
    """The solution of a model.

    q: array (n_states, n_actions), Q*; v: array (n_states,), V*; policy: array (n_states,), greedy in Q*
    sweeps: how many it took
    """

    q: Numbers
    v: Numbers
    policy: NDArray[np.intp]
    sweeps: int


class Expected(NamedTuple):
    """The expectation of every outcome, pairs being numbered s * n_actions + a.

    transitions: sparse array (pairs, n_states), probability of going on in s'; none after a terminal one
    anywhere: array (pairs,), probability of landing in any state at random
    reward: array (pairs,), expected reward
    after: array (pairs,), expected reward of a step after the end: Rmax where an episode ended well
    """

    transitions: sparse.csr_array
    anywhere: Numbers
    reward: Numbers
    after: Numbers


def expected_outcomes(model: SampleModel) -> Expected:
    """Probabilities and mean rewards of a model, including those of unseen pairs."""
    if not isinstance(model, SampleModel):
        raise ValueError(f"planning needs a SampleModel, not a {type(model).__name__}")
    n_states, n_actions = model.n_states, model.n_actions
    pairs = n_states * n_actions
    seen = model.sum_by_pair(1)
    rewards = model.sum_by_pair(model.r)
    reward_after = np.where(model.r > 0, model.r_max, model.r)
    after = model.sum_by_pair(reward_after * model.terminated)
    goes_on = ~model.terminated
    where = (model.pair[goes_on], model.s_next[goes_on])
    times = model.count[goes_on].astype(float)
    counts = sparse.csr_array((times, where), shape=(pairs, n_states))
    if model.unseen == "siblings":
        pool = _pool_of_siblings(model, seen)
        counts = counts + pool @ counts
        rewards = rewards + pool @ rewards
        after = after + pool @ after
        seen = seen + pool @ seen

    unseen = np.flatnonzero(seen == 0)
    anywhere = np.zeros(pairs)
    if model.unseen == "stay":
        where = (unseen, unseen // n_actions)
        once = np.ones(len(unseen))
        counts += sparse.csr_array((once, where), shape=(pairs, n_states))
    else:
        anywhere[unseen] = 1.0
    rewards[unseen] = model.rewards.mean() if anywhere.any() else model.rewards[0]
    total = np.where(seen > 0, seen, 1.0)
    transitions = sparse.csr_array(sparse.diags_array(1 / total) @ counts)
    return Expected(transitions, anywhere, rewards / total, after / total)


def _pool_of_siblings(model: SampleModel, seen: Numbers) -> sparse.csr_array:
    """Array (pairs, pairs): for each pair that was never tried, how often each other one counts in its place."""
    siblings = _sibling_matrix(model.shape)
    actions = sparse.eye_array(model.n_actions)
    pool = sparse.kron(siblings, actions, format="csr")
    is_unseen = (seen == 0).astype(float)
    return sparse.csr_array(sparse.diags_array(is_unseen) @ pool)


@suggests_keywords
def value_iteration(
    model: SampleModel, gamma: float = 0.9, tolerance: float = 1e-9
) -> Plan:
    r"""Q*, V* and the greedy policy of a sample model.

    .. math:: Q_{k+1}(s, a) = E[r] + \gamma \sum_{s'} T(s, a, s') V_k(s'), \qquad V_k(s) = \max_a Q_k(s, a)

    A pair that was never tried follows the model's `unseen`. A plan may try such pairs, except with "stay".

    Parameters
    ----------
    model : SampleModel
        The model to plan in.
    gamma : float
        Discount rate in [0, 1]. With 1, values have a limit only if episodes cannot go on for ever, or if they
        earn nothing then.
    tolerance : float
        Sweeps end when no value is further than this from its limit, or further than floating-point precision.

    Returns
    -------
    Plan
        ``q``: array (n_states, n_actions), ``v`` and ``policy``: array (n_states,), ``sweeps``: how many it took.

    Raises
    ------
    ValueError
        If `model` is not a SampleModel, `gamma` is not in [0, 1] or `tolerance` not in [1e-300, 1e300], or if
        values still change after 20,000 sweeps, as with gamma = 1 if they have no limit.

    References
    ----------
    Paper equation 1; Sutton & Barto, section 4.4. If sweeps approach their limit too slowly, every 1,000th is
    followed by a step of policy iteration (section 4.3), which solves for the values of the greedy policy.
    """
    expected = expected_outcomes(model)
    check_between("gamma", gamma, 0, 1)
    check_between("tolerance", tolerance, 1e-300, 1e300)
    return _solve(
        expected, model.n_states, float(gamma), float(tolerance), patience=1000
    )


def _solve(
    expected: Expected, n_states: int, gamma: float, tolerance: float, patience: int
) -> Plan:
    """The solution, by sweeps; after each `patience` of them, a step of policy iteration."""
    v = np.zeros(n_states)
    rate = gamma / (1 - gamma) if gamma < 1 else math.inf
    for sweeps in range(1, MOST_SWEEPS + 1):
        v_next = expected.transitions @ v + expected.anywhere * v.mean()
        q = (expected.reward + gamma * v_next).reshape(n_states, -1)
        before = v
        v = q.max(axis=1)
        change = float(np.abs(v - before).max())
        # A sweep brings V at least γ times nearer to V*, so what is missing is at most γ / (1 − γ) of it.
        if rate * change <= tolerance or change <= 16 * np.spacing(np.abs(v).max()):
            return Plan(q, v, q.argmax(axis=1), sweeps)
        if sweeps % patience == 0 and gamma < 1:
            v = before + _for_ever(expected, q.argmax(axis=1), gamma, v - before)
    raise ValueError(
        f"with gamma={gamma}, tolerance={tolerance} a value still changes by {change:.3g} in sweep {sweeps}; "
        "choose others, and a gamma below 1 where an episode can go on for ever"
    )


def _for_ever(
    expected: Expected, policy: NDArray[np.intp], gamma: float, r: Numbers
) -> Numbers:
    """What each state is worth if `policy` is followed for ever, earning r[s] in s, array (n_states,)."""
    n = len(policy)
    pairs = np.arange(n) * (len(expected.reward) // n) + policy
    # "Anywhere" is one more state, which is worth the mean of all.
    going_on = sparse.eye_array(n) - gamma * expected.transitions[pairs]
    lost = -gamma * expected.anywhere[pairs, None]
    mean = [np.full((1, n), -1 / n), np.ones((1, 1))]
    equations = sparse.block_array([[going_on, lost], mean], format="csc")
    return np.asarray(linalg.spsolve(equations, np.append(r, 0.0))[:n])


def best_average_reward(model: SampleModel) -> float:
    r"""The largest average reward a step that a policy can reach in the model, a ruler for curves.

    .. math:: g = \max_\pi \lim_{n \to \infty} \frac{1}{n} E_\pi \Big[ \sum_{t<n} r_t \Big]

    from the recorded starts. A task with episodes is planned over one episode of `episode_steps`, its
    goal counted as in `History.last_episode`.

    Parameters
    ----------
    model : SampleModel
        The model to plan in.

    Returns
    -------
    float
        The average reward.

    Raises
    ------
    ValueError
        If its episodes are too long to plan.

    Notes
    -----
    Without episodes it is (1 − γ) V* of the starts for a γ of almost 1; after a terminal outcome the next
    episode begins in one of the starts. It is right to about 1e-8 of the largest reward for each step
    that a detour takes.

    References
    ----------
    Puterman, *Markov Decision Processes*, section 8.2.2: the limit of (1 − γ) V for γ towards 1.
    """
    expected = expected_outcomes(model)
    episode_steps = Size.of(model).episode_steps
    if episode_steps:
        return _best_of_an_episode(model, expected, episode_steps)
    # Without this scale the largest numbers could not be added up.
    scale = np.abs(model.rewards).max() or 1.0
    ends = 1 - expected.transitions.sum(axis=1) - expected.anywhere
    ends[ends < 1e-9] = 0.0
    starts = np.bincount(model.starts.astype(np.intp), minlength=model.n_states)
    start_shares = starts / len(model.starts)
    again = sparse.kron(ends[:, None], start_shares[None, :])
    restarting = expected._replace(
        transitions=expected.transitions + again, reward=expected.reward / scale
    )
    v = _solve(restarting, model.n_states, FARSIGHTED, tolerance=1.0, patience=50).v
    average = scale * (1 - FARSIGHTED) * v[model.starts].mean()
    return float(np.clip(average, model.rewards[0], model.rewards[-1]))


def _best_of_an_episode(model: SampleModel, expected: Expected, steps: int) -> float:
    """The largest average reward of an episode, by one sweep for each of its steps, from the last to the first."""
    if steps > LONGEST:
        raise ValueError(
            f"an episode of {steps:,} steps is too long to plan; at most {LONGEST:,}"
        )
    v = np.zeros(model.n_states)
    for steps_left in range(steps):
        ended = expected.reward + expected.after * steps_left
        q = ended + expected.transitions @ v + expected.anywhere * v.mean()
        v = q.reshape(model.n_states, -1).max(axis=1)
    return float(v[model.starts].mean() / steps)


def _sibling_matrix(shape: tuple[int, ...]) -> sparse.csr_array:
    """Array (n_states, n_states): in how many families two states are together, see `StateSpace.siblings`."""
    families = [sparse.csr_array(np.ones((n_bins, n_bins))) for n_bins in shape]
    total = reduce(lambda before, after: sparse.kronsum(after, before), families)
    return sparse.csr_array(total)
