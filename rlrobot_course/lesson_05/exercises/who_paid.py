"""How much of a value one reward has paid, computed by hand."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

who_paid = 0.5 * 0.5 * 2 + 0.5 * 0.8 * (0.5 * 0.8 * 0.5 * 2)

exercise = Question(
    task="what the first reward has paid of Q(A)",
    right=who_paid,
    because="Q(A) = 2.16: 0.66 of it is the first reward's, 2 the second's, and −0.5 the third's.",
    mistakes={
        "own_visit_alone": Mistake(
            "this is what is left of its own update. A part of it also came back by way of Q(B).", 0.5
        ),
        "by_way_of_b_alone": Mistake(
            "this is what came back by way of Q(B). Of the first update of Q(A) a half is left, too.", 0.16
        ),
        "first_update": Mistake(
            "this is its share after the first step. In the third step Q(A) is updated again.", 1.0
        ),
        "nothing_shrinks": Mistake(
            "the second update of Q(A) keeps only the share 1 − α of what was there before.", 1.16
        ),
        "all": Mistake("this is the whole of Q(A). Two more rewards have paid for it.", 2.16),
        "weight": Mistake("this is its weight: so much a reward of 1 would have paid. This one is 2.", 0.33),
        "not_hers": Mistake("this is the second reward's share, or the first reward as it was paid.", 2.0),
        "third": Mistake("this is the third reward's share.", -0.5),
        "no_gamma": Mistake("what comes by way of Q(B) is discounted by γ each time it is handed on.", 0.75),
        "gamma_once": Mistake("γ counts twice: in the update of Q(B), and in the second one of Q(A).", 0.7),
    },
    hints=(
        "Write down for each update which part of the new number comes from which reward.",
        "After step 2, Q(B) = 0.5 · (10 + 0.8 · 1). How much of it is the first reward's?",
        "In step 3, Q(A) keeps half of its 1, and takes 0.5 · 0.8 of the 0.4 that is in Q(B).",
    ),
    gained="`rl.credit` does this for each reward and each value.",
    witnesses={
        "own_visit_alone": [0.5],
        "by_way_of_b_alone": [0.4 * 0.4],
        "first_update": [1],
        "nothing_shrinks": [1.16],
        "all": [0.5 + 0.5 * (-1 + 0.8 * 5.4)],
        "weight": [0.33],
        "no_gamma": [0.5 + 0.5 * 0.5],
        "gamma_once": [0.5 + 0.5 * 0.4],
    },
)
