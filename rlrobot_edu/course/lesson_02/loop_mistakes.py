"""The typical wrong loops of lesson 02, each an edit of the right function."""

from rlrobot_edu.course.grading.mistake import Mistake

LOOP = "s = env.reset()\n    for _ in range(steps):"
OVERRIDDEN = (
    "the world is reset, but s is not what reset returned. Write s = env.reset(), and let no s = s_next come after it."
)
ASKED_TWICE = "choose is asked twice in a step, and it may answer differently. Ask once, and keep it: a = choose(q, s)."

LEARN = [
    Mistake("after the end of an episode the world must be reset, which gives a new s. An episode ends when it is "
            "terminated or truncated; both at once never come here.",
            {"if terminated or truncated:": "if False:"}),
    Mistake("the next step starts where this one ended: you forgot s = s_next.", {"s = s_next": "pass"}),
    Mistake("truncated only means that time is up: the world goes on, so the target keeps its second part. Hand "
            "terminated alone to update.", {"s_next, terminated)": "s_next, terminated or truncated)"}),
    Mistake("update is told truncated where it should be told terminated.",
            {"s_next, terminated)": "s_next, truncated)"}),
    Mistake("update is told that the step was not terminated, whatever happened. Hand terminated over.",
            {"s_next, terminated)": "s_next, False)"}),
    Mistake("update is told the opposite: hand over terminated, not its contrary.",
            {"s_next, terminated)": "s_next, not terminated)"}),
    Mistake("an episode also ends when it is truncated. Reset then, too.", {" or truncated": ""}),
    Mistake("an episode also ends when it is terminated. Reset then, too.", {"terminated or ": ""}),
    Mistake(OVERRIDDEN, {"            s = env.reset()": "            env.reset()"}),
    Mistake("update is told s_next twice, or s has become s_next before the update. It learns about s, where the "
            "step began: update first, move on afterwards.",
            {"update(": "s = s_next; update("}),
    Mistake("s and s_next have changed places in the call of update.",
            {"update(q, s, a, r, s_next": "update(q, s_next, a, r, s"}),
    Mistake("update is told s for s_next, so it never sees where the step has led.", {"r, s_next,": "r, s,"}),
    Mistake("reset belongs before the loop, and where an episode ends; here every step starts anew.",
            {LOOP: "for _ in range(steps):\n        s = env.reset()"}),
    Mistake("the world is reset after every step. Reset it only where an episode has ended.",
            {"if terminated or truncated:": "if True:"}),
    Mistake("at the end of an episode the loop should go on with a new one until all steps are done.",
            {"truncated:\n            s = env.reset()": "truncated:\n            break"}),
    Mistake("the last step of an episode teaches something, too: update first, then reset.",
            {"update(": "if not (terminated or truncated): update("}),
    Mistake("nothing is learned. In every step, call update, and hand it q itself, not a copy.",
            {"update(": "(lambda *_: None)("}),
    Mistake("all is learned in a copy of q. Change the table that you are given: leave out q.copy().",
            {"s = env.reset()\n    for": "q = q.copy()\n    s = env.reset()\n    for"}),
    Mistake("q is handed over with what has been learned so far. Do not empty it.",
            {"s = env.reset()\n    for": "q[:] = 0\n    s = env.reset()\n    for"}),
    Mistake("the world is reset before the update, so this learns from a state to which the step did not lead. Update "
            "first, then reset.",
            {"        update(": "        s_next = env.reset() if terminated or truncated else s_next\n        update(",
             "            s = env.reset()": "            pass"}),
    Mistake("the loop ends after its first step. Is there a return in it?", {"s = s_next": "return"}),
    Mistake("env.step is given the state. It takes the action a.", {"env.step(a)": "env.step(s)"}),
    Mistake("the next action is chosen before the update, by a table that has not learned from this step. Update "
            "first, then choose. (Lesson 04 is about the other order.)",
            {LOOP: LOOP.replace("\n", "\n    a = choose(q, s)\n"), "        a = choose(q, s)\n": "",
             "        update(": "        b = choose(q, s_next)\n        update(",
             "            s = env.reset()": "            s = env.reset(); b = choose(q, s)\n        a = b"}),
    Mistake("the action is chosen only once, before the loop. In each new state, choose again.",
            {LOOP: LOOP.replace("\n", "\n    a = choose(q, s)\n"), "a = choose(q, s)": "pass"}),
    Mistake(ASKED_TWICE, {"update(q, s, a, r": "update(q, s, choose(q, s), r"}),
    Mistake(ASKED_TWICE, {"env.step(a)": "env.step(choose(q, s))"}),
    Mistake("the action is chosen in the right state, but update is told the first one every time: move s on, too.",
            {"s = env.reset()\n    for": "s = s_next = env.reset()\n    for",
             "a = choose(q, s)": "a = choose(q, s_next)", "        s = s_next\n": "", "            s = env.reset()": "            s_next = env.reset()"}),
    Mistake("the loop ends with the first episode. Go on until all steps are done: for _ in range(steps).",
            {"for _ in range(steps):": "while True:", "            s = env.reset()": "            return"}),
    Mistake("update is called twice in a step. Once is enough.",
            {"update(q, s, a, r, s_next, terminated)":
             "update(q, s, a, r, s_next, terminated); update(q, s, a, r, s_next, terminated)"}),
    Mistake("you take the best action yourself. Which action is taken is for choose to say: a = choose(q, s).",
            {"choose(q, s)": "int(q[s].argmax())"}),
    Mistake("you update the table yourself. What is learned is for update to say: call it in the loop.",
            {"update(q, s, a, r, s_next, terminated)":
             "q[s, a] += 0.1 * (r + (not terminated) * 0.9 * max(q[s_next]) - q[s, a])"}),
    Mistake("this does one step too many.", {"range(steps)": "range(steps + 1)"}),
    Mistake("this does one step too few. range(1, n) leaves out the 0; range(n) has n numbers.",
            {"range(steps)": "range(1, steps)"}),
    Mistake("steps counts steps, not episodes: after that many calls of env.step the loop ends.",
            {"range(steps)": "range(9 * steps)",
             "truncated:\n": "truncated:\n            steps -= 1\n            if not steps: return\n"}),
    Mistake("s and a have changed places in the call of update.", {"update(q, s, a,": "update(q, a, s,"}),
    Mistake("a terminated step teaches the most: its target is the reward alone. Call update in every step.",
            {"update(": "if not terminated: update("}),
    Mistake("the step at which time is up teaches something, too. Call update in every step.",
            {"update(": "if not truncated: update("}),
    Mistake("at the end of an episode the loop should go on with a new one until all steps are done.",
            {"s = s_next\n": "s = s_next\n        if terminated:\n            break\n"}),
    Mistake("only the world knows where a new episode begins: s = env.reset(), not a number of your own.",
            {"            s = env.reset()": "            s = 0"}),
    Mistake("the first line is missing: only s = env.reset() starts the world, and says where the robot is.",
            {"s = env.reset()\n    for": "s = 0\n    for"}),
]  # fmt: skip
