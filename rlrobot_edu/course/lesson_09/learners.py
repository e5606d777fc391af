"""Exercises of lesson 09: the learners, which are let loose on a robot and in rings of states."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.tapes import RobotWorld
from rlrobot_edu.course.lesson_09 import solutions
from rlrobot_edu.course.lesson_09.worlds import Dice, Ring
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import learn as run
from rlrobot_edu.learning.size import Size

LENDERS = {
    name: f"your function of lesson {lesson}. The cell of section 1 takes it from there: run that first"
    for lesson, names in {"03": ("softmax", "draw"), "06": ("true_online_update",), "07": ("bias",),
                          "08": ("new_temperature",)}.items()
    for name in names
}  # fmt: skip
ABOVE = {name: "the function of an exercise above: write it, and run its cell" for name in ("preferences", "choose")}

Ends = tuple[tuple[int, bool], ...]  # of episodes: after how many steps, and whether they terminate
ENDS: Ends = ((5, True), (4, False), (6, False), (3, True))
USUAL = {"alpha": 0.1, "gamma": 0.9, "lam": 0.9}
OTHERS = {"alpha": 0.3, "gamma": 0.8, "lam": 0.6, "n_actions": 4, "r_max": 2.0}


def library(
    env: RobotWorld | Ring,
    shape: tuple[int, ...],
    n_actions: int,
    r_max: float,
    steps: int,
    rng: Any,
    alpha: float,
    gamma: float,
    lam: float,
    temperature: float,
    loop_evasion: bool = False,
) -> np.ndarray:
    """The library's agent in the learner's world: what a right answer equals, number for number."""
    if isinstance(env, Ring):  # none of the library's
        right = solutions.learn_and_evade if loop_evasion else solutions.learn
        return right(env, shape, n_actions, r_max, steps, rng, alpha, gamma, lam, temperature)
    about = {"alpha": alpha, "gamma": gamma, "lam": lam, "temperature": temperature, "traces": "full"}
    agent = Agent(Size(shape, n_actions, r_max), "TOSL+QBIASSR", loop_evasion=loop_evasion, **about)
    agent.rng = rng
    run(agent, env.env, steps, progress=False)
    return agent.q


def drives(rings: list[dict[str, Any]], temperature: str) -> list[dict[str, Any]]:
    """The first ring, the robot of the worked example, the other rings. temperature: what this argument is called."""
    robot = RobotWorld("worked_example", seed=0)
    about = {"env": robot, "shape": robot.shape, "n_actions": robot.n_actions, "r_max": robot.r_max}
    robots = [
        {**about, "steps": n, "rng": np.random.default_rng(seed), **USUAL, temperature: 1.0}
        for n, seed in ((1, 0), (5, 1), (45, 2))
    ]
    return [rings[0], *robots, *rings[1:]]


def ring(shape: tuple[int, ...], ends: Ends, n: int, sticky: int = 1, **rest: float) -> dict[str, Any]:
    """The arguments of a learner that is let loose in a ring for n steps, with 3 actions and an r_max of 6 if not told.

    rest: the other arguments, by name
    """
    about = {"n_actions": 3, "r_max": 6.0, **rest}
    world = Ring(int(np.prod(shape)), ends, sticky, about["r_max"])
    return {"env": world, "shape": shape, "steps": n, "rng": Dice(world), **about}


UPDATE = "q_old = true_online_update(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam)"
CHOOSE = "choose(q, shape, s, temperature, r_max, gamma, rng.random())"
AGAIN = "            s = env.reset()\n            a = act(s)\n"  # of a new episode
ON = "s, a = s_next, a_next"
EMPTIED = "e[:], q_old = 0.0, 0.0"

# of both learners: {what is written differently: hint}
COMMON = [
    Mistake("the actions are chosen without the bias.",
            {CHOOSE: "draw(softmax(q[s] * 100 * (1 - gamma) / r_max, temperature), rng.random())"}),
    Mistake("the action a' that you learned from must be the one that is taken next. Here another one is drawn "
            "for the step, so two numbers are drawn where there should be one.", {ON: "s, a = s_next, act(s_next)"}),
    Mistake("a' must be chosen before the update, which learns from it; here it learns from the best action.",
            {"a_next = act(s_next)": "a_next = q[s_next].argmax()", ON: "s, a = s_next, act(s_next)"}),
    Mistake("as a new episode starts, the traces and Q_old start afresh: e is 0 and Q_old is 0.", {EMPTIED: "pass"}),
    Mistake("as a new episode starts, the traces start afresh: e is 0.", {EMPTIED: "q_old = 0.0"}),
    Mistake("after a reset the robot stands elsewhere: the action that it still holds was meant for another "
            "state. Choose a new one.", {"reset()\n            a = act(s)": "reset()"}),
    Mistake("the world itself must be reset when an episode has ended: s = env.reset().",
            {AGAIN: "            a = act(s)\n"}),
    Mistake("env.reset() tells the first state of the new episode: s = env.reset().",
            {AGAIN: "            env.reset()\n            a = act(s)\n"}),
    Mistake("Q_old stays at 0 here. Your true_online_update returns the new one: keep it until the episode has ended.",
            {"q_old = true_online_update": "true_online_update"}),
    Mistake("where an episode has ended, reset the world, and choose an action for its first state.",
            {"if terminated or truncated": "if False"}),
    Mistake("an episode ends in two ways: terminated, or truncated. In both a new one starts.",
            {"if terminated or truncated": "if terminated"}),
    Mistake("an episode ends in two ways: truncated, or terminated. In both a new one starts.",
            {"if terminated or truncated": "if truncated"}),
    Mistake("a truncated episode has only run out of time: the value of s' still counts. The update gets terminated "
            "alone.", {"a_next, terminated, alpha": "a_next, terminated or truncated, alpha"}),
    Mistake("where an episode has terminated nothing comes after it: the update must be told, with terminated.",
            {"a_next, terminated, alpha": "a_next, False, alpha"}),
    Mistake("the update is told terminated, not truncated: where an episode has only run out of time, the value of s' "
            "still counts.", {"a_next, terminated, alpha": "a_next, truncated, alpha"}),
    Mistake("no traces are at work: this is SARSA. Is true_online_update called, and are the traces emptied only where "
            "an episode has ended?",
            {UPDATE: "q[s, a] += alpha * (r + gamma * (not terminated) * q[s_next, a_next] - q[s, a])"}),
    Mistake("this is Q-learning, without traces. Learn with your true_online_update, from the a' that is taken.",
            {UPDATE: "q[s, a] += alpha * (r + gamma * (not terminated) * q[s_next].max() - q[s, a])"}),
    Mistake("nothing is learned: true_online_update is missing.", {UPDATE: "pass"}),
    Mistake("a' is chosen in s', the state that the step led to, not in s.", {"act(s_next)": "act(s)"}),
    Mistake("at the end of a step, s' becomes s.", {ON: "a = a_next"}),
    Mistake("at the end of a step, a' becomes a.", {ON: "s = s_next"}),
    Mistake("at the end of a step, s' becomes s and a' becomes a.", {ON: "pass"}),
    Mistake("s and a were overwritten before the update, which still needs the old ones.",
            {UPDATE: f"{ON}\n        {UPDATE}"}),
    Mistake("the update learns from s', s_next, not from s.", {"s_next, a_next, terminated": "s, a_next, terminated"}),
    Mistake("the update learns from a', a_next, not from a.", {"s_next, a_next, terminated": "s_next, a, terminated"}),
    Mistake("alpha and gamma have changed places in the call of true_online_update.",
            {"alpha, gamma, lam)": "gamma, alpha, lam)"}),
    Mistake("gamma and lam have changed places in the call of true_online_update.",
            {"alpha, gamma, lam)": "alpha, lam, gamma)"}),
    Mistake("r_max and gamma have changed places in the call of choose.", {"r_max, gamma, rng": "gamma, r_max, rng"}),
    Mistake("γ is the argument gamma, not always 0.9.", {"gamma, lam)": "0.9, lam)"}),
    Mistake("a new episode starts only where one has ended. Is the if turned round, or always true?",
            {"if terminated or truncated": "if not (terminated or truncated)"}),
    Mistake("there is one step too few.", {"range(steps)": "range(steps - 1)"}),
    Mistake("there is one step too many.", {"range(steps)": "range(steps + 1)"}),
    Mistake("the loop ends with the first episode. It should go on until all steps are done.", {EMPTIED: "break"}),
    Mistake("what has been learned in an episode must stay: it is e and Q_old that start afresh, not q.",
            {EMPTIED: f"{EMPTIED}\n            q[:] = 0.0"}),
    Mistake("all Q start at 0.", {"q = np.zeros": "q = np.ones"}),
    Mistake("the first action is chosen like all others.", {"a = act(s)\n    for": "a = 0\n    for"}),
    Mistake("the actions are chosen by chance alone. Call your choose.", {CHOOSE: "int(rng.random() * n_actions)"}),
    Mistake("the best action is not always taken. Call your choose.",
            {CHOOSE: "int(preferences(q, shape, s, r_max, gamma).argmax())"}),
    Mistake("the preferences are not normalised where you choose. Call your choose.",
            {CHOOSE: "draw(softmax(q[s] + bias(q, shape, s), temperature), rng.random())"}),
    Mistake("a' is chosen in every step, also in the last one of an episode that was truncated: the update learns "
            "from it.", {"a_next = act(s_next)": "a_next = a if terminated or truncated else act(s_next)"}),
    Mistake("the traces are not what is asked: return q.", {"return q": "return e"}),
    Mistake("return q alone.", {"return q": "return q, e"}),
    Mistake("e and q are one table here under two names, so each change of one is a change of the other. Make a table "
            "of its own: np.zeros_like(q).", {"np.zeros_like(q)": "q"}),
    Mistake("all traces start at 0, too: nobody has been visited yet.", {"np.zeros_like(q)": "np.ones_like(q)"}),
    Mistake("return stands inside the loop, so it ends with the first step.", {ON: f"{ON}\n        return q"}),
    Mistake("the world is reset after every step. A new episode starts only where one has ended.",
            {ON: "s, a = env.reset(), a_next"}),
    Mistake("the action that is done must be the one that was learned about, a. Here another is drawn for the world.",
            {"env.step(a)": "env.step(act(s))"}),
    Mistake("Rmax is the argument r_max, not always 10.", {"r_max, gamma, rng": "10, gamma, rng"}),
    Mistake("the number of actions is the argument n_actions, not always 3.", {"n_actions": "3"}),
]  # fmt: skip

HINTS = (
    "The box above has a line of code for nearly each of its own. The first choice comes before the loop.",
    "In the loop: env.step, choose for s_next, q_old = true_online_update(…), then s, a = s_next, a_next.",
    "At the end of the loop: if terminated or truncated: e[:], q_old = 0.0, 0.0; s = env.reset(); a = choose(q, …).",
)

learn = Exercise(
    task="let TOSL+QBIASSR learn for a number of steps, and return q",
    right=solutions.learn,
    library=library,
    returns="q",
    lenders=LENDERS | ABOVE,
    tape=drives(
        [
            ring((3, 4), ENDS, 10, **USUAL, temperature=1.0),
            ring((4, 5), ENDS[::-1], 80, **OTHERS, temperature=4.0),
        ],
        "temperature",
    ),
    mistakes=COMMON,
    hints=HINTS,
    gained="This is the method of the paper, in twenty lines of your own. Now let it drive.",
)

BEGIN = "            states, rewards, temperature = [], [], default\n"

learn_and_evade = Exercise(
    task="let TOSL+QBIASSR with loop evasion learn for a number of steps, and return q",
    right=solutions.learn_and_evade,
    library=partial(library, loop_evasion=True),
    returns="q",
    lenders=LENDERS | ABOVE | {"push": "not needed here: [*states, s_next][-length:] does it"},
    tape=drives([ring((3, 4), ENDS, 10, **USUAL, default=1.0),
                 ring((4, 5), ((11, False), (9, True)), 34, 6, **OTHERS, default=0.02),
                 ring((10, 12), ((50, False),), 66, 12, **USUAL, default=0.02)], "default"),
    mistakes=[
        Mistake("this is learning without loop evasion. Is the temperature changed before a' is chosen?",
                {"if len(states) == length": "if False"}),
        Mistake("the temperature never falls. When there is no loop, it goes back to its default at once.",
                {"s_next, default)": "s_next, temperature)"}),
        Mistake("as a new episode starts, the queue starts afresh, and so does the temperature.", {BEGIN: ""}),
        Mistake("as a new episode starts, the temperature is back at its default, too.",
                {BEGIN: "            states, rewards = [], []\n"}),
        Mistake("as a new episode starts, the queues are empty again, too.",
                {BEGIN: "            temperature = default\n"}),
        Mistake("the queue has as many places as there are traces, 21, but at most a quarter of the states.",
                {"max(4, min(21, len(q) // 4))": "21"}),
        Mistake("the queue has a quarter of the number of states as places, but never more than 21.",
                {"max(4, min(21, len(q) // 4))": "max(4, len(q) // 4)"}),
        Mistake("a queue that is not full yet says nothing: keep the temperature at its default until it is.",
                {"if len(states) == length": "if True"}),
        Mistake("what goes into the queue is the state that the step led to, s', with the reward it brought.",
                {"[*states, s_next]": "[*states, s]"}),
        Mistake("new_temperature asks about s', which has just been pushed, not about s.",
                {"rewards, s_next, default": "rewards, s, default"}),
        Mistake("the queues grow without end. Keep the latest: [-length:].", {"[-length:]": ""}),
        Mistake("the temperature rises from where it is, not from the default: keep what new_temperature returns.",
                {"new_temperature(temperature": "new_temperature(default"}),
        *COMMON,
    ],
    hints=(
        "Three lines come on top of your learn: before the loop, after env.step, and where an episode ends.",
        "After env.step: both queues take what has come, and if they are full, temperature = new_temperature(…).",
        "if len(states) == length: temperature = new_temperature(temperature, states, rewards, s_next, default)",
    ),
    gained="Nothing is missing now: what you have written is what rl.Agent does when you say nothing else.",
)  # fmt: skip
