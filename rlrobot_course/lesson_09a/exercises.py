"""Right answers and tapes of lesson 09a; what is asked, hints and mistakes stand on the pages beside."""

from itertools import chain, combinations

from rlrobot_course.grading.parts import Formula, Mistake, Question, with_pages

PAID_OTHERWISE = Formula(
    "Q - weight * (reward - other_reward)", Q=9.98, share=2.99, reward=10, other_reward=-2, weight="share / reward"
)
heats = "ACF"
# what to look at again where a letter is missing, or too many
LOOK = {
    "A": "look at A again: two states among 21 make a redundancy of 10.5.",
    "B": "look at B again: 15 different states among 21 make a redundancy of 21 / 15 = 1.4.",
    "C": "look at C again: one state over and over is a loop, too. Its redundancy is 21.",
    "D": "look at D again: the mean of +10 and −2 is above 0.",
    "E": "look at E again: a mean reward of 0 is not below 0.",
    "F": "and F? The rule sees states and rewards only. It cannot know that waiting is wise.",
}


def _about(letters: str) -> str:
    """The hint for an answer: its first wrong letter, and how many more there are."""
    wrong = [letter for letter in LOOK if (letter in letters) != (letter in heats)]
    more = ("", " (And one more is not right.)", f" (And {len(wrong) - 1} more are not right.)")
    return LOOK[wrong[0]] + more[min(len(wrong) - 1, 2)]


EVERY = ("".join(letters) for letters in chain(*(combinations(LOOK, n) for n in range(1, 7))))

check = with_pages(
    globals(),
    paid_otherwise=Question(PAID_OTHERWISE),
    heats=Question(
        heats,
        mistakes={letters: Mistake(_about(letters), letters) for letters in EVERY if letters != heats},
    ),
)
