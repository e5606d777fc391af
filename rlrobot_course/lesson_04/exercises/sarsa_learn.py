"""The loop of SARSA."""

from __future__ import annotations

from typing import Any

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.shared_hints import RESETS_ONLY_TERMINATED, STAYS
from rlrobot_course.tapes import Q_START, Fickle, TapeWorld, in_order


def sarsa_learn(env, q, choose, update, steps):
    s = env.reset()
    a = choose(q, s)
    for _ in range(steps):
        s_next, r, terminated, truncated = env.step(a)
        a_next = choose(q, s_next)
        update(q, s, a, r, s_next, a_next, terminated)
        s, a = s_next, a_next
        if terminated or truncated:
            s = env.reset()
            a = choose(q, s)


def update(*arguments: Any, **by_name: Any) -> None:
    """The update that the loop calls. Raises TypeError for other arguments than those of `learn_from`."""
    learn_from(*in_order("update", learn_from, arguments, by_name))


def learn_from(q: np.ndarray, s: int, a: int, r: float, s_next: int, a_next: int | None, terminated: bool) -> None:
    """SARSA's update."""
    if a_next is None and not terminated:
        raise ValueError("update needs a_next, for the world goes on: only terminated ends it for good")
    q[s, a] += 0.5 * (r + (0.0 if terminated else 0.9 * q[s_next, a_next]) - q[s, a])


WORLD = TapeWorld()

CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="choose a' before the update, take that very a' in the next step, choose anew after a reset",
    right=sarsa_learn,
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
    mistakes={
        "chooses_twice": Mistake(
            "you choose twice in the same state: once for the update, then again to act. SARSA takes the very a' "
            "that it learned from: a = a_next.",
            {"s, a = s_next, a_next": "s, a = s_next, choose(q, s_next)"},
        ),
        "keeps_a": Mistake(
            "a' was chosen, but the old action is taken once more. After the update: a = a_next.",
            {"s, a = s_next, a_next": "s = s_next"},
        ),
        "chooses_from_s": Mistake(
            "a' is chosen from s. It will be taken in the next state: choose(q, s_next).",
            {"choose(q, s_next)": "choose(q, s)"},
        ),
        "chooses_before_the_step": Mistake(
            "a' is chosen before the step, from s. It is done in the next state: first step, then choose.",
            {
                "s_next, r, terminated, truncated = env.step(a)": "a_next = choose(q, s)",
                "a_next = choose(q, s_next)": "s_next, r, terminated, truncated = env.step(a)",
            },
        ),
        "keeps_a_after_reset": Mistake(
            "after a reset the robot is somewhere else: choose a new first action there.",
            CHANGED["keeps_a_after_reset"],
        ),
        "hands_over_a": Mistake(
            "update is told the action that was just done in place of the next one: hand a_next over.",
            {"a_next, terminated)": "a, terminated)"},
        ),
        "q_learning": Mistake(
            "this learns from the best action of s', as Q-learning does. Learn from the one that choose gave.",
            {"a_next, terminated)": "q[s_next].argmax(), terminated)"},
        ),
        "truncated_as_terminated": Mistake(
            "truncated only means that time is up: the world goes on, so the target keeps its second part. Hand "
            "terminated alone to update.",
            {"a_next, terminated)": "a_next, terminated or truncated)"},
        ),
        "never_resets": Mistake(
            "after the end of an episode the world must be reset, which gives a new s.",
            {"if terminated or truncated:": "if False:"},
        ),
        "resets_only_terminated": Mistake(
            RESETS_ONLY_TERMINATED,
            {"if terminated or truncated:": "if terminated:"},
        ),
        "resets_before_update": Mistake(
            "the world was reset before the update, so this learns from a state to which the step did not lead. "
            "Update first, then reset.",
            CHANGED["resets_before_update"],
        ),
        "stays": Mistake(STAYS, {"s, a = s_next, a_next": "a = a_next"}),
        "moves_before_update": Mistake(
            "s and a have already moved on when update is called. Update first.", CHANGED["moves_before_update"]
        ),
        "throws_the_reset_away": Mistake(
            "the new state of the reset is thrown away: write s = env.reset().", CHANGED["throws_the_reset_away"]
        ),
        "one_episode": Mistake(
            "steps are counted through all episodes. Your loop stops at the end of the first one.",
            CHANGED["one_episode"],
        ),
        "no_update_at_the_end": Mistake(
            "the last step of an episode teaches, too, and it is often the one with the reward: always update.",
            {"update(q": "terminated or update(q"},
        ),
        "no_update_at_any_end": Mistake(
            "the last step of an episode is skipped, and it teaches, too: update first, then reset.",
            CHANGED["no_update_at_any_end"],
        ),
        "so_many_episodes": Mistake(
            "steps counts steps, not episodes. Your loop goes through so many episodes.", CHANGED["so_many_episodes"]
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
        "never_terminated": Mistake(
            "update must be told whether the episode has ended for good: hand terminated over, not False.",
            {"a_next, terminated)": "a_next, False)"},
        ),
        "truncated_for_terminated": Mistake(
            "that is truncated. It is terminated that update must be told.",
            {"a_next, terminated)": "a_next, truncated)"},
        ),
        "next_pair_swapped": Mistake(
            "s_next and a_next have changed places where update is called.",
            {"s_next, a_next, terminated)": "a_next, s_next, terminated)"},
        ),
        "resets_every_step": Mistake(
            "the robot goes on from s', but the world is reset at every step here.",
            {"if terminated or truncated:": "if True:"},
        ),
        "one_step_too_many": Mistake("one step too many.", {"range(steps)": "range(steps + 1)"}),
        "one_step_too_few": Mistake("one step is missing.", {"range(steps)": "range(steps - 1)"}),
        "acts_twice": Mistake(
            "a' is done at once here. The action of this step is a; a' is for the next one.",
            {"choose(q, s_next)": "choose(q, s_next); env.step(a_next)"},
        ),
        "never_updates": Mistake(
            "nothing is learned: update is never called.", {"update(q, s, a, r, s_next, a_next, terminated)": "pass"}
        ),
        "updates_twice": Mistake("update is called twice in a step. Once is enough.", CHANGED["updates_twice"]),
        "s_for_s_next": Mistake(
            "what update is told as the next state is where the step began: hand s_next over.",
            {"r, s_next, a_next": "r, s, a_next"},
        ),
        "no_choice_at_the_end": Mistake(
            "after a truncated end the world goes on, so update needs a true a' there, too: choose it.",
            {"a_next = choose(q, s_next)": "a_next = 0 if terminated or truncated else choose(q, s_next)"},
        ),
        "counts_episodes": Mistake(
            "steps counts steps, not episodes. Your loop goes through so many episodes.", CHANGED["counts_episodes"]
        ),
        "s_and_a_swapped": Mistake(
            "s and a have changed places: s, a = s_next, a_next.", {"s, a = s_next": "a, s = s_next"}
        ),
        "empties_q": Mistake(
            "what the robot has learned is wiped out when an episode ends. Only the world is reset, not q.",
            CHANGED["empties_q"],
        ),
        "chooses_for_the_old_state": Mistake(
            "after a reset an action is chosen, but for the old state. First s = env.reset(), then choose(q, s).",
            CHANGED["chooses_for_the_old_state"],
        ),
        "overwrites_the_reset": Mistake(
            "what the reset gave is overwritten: s, a = s_next, a_next must come before it, or in an else.",
            CHANGED["overwrites_the_reset"],
        ),
        "best_as_a_next": Mistake(
            "the best action is taken as a'. choose decides, and it explores.",
            {"a_next = choose(q, s_next)": "a_next = q[s_next].argmax()"},
        ),
        "own_first_action": Mistake("the first action, too, is one that choose gives.", CHANGED["own_first_action"]),
        "updates_at_the_end_alone": Mistake(
            "every step teaches, not only the last one of an episode: always update.",
            {"update(q": "(terminated or truncated) and update(q"},
        ),
        "no_update_when_truncated": Mistake(
            "a truncated episode teaches with its last step, too: always update.", {"update(q": "truncated or update(q"}
        ),
        "no_first_reset": Mistake(
            "the world must be reset once at the beginning: s = env.reset().", CHANGED["no_first_reset"]
        ),
        "pairs_swapped": Mistake(
            "update takes the two pairs in the order of time: first s, a, then s_next, a_next.",
            {"s, a, r, s_next, a_next, terminated)": "s_next, a_next, r, s, a, terminated)"},
        ),
        "always_the_best": Mistake(
            "the best action is taken each time. choose decides, and it explores.",
            {"choose(q, s)": "q[s].argmax()", "choose(q, s_next)": "q[s_next].argmax()"},
        ),
    },
    witnesses=WITNESSES,
)
