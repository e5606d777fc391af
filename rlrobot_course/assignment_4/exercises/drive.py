"""The loop with bias and temperature."""

from __future__ import annotations

import numpy as np

from rlrobot_course.assignment_4.exercises.bias_table import bias_table
from rlrobot_course.assignment_4.exercises.next_temperature import next_temperature
from rlrobot_course.assignment_4.given import draw, table
from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.tapes import TapeWorld, with_action


def drive(env, q, shape, us, alpha, gamma, scale, default):
    earned, heat, states, rewards, temperature = [], [], [], [], default
    s = env.reset()
    for u in us:
        x = scale * (q[s] + bias_table(q, shape)[s])
        a = draw(x, temperature, u)
        s_next, r, terminated, truncated = env.step(a)
        target = r if terminated else r + gamma * max(q[s_next])
        q[s, a] += alpha * (target - q[s, a])
        earned.append(r)
        heat.append(temperature)
        states, rewards = [*states, s_next][-8:], [*rewards, r][-8:]
        temperature = next_temperature(temperature, states, rewards, default)
        s = s_next
        if terminated or truncated:
            s, states, rewards, temperature = env.reset(), [], [], default
    return earned, heat


class Yard(TapeWorld):
    """A world without chance of four states (2 × 2 bins) and three actions; 0 stays where it is, and earns little.

    Action 2 in state 1 leads to state 3. The first, third … episode terminates there, and that pays; the others are
    truncated after 14 steps. So it goes in circles much of the time.
    reset() -> state; step(action) -> state, reward, terminated, truncated
    """

    def reset(self) -> int:
        """Start an episode; returns its first state."""
        self.episode, self.t, self.s = self.episode + 1, 0, self.episode % 3
        return self.s

    @with_action
    def step(self, a: int) -> tuple[int, float, bool, bool]:
        """Do action `a`: returns next state, reward, terminated, truncated."""
        self.t, before = self.t + 1, self.s
        self.s = (self.s + a) % 4
        odd = self.episode % 2 == 1
        there = before == 1 and a == 2 and odd
        return self.s, 1.5 if there else -0.5 - 0.25 * a, there, not odd and self.t >= 14


def numbers(n: int, turn: int) -> list[float]:
    """Random numbers for the choices, always the same."""
    return [float(u) for u in np.random.default_rng(turn).random(n)]


CHANGED, WITNESSES = read_answers(
    __file__, {"bias_table": bias_table, "draw": draw, "next_temperature": next_temperature}
)

exercise = Exercise(
    task="choose by Q and bias, learn, note, heat up, and go on; return all rewards and all temperatures",
    right=drive,
    returns="rewards and temperatures",
    memory={"env": Yard(), "q": table(4, 3, 7) / 6},
    lenders={"bias_table": "your function of exercise 2", "next_temperature": "your function of exercise 4"},
    tape=[
        {"shape": (2, 2), "us": numbers(n, n), "alpha": alpha, "gamma": gamma, "scale": scale, "default": default}
        for n, alpha, gamma, scale, default in (
            (6, 0.5, 0.9, 1.25, 0.75),
            (25, 0.25, 0.8, 0.75, 0.5),
            (40, 0.4, 0.7, 1.5, 0.25),
            (60, 0.1, 0.9, 0.5, 0.125),
        )
    ],
    mistakes={
        "no_bias": Mistake(
            "the bias plays no part: what softmax gets is Q plus bias, times the scale.",
            {" + bias_table(q, shape)[s]": ""},
        ),
        "no_q": Mistake(
            "Q itself plays no part: what softmax gets is Q plus bias, times the scale.", {"q[s] + bias": "bias"}
        ),
        "no_scale": Mistake("the scale is missing: what softmax gets is scale · (Q + bias).", {"scale * (": "("}),
        "scale_on_q_alone": Mistake(
            "the scale multiplies both, Q and bias: mind the brackets.",
            {"scale * (q[s] + bias_table(q, shape)[s])": "scale * q[s] + bias_table(q, shape)[s]"},
        ),
        "past_the_end": Mistake(
            "the target looks past the end. After a terminated step it is the reward alone.",
            {"r if terminated else": ""},
        ),
        "bias_in_the_target": Mistake(
            "the bias is advice for choosing. It has no place in the target: learn from q as it is.",
            {"max(q[s_next])": "max((q + bias_table(q, shape))[s_next])"},
        ),
        "never_heats": Mistake(
            "the temperature never changes: ask next_temperature after each step.", CHANGED["never_heats"]
        ),
        "nothing_cleared": Mistake(
            "after the end of an episode the robot stands elsewhere: clear the states, the rewards and the "
            "temperature.",
            {"s, states, rewards, temperature = env.reset(), [], [], default": "s = env.reset()"},
        ),
        "remembers_too_long": Mistake(
            "the states are remembered for too long: the last 8 alone.",
            {"[*states, s_next][-8:], [*rewards, r][-8:]": "[*states, s_next], [*rewards, r]"},
        ),
        "remembers_s": Mistake(
            "remembered are the states that are reached: s_next, not s.", {"[*states, s_next]": "[*states, s]"}
        ),
        "default_temperature": Mistake(
            "the temperature is not handed to the draw.", {"draw(x, temperature, u)": "draw(x, default, u)"}
        ),
        "truncated_as_terminated": Mistake(
            "a truncated step has only run out of time: its target keeps γ · max Q(s', ·).",
            {"r if terminated else": "r if terminated or truncated else"},
        ),
        "only_terminated_resets": Mistake(
            "after a truncated episode the world must be reset, too.", {"if terminated or truncated": "if terminated"}
        ),
        "last_rewards_alone": Mistake(
            "all rewards are asked for, one for each u; yours are the last 8.",
            {"return earned, heat": "return rewards, heat"},
        ),
        "temperature_too_late": Mistake(
            "the temperatures are those at which the actions were chosen: note it before it changes.",
            CHANGED["temperature_too_late"],
        ),
        "from_the_default": Mistake(
            "the temperature of the next step comes from the one before: temperature, not default, goes in first.",
            {"next_temperature(temperature,": "next_temperature(default,"},
        ),
    },
    hints=(
        "Write the loop of Q-learning first, choosing with draw(x, temperature, u). Then add what is noted, and the "
        "temperature.",
        "x = scale * (q[s] + bias_table(q, shape)[s]); after the update append s_next and r, keep the last 8 of each, "
        "and ask next_temperature.",
        "At an end: s, states, rewards, temperature = env.reset(), [], [], default.",
    ),
    gained="Choice, learning, memory and escape, and each line of it is yours.",
    witnesses=WITNESSES,
)
