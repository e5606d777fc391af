"""The loop in which an agent and its world take turns: one step at a time, or a whole learning process."""

import time
from collections.abc import Iterator
from copy import copy
from typing import Any, NamedTuple

import gymnasium
import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.checks import check_count
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.compiled_loop import run_slices
from rlrobot_edu.learning.history import History, Learned
from rlrobot_edu.learning.interrupts import DelayedInterrupt, StopsAtOnce
from rlrobot_edu.learning.kernel_world import KernelEnv
from rlrobot_edu.learning.methods import parse_method
from rlrobot_edu.learning.observations import state_numbers
from rlrobot_edu.learning.progress import Interrupted, progress_bar
from rlrobot_edu.learning.resume import ResumePoint, begin_walk, is_at, place_of
from rlrobot_edu.learning.size import OLD_GYM, Env, Size
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


def steps(
    agent: Agent, env: Env, steps: int, *, resume: bool = False
) -> Iterator[Step]:
    """Let `agent` learn in `env` for a number of steps and yield each one; both may be looked at in between.

    The environment is reset first, and whenever an episode has ended.

    Parameters
    ----------
    agent : Agent
        What learns.
    env : gymnasium.Env
        An environment with states and actions that can be counted, see `make_env`.
    steps : int
        How many steps.
    resume : bool
        The first episode is not a new one: it goes on where the last call left off, see `learn`.

    Returns
    -------
    iterator of Step
        One step after the other.

    Raises
    ------
    ValueError
        If agent and environment do not fit, or if there is nothing to resume.
    KeyboardInterrupt
        After Ctrl-C: at once between two steps, else when the step is done, as in `learn`.
    """
    check_count("steps", steps, least=0)
    _prepare(agent, env, resume)
    return _whole_steps(_walk(agent, env, steps), _delayed_interrupt(env))


def _whole_steps(walk: Iterator[Step], interrupt: DelayedInterrupt) -> Iterator[Step]:
    """The steps of `walk`, each of which Ctrl-C lets end. Between two steps it is heard at once."""
    while True:
        with interrupt:
            step = next(walk, None)
        if step is None:
            return
        yield step


def _delayed_interrupt(env: Env) -> DelayedInterrupt:
    """What lets the steps in `env` end. A real robot must stop at once, even if nothing can be resumed then."""
    inner = env.unwrapped
    must_stop = isinstance(inner, StopsAtOnce) and inner.stops_at_once
    return DelayedInterrupt(waits=not must_stop)


def _walk(agent: Agent, env: Env, n_steps: int, looks: bool = True) -> Iterator[Step]:
    """The loop itself, which `steps` and `learn` share. looks: whether a step tells how its action was chosen."""
    state_number = state_numbers(env)
    for t in range(n_steps):
        before = _episode_so_far(agent)
        # until the step is whole: a fault, or Ctrl-C that does not wait, may come anywhere within it
        agent.resume_point = None
        if agent.pending is None:
            s = state_number(_answer("reset", env.reset(), 2)[0])
            agent.pending = s, agent.begin_episode(s)
        s, a = agent.pending
        # as it was when it chose a: copies
        selection = (
            (
                agent.probabilities.copy(),
                copy(agent.bias),
                float(agent.memory.now.temperature),
            )
            if looks
            else (agent.probabilities, None, np.nan)
        )
        observation, r, terminated, truncated, _ = _answer("step", env.step(a), 5)
        s_next = state_number(observation)
        a_next, delta = agent.learn_step(s, a, r, s_next, terminated)
        step = Step(
            t,
            s,
            a,
            float(r),
            s_next,
            bool(terminated),
            bool(truncated),
            a_next,
            delta,
            *selection,
        )
        agent.pending = None if a_next is None or truncated else (s_next, a_next)
        agent.resume_point = ResumePoint(
            before.steps + 1, before.reward + step.r, place_of(env)
        )
        yield step


def _episode_so_far(agent: Agent) -> ResumePoint:
    """Steps and rewards of the episode that still runs; none if there is no such."""
    if agent.pending is None or agent.resume_point is None:
        return ResumePoint()
    return agent.resume_point


