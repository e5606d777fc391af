"""Exercise of lesson 04: the loop in which SARSA learns."""

from __future__ import annotations

from typing import Any

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.tapes import Q_START, Fickle, TapeWorld, in_order
from rlrobot_edu.course.lesson_04 import solutions

ORDER = ("q", "s", "a", "r", "s_next", "a_next", "terminated")


def update(*arguments: Any) -> None:
    """The update that the loop calls. Raises TypeError for other arguments than those of ORDER."""
    learn_from(*in_order("update", ORDER, arguments))


def learn_from(q: np.ndarray, s: int, a: int, r: float, s_next: int, a_next: int | None, terminated: bool) -> None:
    """SARSA's update."""
    if a_next is None and not terminated:
        raise ValueError("update needs a_next, for the world goes on: only terminated ends it for good")
    q[s, a] += 0.5 * (r + (0.0 if terminated else 0.9 * q[s_next, a_next]) - q[s, a])


WORLD = TapeWorld()

sarsa_learn = Exercise(
    task="choose a' before the update, take that very a' in the next step, choose anew after a reset",
    right=solutions.sarsa_learn,
    # a copy keeps world and chooser together; no value is 0, so that it shows when one is left out of a target
    memory={"env": WORLD, "choose": Fickle(WORLD), "q": Q_START + 0.3},
    # every call stops within an episode, so that it does not matter whether one resets at once or when going on
    tape=[{"update": update, "steps": n} for n in (1, 1, 4, 9, 12)],
    hints=(
        "SARSA holds an action in its hand all the time: the one that it will do next. When is it chosen?",
        "before the loop: a = choose(q, s). In the loop: step, a_next = choose(q, s_next), update, and then "
        "s, a = s_next, a_next. After a reset both s and a are new.",
        "for _ in range(steps): s_next, r, terminated, truncated = env.step(a); a_next = choose(q, s_next); "
        "update(q, s, a, r, s_next, a_next, terminated); s, a = s_next, a_next; if terminated or truncated: …",
    ),
    gained="A whole learning agent, and all of it is yours. It goes to the cliff next, and then into the arena.",
    mistakes=[
        Mistake("you choose twice in the same state: once for the update, then again to act. SARSA takes the very a' "
                "that it learned from: a = a_next.", {"s, a = s_next, a_next": "s, a = s_next, choose(q, s_next)"}),
        Mistake("a' was chosen, but the old action is taken once more. After the update: a = a_next.",
                {"s, a = s_next, a_next": "s = s_next"}),
        Mistake("a' is chosen from s. It will be taken in the next state: choose(q, s_next).",
                {"choose(q, s_next)": "choose(q, s)"}),
        Mistake("a' is chosen before the step, from s. It is done in the next state: first step, then choose.",
                {"s_next, r, terminated, truncated = env.step(a)": "a_next = choose(q, s)",
                 "a_next = choose(q, s_next)": "s_next, r, terminated, truncated = env.step(a)"}),
        Mistake("after a reset the robot is somewhere else: choose a new first action there.",
                {"reset()\n            a = choose(q, s)": "reset()"}),
        Mistake("update is told the action that was just done in place of the next one: hand a_next over.",
                {"a_next, terminated)": "a, terminated)"}),
        Mistake("this learns from the best action of s', as Q-learning does. Learn from the one that choose gave.",
                {"a_next, terminated)": "q[s_next].argmax(), terminated)"}),
        Mistake("truncated only means that time is up: the world goes on, so the target keeps its second part. Hand "
                "terminated alone to update.", {"a_next, terminated)": "a_next, terminated or truncated)"}),
        Mistake("after the end of an episode the world must be reset, which gives a new s.",
                {"if terminated or truncated:": "if False:"}),
        Mistake("an episode also ends when it is truncated. Reset then, too.",
                {"if terminated or truncated:": "if terminated:"}),
        Mistake("the world was reset before the update, so this learns from a state to which the step did not lead. "
                "Update first, then reset.",
                {"env.step(a)": "env.step(a)\n        s_next = env.reset() if terminated or truncated else s_next",
                 "if terminated or truncated:": "if False:"}),
        Mistake("the next step starts where this one ended: you forgot s = s_next.",
                {"s, a = s_next, a_next": "a = a_next"}),
        Mistake("s and a have already moved on when update is called. Update first.",
                {"update(q, s, a, r, s_next, a_next, terminated)\n        s, a = s_next, a_next":
                 "s, a = s_next, a_next\n        update(q, s, a, r, s_next, a_next, terminated)"}),
        Mistake("the new state of the reset is thrown away: write s = env.reset().",
                {"s = env.reset()\n            a": "env.reset()\n            a"}),
        Mistake("steps are counted through all episodes. Your loop stops at the end of the first one.",
                {"s = env.reset()\n            a = choose(q, s)": "break"}),
        Mistake("the last step of an episode teaches, too, and it is often the one with the reward: always update.",
                {"update(q": "terminated or update(q"}),
        Mistake("update must be told whether the episode has ended for good: hand terminated over, not False.",
                {"a_next, terminated)": "a_next, False)"}),
        Mistake("that is truncated. It is terminated that update must be told.",
                {"a_next, terminated)": "a_next, truncated)"}),
        Mistake("s_next and a_next have changed places where update is called.",
                {"s_next, a_next, terminated)": "a_next, s_next, terminated)"}),
        Mistake("the robot goes on from s', but the world is reset at every step here.",
                {"if terminated or truncated:": "if True:"}),
        Mistake("one step too many.", {"range(steps)": "range(steps + 1)"}),
        Mistake("one step is missing.", {"range(steps)": "range(steps - 1)"}),
        Mistake("a' is done at once here. The action of this step is a; a' is for the next one.",
                {"choose(q, s_next)": "choose(q, s_next); env.step(a_next)"}),
        Mistake("nothing is learned: update is never called.",
                {"update(q, s, a, r, s_next, a_next, terminated)": "pass"}),
        Mistake("update is called twice in a step. Once is enough.",
                {"        update(q, s, a, r, s_next, a_next, terminated)":
                 "        update(q, s, a, r, s_next, a_next, terminated)\n"
                 "        update(q, s, a, r, s_next, a_next, terminated)"}),
        Mistake("what update is told as the next state is where the step began: hand s_next over.",
                {"r, s_next, a_next": "r, s, a_next"}),
        Mistake("after a truncated end the world goes on, so update needs a true a' there, too: choose it.",
                {"a_next = choose(q, s_next)": "a_next = 0 if terminated or truncated else choose(q, s_next)"}),
        Mistake("steps counts steps, not episodes. Your loop goes through so many episodes.",
                {"    for _ in range(steps):": "    while steps:",
                 "if terminated or truncated:": "if terminated or truncated:\n            steps -= 1"}),
        Mistake("s and a have changed places: s, a = s_next, a_next.", {"s, a = s_next": "a, s = s_next"}),
        Mistake("what the robot has learned is wiped out when an episode ends. Only the world is reset, not q.",
                {"s = env.reset()\n            a": "q[:] = 0\n            s = env.reset()\n            a"}),
        Mistake("after a reset an action is chosen, but for the old state. First s = env.reset(), then choose(q, s).",
                {"s = env.reset()\n            a = choose(q, s)": "a = choose(q, s)\n            s = env.reset()"}),
        Mistake("what the reset gave is overwritten: s, a = s_next, a_next must come before it, or in an else.",
                {"        s, a = s_next, a_next\n": "",
                 "            a = choose(q, s)": "            a = choose(q, s)\n        s, a = s_next, a_next"}),
        Mistake("the best action is taken as a'. choose decides, and it explores.",
                {"a_next = choose(q, s_next)": "a_next = q[s_next].argmax()"}),
        Mistake("the first action, too, is one that choose gives.",
                {"a = choose(q, s)\n    for": "a = 0\n    for"}),
        Mistake("every step teaches, not only the last one of an episode: always update.",
                {"update(q": "(terminated or truncated) and update(q"}),
        Mistake("a truncated episode teaches with its last step, too: always update.",
                {"update(q": "truncated or update(q"}),
        Mistake("the world must be reset once at the beginning: s = env.reset().",
                {"s = env.reset()\n    a": "s = 0\n    a"}),
        Mistake("update takes the two pairs in the order of time: first s, a, then s_next, a_next.",
                {"s, a, r, s_next, a_next, terminated)": "s_next, a_next, r, s, a, terminated)"}),
        Mistake("the best action is taken each time. choose decides, and it explores.",
                {"choose(q, s)": "q[s].argmax()", "choose(q, s_next)": "q[s_next].argmax()"}),
    ],
)  # fmt: skip
