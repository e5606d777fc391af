"""The loop in which an agent and its world take turns, step by step."""

import time
from collections.abc import Iterator
from copy import copy
from typing import Any, NamedTuple

import gymnasium
import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.checks import check_count
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.compiled_loop import run_slices
from rlrobot_edu.learning.divergence import DivergenceCheck
from rlrobot_edu.learning.history import History, Learned
from rlrobot_edu.learning.interrupts import DelayedInterrupt, StopsAtOnce
from rlrobot_edu.learning.kernel_world import KernelEnv
from rlrobot_edu.learning.methods import parse_method
from rlrobot_edu.learning.observations import state_numbers
from rlrobot_edu.learning.progress import Interrupted, progress_bar
from rlrobot_edu.learning.resume import ResumePoint, begin_walk, is_at, place_of
from rlrobot_edu.learning.size import (
    OLD_GYM,
    Env,
    Size,
    longest_episode,
    warn_of_other_rewards,
)
from rlrobot_edu.learning.transitions import Transitions

MOST_STEPS = 100_000_000  # in one history, which takes 22 bytes for each
EPISODE_STEPS = 10_000  # on average, of episodes that nothing cuts off


class Step(NamedTuple):
    """One step of a learning process.

    Parameters
    ----------
    t : int
        Number of the step, from 0.
    s, a, r, s_next : int, int, float, int
        The transition: state, action, reward and next state.
    terminated, truncated : bool
        Whether the episode ended here, for good or by running out of time.
    a_next : int, optional
        The action chosen for s_next; None once terminated.
    delta : float
        The TD error; NaN of an agent that learns no more.
    probabilities : array (n_actions,)
        The probability of each action in s when a was chosen.
    bias : array (n_actions,), optional
        What a biased selection added to Q(s) when it chose a; None for other selections.
    temperature : float
        Boltzmann temperature of that choice.
    """

    t: int
    s: int
    a: int
    r: float
    s_next: int
    terminated: bool
    truncated: bool
    a_next: int | None
    delta: float
    probabilities: NDArray[np.float64]
    bias: NDArray[np.float64] | None
    temperature: float


@suggests_keywords
def steps(
    agent: Agent, env: Env, steps: int, *, resume: bool = False
) -> Iterator[Step]:
    """Let `agent` learn in `env` and yield each step.

    Agent and environment may be looked at between two steps. The environment is reset first, and whenever an episode
    has ended.

    Parameters
    ----------
    agent : Agent
        What learns.
    env : gymnasium.Env
        An environment with states and actions that can be counted, see `make_env`.
    steps : int
        How many steps.
    resume : bool
        Go on with the episode in which the last call left off, see `learn`.

    Returns
    -------
    iterator of Step
        One step after the other.

    Raises
    ------
    ValueError
        If agent and environment do not fit, if there is nothing to resume, or if action values have diverged.
    KeyboardInterrupt
        After Ctrl-C: at once between two steps, otherwise when the step is done, as in `learn`.
    """
    steps = check_count("steps", steps, least=0)
    _prepare(agent, env, resume)
    return _whole_steps(_walk(agent, env, steps), _delayed_interrupt(env))


def _whole_steps(walk: Iterator[Step], interrupt: DelayedInterrupt) -> Iterator[Step]:
    """The steps of `walk`. Ctrl-C waits for the end of a step; between two steps it acts at once."""
    while True:
        with interrupt:
            step = next(walk, None)
        if step is None:
            return
        yield step


def _delayed_interrupt(env: Env) -> DelayedInterrupt:
    """Makes Ctrl-C wait for the end of a step in `env`, but not for a real robot, which must stop at once."""
    inner = env.unwrapped
    must_stop = isinstance(inner, StopsAtOnce) and inner.stops_at_once
    return DelayedInterrupt(waits=not must_stop)


def _walk(agent: Agent, env: Env, n_steps: int) -> Iterator[Step]:
    """The loop itself, which `steps` and `learn` share."""
    state_number = state_numbers(env)
    values = DivergenceCheck(agent)
    for t in range(n_steps):
        before = _episode_so_far(agent)
        # A fault, or a Ctrl-C that does not wait, may come anywhere within the step. Then
        # nobody knows whether the environment has moved, and nothing can be resumed.
        agent.resume_point = None
        if agent.pending is None:
            observation, _ = _answer("reset", env.reset(), 2)
            first = state_number(observation)
            agent.pending = (first, agent.begin_episode(first))
        s, a = agent.pending
        # Copies, because the agent changes them when it learns.
        probabilities = agent.probabilities.copy()
        bias = copy(agent.bias)
        temperature = float(agent.memory.now.temperature)

        observation, r, terminated, truncated, _ = _answer("step", env.step(a), 5)
        s_next = state_number(observation)
        a_next, delta = agent.learn_step(s, a, r, s_next, terminated)
        values.check(abs(float(agent.q[s, a])), abs(float(r)), t + 1)

        if a_next is None or truncated:
            agent.pending = None
        else:
            agent.pending = (s_next, a_next)
        reward = before.reward + float(r)
        agent.resume_point = ResumePoint(before.steps + 1, reward, place_of(env))
        yield Step(
            t=t,
            s=s,
            a=a,
            r=float(r),
            s_next=s_next,
            terminated=bool(terminated),
            truncated=bool(truncated),
            a_next=a_next,
            delta=delta,
            probabilities=probabilities,
            bias=bias,
            temperature=temperature,
        )


