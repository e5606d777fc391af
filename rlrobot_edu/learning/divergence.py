"""Action values that grow without end: they are noticed while an agent learns."""

from rlrobot_edu.learning.agent import LARGEST_KEPT, Agent

# Values so many times larger than any sum of discounted rewards have diverged. A few times
# larger is no proof: with accumulating traces values can be too large for a while.
FAR_TOO_LARGE = 1e6


class DivergenceCheck:
    """Compares the values of an agent with the rewards that it was given since this check was made.

    agent: the agent, before it learns
    """

    def __init__(self, agent: Agent) -> None:
        self._agent = agent
        self._first_q = agent.largest_q
        self._largest_reward = 0.0

    def check(self, largest_q: float, largest_reward: float, n_steps: int) -> None:
        """Raises ValueError if a value has diverged.

        largest_q: its magnitude, NaN if there is no such number; largest_reward: that of the rewards since the last
        call; n_steps: of the whole call of `learn` or `steps`
        """
        self._largest_reward = max(self._largest_reward, largest_reward)
        gamma = self._agent.parameters.gamma
        possible = LARGEST_KEPT
        if gamma < 1:
            possible = self._first_q + self._largest_reward / (1 - gamma)
        if largest_q <= min(FAR_TOO_LARGE * possible, LARGEST_KEPT):
            return
        advice = "take a smaller alpha"
        if self._agent.parameters.accumulating:
            advice += ", or traces that replace (accumulating=False)"
        raise ValueError(
            f"Q has diverged: after {n_steps:,} steps of {self._agent.method.name} the largest action value is "
            f"{largest_q:.3g}, but rewards allow no more than {possible:.3g}; {advice}"
        )