def _answer(asked: str, answer: Any, n: int) -> Any:
    """The `n` values that an environment answered. Raises ValueError if it answers as those of the old Gym do."""
    if not (isinstance(answer, tuple) and len(answer) == n):
        raise ValueError(
            f"{asked}() must return {n} values, as in Gymnasium, got {answer!r:.100}; {OLD_GYM}"
        )
    return answer


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
    """Let `agent` learn in `env` for some steps or episodes and return what happened; what it had learned before stays.

    An environment that can run the whole loop compiled does so (a sample model); the numbers are the same.

    Parameters
    ----------
    agent : Agent
        What learns.
    env : gymnasium.Env
        An environment with states and actions that can be counted, see `make_env`.
    steps : int, optional
        How many steps. With `episodes` it need not be given: then all episodes together may take 10,000 steps each,
        or what the longest takes where they are cut off.
    episodes : int, optional
        Stop sooner, once so many episodes have ended.
    keep : bool
        The history keeps every transition, not the rewards alone.
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
        If agent and environment do not fit, if neither `steps` nor `episodes` is given, or if there is nothing to
        resume.
    KeyboardInterrupt
        After Ctrl-C, in one line; what was learned is kept.

    Notes
    -----
    Ctrl-C lets the step end, so that a resumed call gives the numbers of one undisturbed call. Pressed a second time,
    it interrupts the step, for example one that hangs. An environment whose attribute ``stops_at_once`` is true is
    interrupted by the first Ctrl-C; one with a robot behind a link is such, because the robot has to stop.

    To resume is refused if it could give other numbers:

    - after a step that was interrupted or failed, for the robot may have moved without the agent knowing;
    - in another environment, or after another agent has learned in this one;
    - after anything else has reset or stepped it. This is seen by its state and the steps of its episode, if they are
      attributes of the environment, as in the toolkit's, Gymnasium's own and its ``TimeLimit``.

    A copy of the environment (`copy.deepcopy`, `pickle`) is as good, if it counts the steps of its episode. An agent's
    copy can resume instead of the agent: where one of them has gone on, the other is refused.
    """
    check_count("steps", steps, least=0, or_none=True)
    check_count("episodes", episodes, or_none=True)
    check_pair_of(agent, env)
    if steps is None:
        steps = _longest(env, episodes)
    if steps > MOST_STEPS:
        raise ValueError(
            f"a history holds at most {MOST_STEPS:,} steps; then go on with resume=True"
        )
    size = _prepare(agent, env, resume)
    before = _episode_so_far(agent)._replace(place=None)  # of no use in a history
    log = Transitions.empty(int(steps))
    n = 0
    start = time.perf_counter()
    try:
        with (
            progress_bar(steps, progress, desc=agent.method.name, unit="step") as bar,
            _delayed_interrupt(env) as interrupt,
        ):
            for done in _learn(agent, env, log, episodes):
                n += done
                interrupt.raise_if_pressed()
                bar.update(done)
    except KeyboardInterrupt:
        raise Interrupted(
            f"Stopped after some {n:,} of {steps:,} steps; what was learned is kept."
        ) from None
    log = log.part(slice(n))
    if not keep:
        log = log.without_states()
    return History(
        method=agent.method.name,
        transitions=log,
        learned=Learned.of(agent.q, agent.visits),
        seconds=time.perf_counter() - start,
        size=size,
        before=before,
    )


def _longest(env: Env, episodes: int | None) -> int:
    """The steps that so many episodes may take. Raises ValueError if it is not said how many."""
    if episodes is None:
        raise ValueError("give steps= or episodes=: how long it takes")
    longest = Size.of(env).episode_steps or EPISODE_STEPS
    return min(episodes * longest, MOST_STEPS)


def evaluate(
    agent: Agent,
    env: Env,
    steps: int | None = None,
    *,
    episodes: int | None = None,
    keep: bool = False,
    progress: bool = True,
) -> History:
    """Let a copy of `agent` act in `env` without learning, and return what happened; the agent stays as it is.

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

    Yields now and then how many steps have come since; the agent may be looked at meanwhile. A world of kernels runs
    compiled; where it ends sooner, the loop goes on here.
    """
    n, columns = 0, log._asdict()
    if isinstance(env, KernelEnv):
        world = env.kernel_world(len(log.r))
        slices = run_slices(env, world, agent, log, episodes) if world else ()
        for done in slices:
            n += done
            yield done
    ended = np.count_nonzero(log.terminated[:n] | log.truncated[:n])
    if ended == episodes:
        return
    for step in _walk(agent, env, len(log.r) - n, looks=False):
        for name, column in columns.items():
            column[n + step.t] = getattr(step, name)
        yield 1
        ended += step.terminated or step.truncated
        if ended == episodes:
            return


def _prepare(agent: Agent, env: Env, resume: bool) -> Size:
    """Check that the agent fits the environment, whose size is returned, and that there is an episode to resume.

    Without `resume`, the last one is dropped.
    """
    check_pair_of(agent, env)
    made_for = f"states {agent.shape} and {agent.q.shape[1]} actions"
    size = Size.of(env)
    found = f"states {size.shape} and {size.n_actions} actions"
    if made_for != found:
        raise ValueError(
            f"the agent was made for {made_for}, this world has {found}; make both of one task"
        )
    if resume:
        _check_resumable(agent, env)
    left = agent.resume_point
    agent.resume_point = None  # first, for Ctrl-C may come between these lines
    if left is None or not resume:
        agent.pending = None
        left = ResumePoint()
    agent.resume_point = left._replace(place=begin_walk(env))
    agent.method = parse_method(agent.method)  # as its code is now
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
