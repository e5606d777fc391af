"""The loop of Dyna: steps in the world, and between them steps from memory."""

from __future__ import annotations

from typing import Any

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.shared_hints import RESETS_ONLY_TERMINATED, STAYS
from rlrobot_course.tapes import Q_START, TapeWorld, Wavering, q_learner, taken


def dyna(env, q, seen, choose, update, pick, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s_next, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s_next, terminated)
        seen[s, a] = (r, s_next, terminated)
        for pair in pick(seen):
            update(q, *pair, *seen[pair])
        s = s_next
        if terminated or truncated:
            s = env.reset()


class Picker:
    """What the loop calls for the pairs to imagine: n of those that were seen, without chance."""

    def __init__(self, n: int) -> None:
        self.n = n

    def __call__(self, *arguments: Any, **by_name: Any) -> list[tuple[int, int]]:
        """Pairs (s, a), the last by number first. Raises TypeError for anything but a dict with pairs for its keys."""
        return self._pairs(*taken("pick", self._pairs, arguments, by_name))

    def _pairs(self, seen: Any) -> list[tuple[int, int]]:
        if not isinstance(seen, dict):
            raise TypeError("pick takes (seen), the dict alone")
        pairs = sorted(seen, reverse=True)
        if not all(isinstance(pair, tuple) and len(pair) == 2 for pair in pairs):
            raise TypeError("the keys of seen are pairs (s, a)")
        return [pairs[i % len(pairs)] for i in range(self.n)] if pairs else []


CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="make a real step, learn from it, remember it, and learn from what was seen before, for each pair that pick "
    "returns",
    right=dyna,
    memory={"env": TapeWorld(), "q": Q_START, "seen": {}},
    # every call stops within an episode, so that it does not matter whether one resets at once or when going on
    tape=[
        {"choose": Wavering(rank), "update": q_learner(alpha, gamma), "pick": Picker(n), "steps": steps}
        for rank, alpha, gamma, n, steps in (
            (1, 0.5, 0.9, 1, 1),
            (1, 0.5, 0.9, 1, 4),
            (2, 0.3, 0.7, 3, 3),
            (0, 0.2, 0.8, 2, 9),
            (1, 0.25, 0.9, 0, 1),
            (2, 0.4, 0.9, 4, 7),
        )
    ],
    mistakes={
        "no_memory": Mistake(
            "nothing is learned from memory. After each real step, call update once for every pair of pick(seen).",
            CHANGED["no_memory"],
        ),
        "thinks_after_the_loop": Mistake(
            "the robot thinks only when all steps are made. Think after every real step: inside the loop.",
            CHANGED["thinks_after_the_loop"],
        ),
        "steps_as_episodes": Mistake(
            "these are `steps` whole episodes. `steps` counts the real steps of all of them together.",
            CHANGED["steps_as_episodes"],
        ),
        "episode_without_a_limit": Mistake(
            "the inner loop runs to the end of its episode, also where `steps` are used up before. Ask for both.",
            CHANGED["episode_without_a_limit"],
        ),
        "no_real_step": Mistake(
            "nothing is learned from the real step itself. Call update for it, too, before you remember it.",
            CHANGED["no_real_step"],
        ),
        "overwrites_and_jumps": Mistake(
            "the imagined step has overwritten the real one: if both call it s_next, then s = s_next moves the "
            "robot in thought. Give the imagined step names of its own, or hand over *pair and *seen[pair].",
            CHANGED["overwrites_and_jumps"],
        ),
        "overwrites_s_next": Mistake(
            "the imagined step has overwritten s_next, so the robot goes on from where its thoughts were. Give "
            "the imagined step names of its own.",
            CHANGED["overwrites_s_next"],
        ),
        "learns_the_real_again": Mistake(
            "the imagined steps learn from the real step's r, s_next and terminated. What followed the imagined "
            "pair stands in seen[pair].",
            {"*seen[pair]": "r, s_next, terminated"},
        ),
        "real_step_again": Mistake(
            "the real step is repeated, not an imagined one: hand over the pair that pick returned, and what "
            "followed it.",
            {"*pair, *seen[pair]": "s, a, r, s_next, terminated"},
        ),
        "one_pair": Mistake(
            "only the first of the imagined pairs is learned from. Is a break or a return in the loop?",
            CHANGED["one_pair"],
        ),
        "thinks_before_it_remembers": Mistake(
            "the robot thinks before it remembers: the newest pair is not yet in seen when pick is called.",
            CHANGED["thinks_before_it_remembers"],
        ),
        "remembers_before_it_learns": Mistake(
            "the robot remembers before it learns, and thinks in between. First learn from the real step, then think.",
            CHANGED["remembers_before_it_learns"],
        ),
        "thinks_at_the_end": Mistake(
            "thinking only where an episode ends is too late: think after every real step.",
            {"for pair in pick(seen)": "for pair in pick(seen) if terminated or truncated else []"},
        ),
        "keeps_the_first": Mistake(
            "the first thing that followed a pair is kept for ever. Put the newest there: seen[s, a] = (…).",
            {"seen[s, a] = (r, s_next, terminated)": "seen.setdefault((s, a), (r, s_next, terminated))"},
        ),
        "moves_before_it_remembers": Mistake(
            "it is s, a that is remembered, where the step began: remember before s becomes s_next.",
            CHANGED["moves_before_it_remembers"],
        ),
        "swapped_in_seen": Mistake(
            "r and s_next have changed places in seen. The order is (r, s_next, terminated), as update wants it.",
            {
                "= (r, s_next, terminated)": "= (s_next, r, terminated)",
                "*seen[pair]": "seen[pair][1], seen[pair][0], seen[pair][2]",
            },
        ),
        "truncated_as_terminated": Mistake(
            "truncated only means that time is up. What update needs to know, and seen to remember, is terminated.",
            {"= (r, s_next, terminated)": "= (r, s_next, terminated or truncated)"},
        ),
        "update_with_truncated": Mistake(
            "truncated only means that time is up. What update needs to know after the real step is terminated.",
            {"update(q, s, a, r, s_next, terminated)": "update(q, s, a, r, s_next, terminated or truncated)"},
        ),
        "never_terminated": Mistake(
            "an imagined step can end an episode as well: hand terminated over, which stands in seen[pair].",
            {"*seen[pair]": "*seen[pair][:2], False"},
        ),
        "stays": Mistake(STAYS, CHANGED["stays"]),
        "never_resets": Mistake(
            "the world is never reset. Where an episode has ended, terminated or truncated: s = env.reset().",
            {"if terminated or truncated:": "if False:"},
        ),
        "resets_only_terminated": Mistake(RESETS_ONLY_TERMINATED, {" or truncated": ""}),
        "chooses_before_it_thinks": Mistake(
            "update first, then choose: here the next action is chosen before the robot has thought.",
            CHANGED["chooses_before_it_thinks"],
        ),
        "forgets_seen": Mistake(
            "seen begins empty in every call. Use the one that you are given, which may hold pairs already.",
            CHANGED["forgets_seen"],
        ),
        "return_in_the_loop": Mistake(
            "the loop ends after its first step. Is there a return in it?", CHANGED["return_in_the_loop"]
        ),
        "acts_in_thought": Mistake(
            "what is imagined is done in the real world: env.step is for real steps alone. In thought, seen[pair] "
            "says what comes.",
            CHANGED["acts_in_thought"],
        ),
    },
    hints=(
        "It is the loop of lesson 02 with two things more after its update: remember the step, then go through "
        "pick(seen).",
        "seen[s, a] = (r, s_next, terminated) remembers. Then: for pair in pick(seen), and inside it one more update.",
        "for pair in pick(seen): update(q, *pair, *seen[pair]). Then s = s_next, or s = env.reset() after an end.",
    ),
    gained="This is Dyna-Q. One more line than Q-learning remembers, two more think.",
    witnesses=WITNESSES,
)
