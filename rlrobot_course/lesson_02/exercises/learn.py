"""The loop that learns from a robot's steps."""

from __future__ import annotations

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.shared_hints import RESETS_ONLY_TERMINATED, STAYS
from rlrobot_course.lesson_02.exercises.target import Q
from rlrobot_course.tapes import Fickle, Ranked, TapeWorld, Wavering, q_learner


def learn(env, q, choose, update, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s_next, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s_next, terminated)
        s = s_next
        if terminated or truncated:
            s = env.reset()


OVERRIDDEN = (
    "the world is reset, but s is not what reset returned. Write s = env.reset(), and let no s = s_next come after it."
)

ASKED_TWICE = "choose is asked twice in a step, and it may answer differently. Ask once, and keep it: a = choose(q, s)."

WORLD = TapeWorld()

CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="choose, step, update, and go on from the next state, or from a reset where an episode has ended",
    right=learn,
    memory={"env": TapeWorld(), "q": Q[:4]},
    tape=[
        {"choose": Ranked(rank), "update": q_learner(alpha, gamma), "steps": n}
        for rank, alpha, gamma, n in ((1, 0.1, 0.9, 4), (2, 0.5, 0.7, 2), (0, 0.3, 0.8, 9), (1, 0.25, 0.9, 1))
    ]
    + [{"choose": Wavering(1), "update": q_learner(0.4, 0.9), "steps": 7}]
    + [{"env": WORLD, "choose": Fickle(WORLD), "update": q_learner(0.2, 0.9), "steps": 9}],
    mistakes={
        "never_resets": Mistake(
            "after the end of an episode the world must be reset, which gives a new s. An episode ends when it is "
            "terminated or truncated; both at once never come here.",
            {"if terminated or truncated:": "if False:"},
        ),
        "stays": Mistake(STAYS, {"s = s_next": "pass"}),
        "truncated_as_terminated": Mistake(
            "truncated only means that time is up: the world goes on, so the target keeps its second part. Hand "
            "terminated alone to update.",
            {"s_next, terminated)": "s_next, terminated or truncated)"},
        ),
        "truncated_for_terminated": Mistake(
            "update is told truncated where it should be told terminated.",
            {"s_next, terminated)": "s_next, truncated)"},
        ),
        "never_terminated": Mistake(
            "update is told that the step was not terminated, whatever happened. Hand terminated over.",
            {"s_next, terminated)": "s_next, False)"},
        ),
        "not_terminated": Mistake(
            "update is told the opposite: hand over terminated, not its contrary.",
            {"s_next, terminated)": "s_next, not terminated)"},
        ),
        "resets_only_terminated": Mistake(RESETS_ONLY_TERMINATED, {" or truncated": ""}),
        "resets_only_truncated": Mistake(
            "an episode also ends when it is terminated. Reset then, too.", {"terminated or ": ""}
        ),
        "keeps_s_after_reset": Mistake(OVERRIDDEN, {"            s = env.reset()": "            env.reset()"}),
        "moves_before_update": Mistake(
            "update is told s_next twice, or s has become s_next before the update. It learns about s, where the "
            "step began: update first, move on afterwards.",
            {"update(": "s = s_next; update("},
        ),
        "s_and_s_next_swapped": Mistake(
            "s and s_next have changed places in the call of update.",
            {"update(q, s, a, r, s_next": "update(q, s_next, a, r, s"},
        ),
        "s_for_s_next": Mistake(
            "update is told s for s_next, so it never sees where the step has led.", {"r, s_next,": "r, s,"}
        ),
        "resets_every_step_before": Mistake(
            "reset belongs before the loop, and where an episode ends; here every step starts anew.",
            CHANGED["resets_every_step_before"],
        ),
        "resets_every_step_after": Mistake(
            "the world is reset after every step. Reset it only where an episode has ended.",
            {"if terminated or truncated:": "if True:"},
        ),
        "breaks": Mistake(
            "at the end of an episode the loop should go on with a new one until all steps are done.", CHANGED["breaks"]
        ),
        "no_update_at_the_end": Mistake(
            "the last step of an episode teaches something, too: update first, then reset.",
            {"update(": "if not (terminated or truncated): update("},
        ),
        "never_updates": Mistake(
            "nothing is learned. In every step, call update, and hand it q itself, not a copy.",
            {"update(": "(lambda *_: None)("},
        ),
        "learns_in_a_copy": Mistake(
            "all is learned in a copy of q. Change the table that you are given: leave out q.copy().",
            CHANGED["learns_in_a_copy"],
        ),
        "empties_q": Mistake(
            "q is handed over with what has been learned so far. Do not empty it.", CHANGED["empties_q"]
        ),
        "resets_before_update": Mistake(
            "the world is reset before the update, so this learns from a state to which the step did not lead. Update "
            "first, then reset.",
            CHANGED["resets_before_update"],
        ),
        "one_step": Mistake("the loop ends after its first step. Is there a return in it?", {"s = s_next": "return"}),
        "steps_with_s": Mistake("env.step is given the state. It takes the action a.", {"env.step(a)": "env.step(s)"}),
        "chooses_before_update": Mistake(
            "the next action is chosen before the update, by a table that has not learned from this step. Update "
            "first, then choose. (Lesson 04 is about the other order.)",
            CHANGED["chooses_before_update"],
        ),
        "chooses_once": Mistake(
            "the action is chosen only once, before the loop. In each new state, choose again.", CHANGED["chooses_once"]
        ),
        "order_of_step": Mistake(
            "env.step gives, in this order: next state, reward, terminated, truncated. Yours come in another one.",
            {"s_next, r, terminated, truncated = env": "s_next, terminated, r, truncated = env"},
        ),
        "chooses_once_an_episode": Mistake(
            "the action is chosen once an episode. In each new state, choose again: that belongs to every step.",
            CHANGED["chooses_once_an_episode"],
        ),
        "resets_after_the_loop": Mistake(
            "the reset stands behind the loop, where the steps are over. Move it to the right, into the loop.",
            {"        if terminated": "    if terminated", "            s = env": "        s = env"},
        ),
        "chooses_twice_for_update": Mistake(ASKED_TWICE, {"update(q, s, a, r": "update(q, s, choose(q, s), r"}),
        "chooses_twice_for_step": Mistake(ASKED_TWICE, {"env.step(a)": "env.step(choose(q, s))"}),
        "updates_the_first_state": Mistake(
            "the action is chosen in the right state, but update is told the first one every time: move s on, too.",
            CHANGED["updates_the_first_state"],
        ),
        "one_episode": Mistake(
            "the loop ends with the first episode. Go on until all steps are done: for _ in range(steps).",
            {"for _ in range(steps):": "while True:", "            s = env.reset()": "            return"},
        ),
        "updates_twice": Mistake(
            "update is called twice in a step. Once is enough.",
            {"update(q, s": "for _ in range(2): update(q, s"},
        ),
        "takes_the_best": Mistake(
            "you take the best action yourself. Which action is taken is for choose to say: a = choose(q, s).",
            {"choose(q, s)": "int(q[s].argmax())"},
        ),
        "updates_itself": Mistake(
            "you update the table yourself. What is learned is for update to say: call it in the loop.",
            {
                "update(q, s, a, r, s_next, terminated)": "q[s, a] += 0.1 * "
                "(r + (not terminated) * 0.9 * max(q[s_next]) - q[s, a])"
            },
        ),
        "one_step_too_many": Mistake("this does one step too many.", {"range(steps)": "range(steps + 1)"}),
        "one_step_too_few": Mistake(
            "this does one step too few. range(1, n) leaves out the 0; range(n) has n numbers.",
            {"range(steps)": "range(1, steps)"},
        ),
        "counts_episodes": Mistake(
            "steps counts steps, not episodes: after that many calls of env.step the loop ends.",
            CHANGED["counts_episodes"],
        ),
        "whole_episodes": Mistake(
            "the inner loop runs to the end of the episode, whatever steps says. Count there, too, and stop in time.",
            CHANGED["whole_episodes"],
        ),
        "steps_for_each_value": Mistake(
            "every env.step(a) is a step of the robot. Call it once, and take all four values: s_next, r, terminated, "
            "truncated = env.step(a).",
            {
                "s_next, r, terminated, truncated = env.step(a)": "s_next = env.step(a)[0]; r = env.step(a)[1]; "
                "terminated = env.step(a)[2]; truncated = env.step(a)[3]"
            },
        ),
        "s_and_a_swapped": Mistake(
            "s and a have changed places in the call of update.", {"update(q, s, a,": "update(q, a, s,"}
        ),
        "no_update_when_terminated": Mistake(
            "a terminated step teaches the most: its target is the reward alone. Call update in every step.",
            {"update(": "if not terminated: update("},
        ),
        "no_update_when_truncated": Mistake(
            "the step at which time is up teaches something, too. Call update in every step.",
            {"update(": "if not truncated: update("},
        ),
        "breaks_when_terminated": Mistake(
            "at the end of an episode the loop should go on with a new one until all steps are done.",
            CHANGED["breaks_when_terminated"],
        ),
        "own_start": Mistake(
            "only the world knows where a new episode begins: s = env.reset(), not a number of your own.",
            {"            s = env.reset()": "            s = 0"},
        ),
        "no_first_reset": Mistake(
            "the first line is missing: only s = env.reset() starts the world, and says where the robot is.",
            CHANGED["no_first_reset"],
        ),
    },
    hints=(
        "Before the loop comes one line, and in it four things: choose, step, update, go on.",
        "a = choose(q, s), then s_next, r, terminated, truncated = env.step(a), then update(…). Then s becomes s_next, "
        "or what env.reset() returns.",
        "The last lines of the loop: s = s_next; and below it, if terminated or truncated: s = env.reset().",
    ),
    gained="Update and loop: that is a learning robot. At the end of this lesson it drives, by your code alone.",
    witnesses=WITNESSES,
)
