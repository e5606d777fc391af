"""How much of a fallen value the reward of its last step has paid, computed by hand."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

bump_share = 0.5 * 4.47 * -2

exercise = Question(
    task="what the bump's own reward has paid of Q(open, ahead)",
    right=bump_share,
    because="The newest reward counts α · e times, here 2.235 times: −4.47 of −94.6.",
    mistakes={
        "weight": Mistake("this is its weight, α · e. Its share is the weight times the reward, −2.", 2.235),
        "upwards": Mistake("the reward is −2: it lowers the value.", 4.47),
        "no_trace": Mistake("the pair learns α · δ · e, and r is a part of δ. The trace is missing.", -1.0),
        "no_alpha": Mistake("the pair learns α · δ · e, and r is a part of δ. α is missing.", -8.94),
        "reward": Mistake("this is the reward. It enters δ, and Q learns α · δ · e.", -2.0),
        "whole_change": Mistake("this is what all of δ does, −74.9. Only −2 of it is this reward.", -167.4015),
        "whole_change_rounded": Mistake("this is what all of δ does, −74.9. Only −2 of it is this reward.", -167.0),
        "delta": Mistake("this is the whole δ. Only −2 of it is this reward, and Q learns α · δ · e.", -74.9),
        "the_tens": Mistake("this is what the tens have paid, all together. Asked is the bump's own part.", -90.1),
        "the_tens_rounded": Mistake("this is what the tens have paid, all together. Asked is the bump's part.", -90.0),
        "weight_rounded": Mistake("this is its weight, α · e. Its share is the weight times the reward, −2.", 2.24),
        **{
            name: Mistake("this is a share. Asked are points, a number of the same unit as −94.6.", value)
            for name, value in (("per_cent", 4.7), ("per_cent_to_5", 5), ("share", 0.047), ("share_to_5", 0.05),
                                ("per_cent_in_full", 447 / 94.6), ("share_in_full", 4.47 / 94.6))
        },
    },
    hints=(
        "Q(open, ahead) changes by α · δ · e, and δ = r + γ · Q(s', a') − Q(s, a). Which part of it is r's?",
        "α · e · r, with the trace at the bump, 4.47.",
        "0.5 · 4.47 · (−2)",
    ),
    gained="The weight of the newest reward is always α · e; above 1 it counts more than once.",
    witnesses={
        "weight": [0.5 * 4.47],
        "upwards": [4.47],
        "no_trace": [-1],
        "no_alpha": [4.47 * -2],
        "whole_change": [0.5 * -74.9 * 4.47],
        "whole_change_rounded": [-167],
        "delta": [-74.9],
        "the_tens_rounded": [-90],
        "weight_rounded": [2.24],
        "per_cent": [4.7],
        "share": [0.047],
    },
)  # fmt: skip