def _episode_so_far(agent: Agent) -> ResumePoint:
    """Steps and rewards of the episode that is still running; zero if there is none."""
    if agent.pending is None or agent.resume_point is None:
        return ResumePoint()
    return agent.resume_point


def _answer(asked: str, answer: Any, n: int) -> Any:
    """The `n` values that an environment answered. Raises ValueError for another number, as in the old Gym."""
    if not isinstance(answer, tuple) or len(answer) != n:
        raise ValueError(
            f"{asked}() must return {n} values, as in Gymnasium, got {answer!r:.100}; {OLD_GYM}"
        )
    return answer


@suggests_keywords
def learn(
    agent: Agent,
    env: Env,
    steps: int | None = None,
    *,
    episodes: int | None = None,
    keep: bool = False,
    progress: bool = True,
    resume: bool = False,
) -> History:
    """Let `agent` learn in `env` for some steps or episodes and return what happened.

    What the agent has learned before stays. An environment that can run the whole loop compiled does so (a sample
    model, for example); the numbers are the same.

    Parameters
    ----------
    agent : Agent
        What learns.
    env : gymnasium.Env
        An environment with states and actions that can be counted, see `make_env`.
    steps : int, optional
        How many steps. It may be left out if `episodes` is given: then the limit is the number of episodes times
        the steps after which one is cut off, or times 10,000 where nothing cuts them off.
    episodes : int, optional
        Stop sooner, once so many episodes have ended.
    keep : bool
        Keep every transition in the history, not the rewards alone.
    progress : bool
        Show a progress bar.
    resume : bool
        Go on where the last call left off: in the middle of its episode, or with the next one if it has ended.

    Returns
    -------
    History
        Rewards, ends of episodes, and what the agent knew at the end.

    Raises
    ------
    ValueError
        If agent and environment do not fit, if neither `steps` nor `episodes` is given, if there is nothing to
        resume, or if action values have diverged.
    KeyboardInterrupt
        After Ctrl-C, in one line; what was learned is kept.

    Notes
    -----
    Ctrl-C waits for the end of the step, so a resumed call gives the same numbers as one uninterrupted call. A second
    Ctrl-C interrupts the step, for example one that hangs. In an environment whose attribute ``stops_at_once`` is true,
    the first Ctrl-C interrupts the step. This is so with a robot behind a link, because it has to stop.

    Resuming is refused if it could give other numbers:

    - after a step that was interrupted or failed, because the robot may have moved without the agent knowing;
    - in another environment, or after another agent has learned in this one;
    - after anything else has reset or stepped it. We notice this by its state and the steps of its episode, if they
      are attributes of the environment, as in the toolkit's, Gymnasium's own and its ``TimeLimit``.

    A copy of the environment (`copy.deepcopy`, `pickle`) can take its place, if it counts the steps of its episode. A
    copy of the agent can resume instead of the agent. When one of them has gone on, the other is refused.
    """
    steps = check_count("steps", steps, least=0, or_none=True)
    episodes = check_count("episodes", episodes, or_none=True)
    check_pair_of(agent, env)
    if steps is None:
        steps = _longest(env, episodes)
    if steps > MOST_STEPS:
        raise ValueError(
            f"a history holds at most {MOST_STEPS:,} steps; then go on with resume=True"
        )
    size = _prepare(agent, env, resume)
    before = _episode_so_far(agent)._replace(place=None)  # of no use in a history
    log = Transitions.empty(steps)
    values = DivergenceCheck(agent)
    n_done = 0
    start = time.perf_counter()
    try:
        with (
            progress_bar(steps, progress, desc=agent.method.name, unit="step") as bar,
            _delayed_interrupt(env) as interrupt,
        ):
            for n_new in _learn(agent, env, log, episodes):
                if n_new > 1:  # the plain loop checks each step
                    largest_reward = np.abs(log.r[n_done : n_done + n_new]).max()
                    values.check(agent.largest_q, largest_reward, n_done + n_new)
                n_done += n_new
                interrupt.raise_if_pressed()
                bar.update(n_new)
    except KeyboardInterrupt:
        raise Interrupted(
            f"Stopped after about {n_done:,} of {steps:,} steps; what was learned is kept."
        ) from None
    seconds = time.perf_counter() - start
    log = log.part(slice(n_done))
    values.check(agent.largest_q, np.abs(log.r).max(initial=0.0), n_done)
    warn_of_other_rewards(env, log.r)
    if not keep:
        log = log.without_states()
    return History(
        method=agent.method.name,
        transitions=log,
        learned=Learned.of(agent.q, agent.visits),
        seconds=seconds,
        size=size,
        before=before,
    )


