"""Right answers of lesson 19; the pages of this folder have the tasks, hints and mistakes."""

from rlrobot_course.exercises.parts import Formula, Question, with_pages

WHO_PAID = Formula(
    "own_rest + by_way_of_B", α=0.5, γ=0.8, r=2, second_reward=20, own="α * r", own_rest="(1 - α) * own",
    in_B="α * γ * own", by_way_of_B="α * γ * in_B",
)  # fmt: skip
BUMP_SHARE = Formula("α * e * r", α=0.5, e=4.473, r=-3)
ONE_STAND = Formula("α * γ * λ * r", α=0.1, γ=0.9, λ=0.9, r=10)

check = with_pages(
    globals(),
    who_paid=Question(WHO_PAID),
    bump_share=Question(BUMP_SHARE),
    one_stand=Question(ONE_STAND),
)
