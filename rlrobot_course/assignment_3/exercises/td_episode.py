"""TD(λ) over one episode."""

from __future__ import annotations

import numpy as np

from rlrobot_course.assignment_3.exercises.trace_after import trace_after
from rlrobot_course.assignment_3.given import END, KIND, KINDS, V_NEXT, V_START, VISIT, on_episodes
from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.shared_hints import FADES_BY_BOTH


def td_episode(v, path, rewards, alpha, gamma, lam, kind):
    e = np.zeros(len(v))
    for t in range(len(rewards)):
        s, s_next = path[t], path[t + 1]
        v_next = v[s_next] if t + 1 < len(rewards) else 0
        delta = rewards[t] + gamma * v_next - v[s]
        e *= gamma * lam
        e[s] = e[s] + 1 if kind == "accumulating" else 1
        v += alpha * delta * e


CHANGED, WITNESSES = read_answers(__file__, {"trace_after": trace_after})

exercise = Exercise(
    task="learn the values of the states from one recorded episode, by TD(λ) with traces of the given kind",
    right=td_episode,
    memory={"v": V_START},
    tape=on_episodes(kind=KINDS * 3),
    mistakes={
        "past_the_end": Mistake(END, {V_NEXT: "v[s_next]"}),
        "kinds_swapped": Mistake(KIND, {'kind == "accumulating"': 'kind != "accumulating"'}),
        "always_accumulates": Mistake(
            "both kinds accumulate here: a replacing trace is set to 1, however large it was.",
            {VISIT: "e[s] = e[s] + 1"},
        ),
        "always_replaces": Mistake(
            "both kinds replace here: an accumulating trace grows by 1 at each visit.", {VISIT: "e[s] = 1"}
        ),
        "no_gamma_in_fading": Mistake(FADES_BY_BOTH, {"gamma * lam": "lam"}),
        "no_fading": Mistake(
            "the traces do not fade: in each step they are multiplied by γ · λ.", CHANGED["no_fading"]
        ),
        "only_s_learns": Mistake(
            "only the state of this step learns. With traces all of them do, each times its trace: v += α δ e.",
            {"v += alpha * delta * e": "v[s] += alpha * delta"},
        ),
        "no_gamma": Mistake("γ is missing in δ: what comes a step later counts γ times.", {"gamma * v_next": "v_next"}),
        "fades_before_update": Mistake(
            "the traces fade between visit and update, so the state itself learns too little.",
            CHANGED["fades_before_update"],
        ),
        "no_old_value": Mistake("δ is the target minus the old value of s.", {" - v[s]": ""}),
        "no_alpha": Mistake("α is missing in the update.", {"alpha * delta": "delta"}),
        "last_reward_alone": Mistake(
            "the reward of each step counts, not only that of the last.",
            {"rewards[t] + gamma": "(rewards[t] if t + 1 == len(rewards) else 0) + gamma"},
        ),
    },
    hints=(
        "For each step of the episode: δ, the traces as in your trace_after, and then all values change at once.",
        "s, s_next = path[t], path[t + 1]; the value of s_next counts 0 in the last step; the traces fade by gamma * "
        "lam, and s is visited.",
        "Last in the loop: v += alpha * delta * e. It changes the array in place.",
    ),
    gained="One δ, and the whole way that led there learns from it.",
    witnesses=WITNESSES,
)