def _longest(env: Env, episodes: int | None) -> int:
    """The steps that so many episodes may take. Raises ValueError if their number is not given."""
    if episodes is None:
        raise ValueError("give steps= or episodes=: how long it takes")
    longest = longest_episode(env) or EPISODE_STEPS
    return min(episodes * longest, MOST_STEPS)


@suggests_keywords
def evaluate(
    agent: Agent,
    env: Env,
    steps: int | None = None,
    *,
    episodes: int | None = None,
    keep: bool = False,
    progress: bool = True,
) -> History:
    """Let a copy of `agent` act in `env` without learning, and return what happened.

    The agent stays as it is.

    Parameters
    ----------
    agent : Agent
        Whose copy acts, see `Agent.frozen`.
    env, steps, episodes, keep, progress : gymnasium.Env, int, int, bool, bool
        See `learn`.

    Returns
    -------
    History
        Rewards and ends of episodes.

    Raises
    ------
    ValueError
        If agent and environment do not fit.
    KeyboardInterrupt
        After Ctrl-C, in one line.
    """
    check_pair_of(agent, env)
    still = agent.frozen()
    return learn(still, env, steps, episodes=episodes, keep=keep, progress=progress)


def _learn(
    agent: Agent, env: Env, log: Transitions, episodes: int | None
) -> Iterator[int]:
    """Let `agent` learn and fill `log`, until it is full or so many `episodes` have ended.

    Yields now and then the number of new steps; the agent may be looked at in between. A world of kernels runs
    compiled. If it ends sooner, the loop goes on here.
    """
    n_done = 0
    for n_new in _learn_compiled(agent, env, log, episodes):
        n_done += n_new
        yield n_new
    is_end = log.terminated[:n_done] | log.truncated[:n_done]
    n_ended = np.count_nonzero(is_end)
    if n_ended == episodes:
        return
    for step in _walk(agent, env, len(log.r) - n_done):
        _write(log, n_done + step.t, step)
        yield 1
        n_ended += step.terminated or step.truncated
        if n_ended == episodes:
            return


def _learn_compiled(
    agent: Agent, env: Env, log: Transitions, episodes: int | None
) -> Iterator[int]:
    """The part of `_learn` that a world of kernels runs compiled; nothing in any other world."""
    if isinstance(env, KernelEnv):
        world = env.kernel_world(len(log.r))
        if world is not None:
            yield from run_slices(env, world, agent, log, episodes)


def _write(log: Transitions, row: int, step: Step) -> None:
    log.s[row] = step.s
    log.a[row] = step.a
    log.r[row] = step.r
    log.s_next[row] = step.s_next
    log.terminated[row] = step.terminated
    log.truncated[row] = step.truncated


def _prepare(agent: Agent, env: Env, resume: bool) -> Size:
    """Check that agent and environment fit, and begin anew or resume. Returns the environment's size."""
    check_pair_of(agent, env)
    size = Size.of(env)
    n_actions = agent.q.shape[1]
    if agent.shape != size.shape or n_actions != size.n_actions:
        raise ValueError(
            f"the agent was made for states {agent.shape} and {n_actions} actions, "
            f"this world has states {size.shape} and {size.n_actions} actions; "
            "make both from the same task"
        )
    if resume:
        _check_resumable(agent, env)
    left = agent.resume_point
    agent.resume_point = None  # first, because Ctrl-C may come between these lines
    if left is None or not resume:
        agent.pending = None
        left = ResumePoint()
    agent.resume_point = left._replace(place=begin_walk(env))
    agent.method = parse_method(agent.method)  # with the code of own parts as it is now
    return size


def _check_resumable(agent: Agent, env: Env) -> None:
    """Raises ValueError unless `agent` can go on in `env` where it left off."""
    if agent.resume_point is None:
        reason = "it has begun no episode, or was interrupted within a step"
    elif agent.pending is not None and not is_at(env, agent.resume_point.place):
        reason = (
            "its environment was reset or stepped by somebody else since then, "
            "or this is another one"
        )
    else:
        return
    raise ValueError(
        f"the agent has nothing to resume: {reason}; call without resume=True to begin anew"
    )


def check_pair_of(agent: object, env: object) -> None:
    """Raises ValueError unless these are an agent and an environment, in this order."""
    if not isinstance(agent, Agent) or not isinstance(env, gymnasium.Env):
        given = f"got {type(agent).__name__} and {type(env).__name__}"
        if hasattr(env, "step") and not isinstance(env, gymnasium.Env | Agent):
            given += f"; {OLD_GYM}"
        raise ValueError(
            f"this takes an Agent and an environment (see rl.make_env), in this order; {given}"
        )
