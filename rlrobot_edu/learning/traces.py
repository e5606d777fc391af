"""The register of eligibility traces in an agent's memory `m`: which states have one, what they learn, how it fades."""

from rlrobot_edu.jit.dispatcher import compiled


@compiled
def remember(m, s):
    """Move state `s` to the front of the register, so that it can have a trace.

    The register has room for the current state and the n most recently visited states before it (RETR, paper section
    3), or, for full traces, for every state. A state that leaves a full register loses its traces.
    """
    register, size = m.register, m.now.register_size
    i = 0
    while i < size and register[i] != s:
        i += 1
    if i == size:  # s is new
        if size < register.shape[0]:
            m.now.register_size = size + 1
        else:
            i = size - 1
            m.e[register[i]] = 0.0
    while i > 0:
        register[i] = register[i - 1]
        i -= 1
    register[0] = s


@compiled
def pass_on(m, share, decay):
    r"""Let every pair with a trace learn its part of `share`, then let the traces fade.

    .. math:: Q \leftarrow Q + share \cdot e, \qquad e \leftarrow decay \cdot e

    A trace that has become too small is dropped (paper section 3), and a state with no trace left leaves the register.
    """
    q, e, register, smallest = m.q, m.e, m.register, m.parameters.smallest_trace
    kept = 0
    for i in range(m.now.register_size):
        x = register[i]
        largest = 0.0
        for b in range(q.shape[1]):
            q[x, b] += share * e[x, b]
            faded = decay * e[x, b]
            e[x, b] = faded if faded >= smallest else 0.0
            largest = max(largest, e[x, b])
        if largest > 0.0:
            register[kept] = x
            kept += 1
    m.now.register_size = kept


@compiled
def forget(m):
    """Drop all traces, as a new episode starts."""
    for i in range(m.now.register_size):
        m.e[m.register[i]] = 0.0
    m.now.register_size = 0
    m.now.q_old = 0.0
