"""Learning from what others did: an agent is taught by a recording before it explores by itself."""

import numpy as np

from rlrobot_edu.checks import check_count
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.step import make_step
from rlrobot_edu.models.recording import Recording


def learn_from(agent: Agent, recording: Recording, passes: int = 1) -> None:
    """Teach `agent` what a recording shows, each transition in its order, as if it had acted like that itself.

    Parameters
    ----------
    agent : Agent
        The agent that learns. It keeps what it knew before, and it can go on with `rlrobot_edu.learn`.
    recording : Recording
        What somebody did: a person (`rlrobot_edu.teleoperate`), another agent, another program.
    passes : int
        How often the recording is gone through.

    Raises
    ------
    ValueError
        If agent and recording have other states or actions, or come in the other order.

    Notes
    -----
    The next action a' of an update is the recorded one. So SARSA and its relatives learn what the teacher's way of
    acting is worth; Q-learning what the best action would be, as far as it was shown. The agent chooses a'
    itself where the recording leaves an episode unfinished.
    """
    if not isinstance(agent, Agent) or not isinstance(recording, Recording):
        raise ValueError(
            f"this takes an Agent and a Recording, in this order; got {agent!r:.40} and {recording!r:.40}"
        )
    check_count("passes", passes)
    source = recording.source
    if (source.states.shape, source.actions.n) != (agent.shape, agent.q.shape[1]):
        raise ValueError(
            f"the agent was made for states {agent.shape} and {agent.q.shape[1]} actions, the recording has states "
            f"{source.states.shape} and {source.actions.n} actions; make the agent from its task, {source.task_name}"
        )
    agent.pending, select = None, make_step(agent.method).select
    rows = list(
        zip(*(column.tolist() for column in recording.transitions[:5]), strict=True)
    )
    begins = {*np.flatnonzero(recording.step == 0).tolist(), len(rows)}
    for i, (s, a, r, s_next, terminated) in [*enumerate(rows)] * passes:
        if i in begins:
            agent.begin_episode(s)
        if i + 1 in begins:
            agent.learn_step(s, a, r, s_next, terminated)
        else:
            agent.visits[s, a] += 1
            select(
                agent.memory, s_next, agent.rng.random()
            )  # expected SARSA averages over its probabilities
            agent.update(s, a, r, s_next, rows[i + 1][1], terminated)
