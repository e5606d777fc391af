"""How much of a fallen value the reward of its last step has paid, computed by hand."""

from __future__ import annotations

from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question

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
    },
)
