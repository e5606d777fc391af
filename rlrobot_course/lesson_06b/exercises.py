"""Right answers and tapes of lesson 06b; what is asked, hints and mistakes stand on the pages beside."""

from rlrobot_course.grading.parts import Formula, Mistake, Question, with_pages

check = with_pages(
    globals(),
    bump_share=Question(
        Formula("α * e * r", α=0.5, e=4.47, r=-2, Q=-94.6),
        mistakes={
            "weight": Mistake("this is its weight, α · e. Its share is the weight times the reward, −2.", 2.235),
            "reward": Mistake("this is the reward. It enters δ, and Q learns α · δ · e.", -2.0),
            "whole_change": Mistake("this is what all of δ does, −74.9. Only −2 of it is this reward.", -167.4015),
            "whole_change_rounded": Mistake("this is what all of δ does, −74.9. Only −2 of it is this reward.", -167.0),
            "delta": Mistake("this is the whole δ. Only −2 of it is this reward, and Q learns α · δ · e.", -74.9),
            "the_tens": Mistake("this is what the tens have paid, all together. Asked is the bump's own part.", -90.1),
            "the_tens_rounded": Mistake(
                "this is what the tens have paid, all together. Asked is the bump's part.", -90.0
            ),
            "weight_rounded": Mistake("this is its weight, α · e. Its share is the weight times the reward, −2.", 2.24),
            **{
                name: Mistake("this is a share. Asked are points, a number of the same unit as −94.6.", value)
                for name, value in (
                    ("per_cent", 4.7),
                    ("per_cent_to_5", 5),
                    ("share", 0.047),
                    ("share_to_5", 0.05),
                    ("per_cent_in_full", 447 / 94.6),
                    ("share_in_full", 4.47 / 94.6),
                )
            },
        },
    ),
)
