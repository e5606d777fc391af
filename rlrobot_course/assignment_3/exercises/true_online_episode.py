"""True online TD(λ) over one episode."""

from __future__ import annotations

import numpy as np

from rlrobot_course.assignment_3.given import END, V_NEXT, V_START, on_episodes
from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.shared_hints import FADES_BY_BOTH


def true_online_episode(v, path, rewards, alpha, gamma, lam):
    e, v_old = np.zeros(len(v)), 0
    for t in range(len(rewards)):
        s, s_next = path[t], path[t + 1]
        v_s, v_next = v[s], v[s_next] if t + 1 < len(rewards) else 0
        delta = rewards[t] + gamma * v_next - v_s
        e *= gamma * lam
        e[s] = (1 - alpha) * e[s] + 1
        v += alpha * (delta + v_s - v_old) * e
        v[s] -= alpha * (v_s - v_old)
        v_old = v_next


CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="learn the values of the states from one recorded episode, by true online TD(λ)",
    right=true_online_episode,
    memory={"v": V_START},
    tape=on_episodes(),
    mistakes={
        "past_the_end": Mistake(END, {V_NEXT: "v[s_next]"}),
        "accumulates": Mistake(
            "this is an accumulating trace. The dutch one keeps the share 1 − α of what is left, and adds 1.",
            {"(1 - alpha) * e[s] + 1": "e[s] + 1"},
        ),
        "replaces": Mistake(
            "this is a replacing trace. The dutch one keeps the share 1 − α of what is left, and adds 1.",
            {"(1 - alpha) * e[s] + 1": "1"},
        ),
        "no_second_line": Mistake("the second line is missing: v[s] −= α (V − V_old).", CHANGED["no_second_line"]),
        "delta_alone": Mistake(
            "in the first line stands δ + V − V_old, not δ alone.", {"delta + v_s - v_old": "delta"}
        ),
        "v_after_update": Mistake(
            "V is what s was worth before the update. Keep it in a variable of its own.",
            {"v[s] -= alpha * (v_s - v_old)": "v[s] -= alpha * (v[s] - v_old)"},
        ),
        "next_v_after_update": Mistake(
            "V_old for the next step is V' as it was before the update of this step.", CHANGED["next_v_after_update"]
        ),
        "forgets_v_old": Mistake(
            "V_old must be handed on: at the end of each step it becomes V'.", CHANGED["forgets_v_old"]
        ),
        "v_old_is_v": Mistake("V_old becomes V', the value of the next state, not V.", CHANGED["v_old_is_v"]),
        "no_gamma_in_fading": Mistake(FADES_BY_BOTH, {"gamma * lam": "lam"}),
        "only_s_learns": Mistake(
            "only the visited state changes in the first line. All do, each times its trace: v += α (…) e.",
            {"v += alpha * (delta + v_s - v_old) * e": "v[s] += alpha * (delta + v_s - v_old) * e[s]"},
        ),
        "second_line_for_all": Mistake(
            "the second line is of the visited state alone: v[s], not v.", {"v[s] -= alpha": "v -= alpha"}
        ),
    },
    hints=(
        "The loop is that of td_episode. Three things are new: the dutch trace, the two corrections, and V_old, which "
        "lasts from step to step.",
        "Keep V and V' in variables before v changes. The dutch trace: e[s] = (1 - alpha) * e[s] + 1, after all have "
        "faded.",
        "v += alpha * (delta + v_s - v_old) * e, then v[s] -= alpha * (v_s - v_old), then v_old = v_next.",
    ),
    gained="It does, step by step, exactly what an agent would do that could compute all λ-returns anew in each step.",
    witnesses=WITNESSES,
)
