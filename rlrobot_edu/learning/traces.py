"""The register of eligibility traces: which states still have one."""

from rlrobot_edu.learning.jit import compiled


@compiled
def remember(m, s):
    """Move state `s` to the front of the register and return the register and how many states are in it.

    The register holds the current state and the n most recently visited states before it (RETR, paper section 3),
    or, for full traces, has room for every state. A state that leaves a full register loses its traces.
    """
    register, size = m.register, m.now.register_size
    i = 0
    while i < size and register[i] != s:
        i += 1
    if i == size:  # s is new
        if size < register.shape[0]:
            size += 1
            m.now.register_size = size
        else:
            i = size - 1
            m.e[register[i]] = 0.0
    while i > 0:
        register[i] = register[i - 1]
        i -= 1
    register[0] = s
    return register, size


@compiled
def forget(m):
    """Drop all traces, as a new episode starts."""
    for i in range(m.now.register_size):
        m.e[m.register[i]] = 0.0
    m.now.register_size = 0
    m.now.q_old = 0.0
