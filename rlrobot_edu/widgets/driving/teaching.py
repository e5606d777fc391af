"""Learning from what others did: an agent is taught by a recording before it explores by itself."""

import numpy as np

from rlrobot_edu.checks import check_count
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.step import make_step
from rlrobot_edu.models.recording import Recording


@suggests_keywords
def learn_from(agent: Agent, recording: Recording, passes: int = 1) -> None:
    """Teach `agent` the transitions of a recording in their order, as if it had acted so itself.

    Parameters
    ----------
    agent : Agent
        The agent that learns. It keeps what it knew before, and it can go on with `rlrobot_edu.learn`.
    recording : Recording
        The steps of a person (`rlrobot_edu.teleoperate`), of another agent or of another program.
    passes : int
        How many times to go through the recording.

    Raises
    ------
    ValueError
        If agent and recording differ in states or actions, or if their order is wrong.

    Notes
    -----
    The next action a' of an update is the recorded one. So SARSA and its relatives learn the values of the teacher's
    policy, and Q-learning those of the best actions, as far as they were shown. Where the recording leaves an episode
    unfinished, the agent chooses a' itself.
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
    agent.pending = None
    select = make_step(agent.method).select
    columns = [column.tolist() for column in recording.transitions[:5]]
    rows = list(zip(*columns, strict=True))
    begins = {*np.flatnonzero(recording.step == 0).tolist(), len(rows)}
    for _ in range(passes):
        for i, (s, a, r, s_next, terminated) in enumerate(rows):
            if i in begins:
                agent.begin_episode(s)
            if i + 1 in begins:
                agent.learn_step(s, a, r, s_next, terminated)
                continue
            _, a_next, *_ = rows[i + 1]
            agent.visits[s, a] += 1
            # Its probabilities are needed: expected SARSA averages over them.
            select(agent.memory, s_next, agent.rng.random())
            agent.update(s, a, r, s_next, a_next, terminated)
