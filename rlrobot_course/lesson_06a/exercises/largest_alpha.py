"""The largest α at which an accumulating trace does not overshoot."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

largest_alpha = 1 - 0.9 * 0.9

exercise = Question(
    task="the largest α at which accumulating traces cannot overshoot",
    right=largest_alpha,
    because="The trace climbs towards 1/(1 − 0.81) = 5.26, and 1/5.26 = 0.19. "
    "A dutch trace climbs to 1/(1 − (1 − α) · 0.81), and α times that never exceeds 1.",
    mistakes={
        "share_that_stays": Mistake(
            "this is γλ, the share of a trace that one step leaves. How high does a trace climb that gains 1 at "
            "every step and keeps this share?",
            0.81,
        ),
        "highest_trace": Mistake("this is how high the trace climbs. Which α times this gives 1?", 1 / (1 - 0.81)),
        "one_minus_0_9": Mistake("this is 1 − 0.9. But a trace fades by γλ, not by γ or λ alone.", 1 - 0.9),
        "trace_of_1": Mistake("a trace of 1 would allow this. But an accumulating trace climbs above 1.", 1),
        "as_far_off": Mistake(
            "this is where the update overshoots by as much as it was off before. It should not overshoot at all: "
            "α · e ≤ 1.",
            2 * (1 - 0.81),
        ),
        "two_visits": Mistake(
            "this allows for two visits in a row, where the trace is 1.81. With more visits it climbs further.",
            1 / 1.81,
        ),
        "nine_steps": Mistake(
            "4.47 is the trace after nine steps. On a longer drive it climbs further: how high?", 1 / 4.47
        ),
        "faded_trace": Mistake(
            "this is for the trace after it has faded. It overshoots where it is highest: right after a visit.",
            (1 - 0.81) / 0.81,
        ),
        "rounded_5_26": Mistake(
            "nearly: 5.26 is rounded. How high the trace climbs is exactly 1/(1 − 0.81).", 1 / 5.26
        ),
        "rounded_0_2": Mistake("nearly, but with 0.2 it does overshoot after a while. Give a digit more.", 0.2),
        "rounded_5_3": Mistake("nearly: 5.3 is rounded. How high the trace climbs is exactly 1/(1 − 0.81).", 1 / 5.3),
        "gamma_itself": Mistake(
            "this is γ, or λ. How high does a trace climb that gains 1 at every step and keeps the share γλ?", 0.9
        ),
        "upside_down": Mistake(
            "this is 1/(γλ). How high does a trace climb that gains 1 at every step and keeps this share?", 1 / 0.81
        ),
        "before_the_visit": Mistake(
            "this is the trace before the next visit adds its 1. And asked is α: which α times the highest trace is 1?",
            0.81 / 0.19,
        ),
        "eight_steps": Mistake(
            "4.3 is the trace after eight steps. On a longer drive it climbs further: how high?", 1 / 4.3
        ),
        "trace_of_5_3": Mistake("this is, rounded, how high the trace climbs. Which α times this gives 1?", 5.3),
        "trace_of_5_26": Mistake("this is, rounded, how high the trace climbs. Which α times this gives 1?", 5.26),
        "trace_of_5": Mistake("this is, rounded, how high the trace climbs. Which α times this gives 1?", 5),
        "trace_of_0_9": Mistake(
            "so high a trace would climb that keeps 0.9. Ours keeps γλ = 0.81; and asked is α.", 1 / (1 - 0.9)
        ),
        "trace_of_two_visits": Mistake(
            "this is the trace after two visits. How high does it climb in the end, and which α fits that?", 1.81
        ),
        "three_factors": Mistake("γλ is 0.9 · 0.9: two factors, not three.", 1 - 0.9**3),
        "nine_unfaded": Mistake(
            "the trace is not one for each of nine steps: the earlier ones have faded. It climbs to 1/(1 − 0.81).",
            1 / 9,
        ),
        "rounded_0_18": Mistake("nearly. Which number is it exactly? The trace climbs to 1/(1 − 0.81).", 0.18),
        "rounded_0_21": Mistake("nearly, but with 0.21 it does overshoot. The trace climbs to 1/(1 − 0.81).", 0.21),
        "half_of_it": Mistake("this is half of it. Up to α · e = 1 nothing overshoots.", 0.095),
        "nothing": Mistake(
            "with α = 0 nothing would be learned, and nothing need be: a little α is safe. How much?", 0
        ),
        "of_lesson_06": Mistake("with this α the bump of lesson 06 did overshoot: the trace was 4.47 there.", 0.5),
        "of_a_dutch_trace": Mistake(
            "a dutch trace may take any α. The question is about an accumulating one, which climbs by 1 a visit.",
            1 / (1 - 0.5 * 0.81),
        ),
    },
    hints=(
        "The trace climbs until it loses by fading what a visit adds. How high is that?",
        "Right after a visit it is e = γλ · e + 1. Solve this for e; and α · e must not exceed 1.",
        "e = 1/(1 − 0.9 · 0.9), and α is 1 divided by this.",
    ),
    gained="A rule of thumb for every accumulating trace: α at most 1 − γλ. Below, you see robots break it.",
    witnesses={
        "share_that_stays": [0.81],
        "highest_trace": [1 / (1 - 0.81)],
        "one_minus_0_9": [0.1],
        "trace_of_1": [1],
        "two_visits": [1 / 1.81],
        "nine_steps": [1 / 4.47],
        "faded_trace": [1 / 4.263],
        "rounded_5_26": [1 / 5.26],
        "rounded_0_2": [0.2],
        "before_the_visit": [0.81 / 0.19],
        "trace_of_5_26": [5.26],
        "trace_of_5": [5],
        "rounded_0_21": [0.21],
        "form": ["1 - 0.81"],
    },
)
