"""Low-reward-loop evasion (LRLE): a robot that goes round in circles for nothing gets restless."""

from rlrobot_edu.jit.dispatcher import compiled

MAX_TEMPERATURE = 50.0  # the temperature rises no further


@compiled
def watch_for_loops(m, s, r):
    """Note that reward `r` led to state `s`, and set the temperature for the selection that comes next.

    The queue holds the latest states and rewards. Once it is full, the temperature rises by a quarter of
    the redundancy (states in the queue / different states) at every step on which `s` was already there, the mean
    reward is negative and the redundancy above 2. Otherwise it falls back to its default.
    `m` is the agent's memory, see memory.py. Source: paper algorithm 3.
    """
    if not m.parameters.loop_evasion:
        return
    now, length = m.now, m.queue_states.shape[0]
    end = now.queue_end
    if now.queue_size == length:
        oldest = m.queue_states[end]
        m.queue_count[oldest] -= 1
        now.queue_unique -= m.queue_count[oldest] == 0
    else:
        now.queue_size += 1
    m.queue_states[end] = s
    m.queue_rewards[end] = r
    now.queue_unique += m.queue_count[s] == 0
    m.queue_count[s] += 1
    now.queue_end = (end + 1) % length

    total_reward = 0.0  # summed in order: NumPy's own sum groups the terms, which changes the last bit
    for i in range(now.queue_size):
        total_reward += m.queue_rewards[i]
    redundancy = now.queue_size / now.queue_unique
    if (
        now.queue_size == length
        and m.queue_count[s] > 1
        and total_reward < 0.0
        and redundancy > 2.0
    ):
        now.temperature = min(MAX_TEMPERATURE, now.temperature + 0.25 * redundancy)
    else:
        now.temperature = m.parameters.temperature


@compiled
def forget_loops(m):
    """Empty the queue, as a new episode starts."""
    m.queue_count[:] = 0
    m.now.queue_size = m.now.queue_unique = m.now.queue_end = 0
    m.now.temperature = m.parameters.temperature
