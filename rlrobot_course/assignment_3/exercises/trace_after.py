"""The traces after a path, replacing or accumulating."""

from __future__ import annotations

from typing import Any

import numpy as np

from rlrobot_course.assignment_3.given import KIND, KINDS, VISIT
from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def trace_after(path, n_states, decay, kind):
    e = np.zeros(n_states)
    for s in path:
        e *= decay
        e[s] = e[s] + 1 if kind == "accumulating" else 1
    return e


def on_paths(kinds: tuple[str, ...], **more: Any) -> list[dict[str, Any]]:
    """A case for each path, with the kinds of traces in turn."""
    paths = ([2], [1, 2, 1], [1, 2, 1], [3, 3, 3, 0], [0, 1, 2, 1, 1, 3], [0, 1, 2, 1, 1, 3])
    decays = (0.5, 0.9, 0.9, 0.75, 0.6, 0.6)
    return [
        {"path": path, "n_states": 4, "decay": decay, "kind": kinds[i % len(kinds)], **more}
        for i, (path, decay) in enumerate(zip(paths, decays, strict=True))
    ]


CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="return the traces of all states after the last visit of the path",
    right=trace_after,
    returns="e",
    tape=on_paths(KINDS),
    mistakes={
        "kinds_swapped": Mistake(KIND, {'kind == "accumulating"': 'kind != "accumulating"'}),
        "always_accumulates": Mistake(
            "both kinds accumulate here: a replacing trace is set to 1, however large it was.",
            {VISIT: "e[s] = e[s] + 1"},
        ),
        "always_replaces": Mistake(
            "both kinds replace here: an accumulating trace grows by 1 at each visit.", {VISIT: "e[s] = 1"}
        ),
        "fades_after_the_last": Mistake(
            "this fades after the last visit, too. All traces fade first, and then the visited one grows.",
            CHANGED["fades_after_the_last"],
        ),
        "only_visited_fades": Mistake(
            "only the visited trace fades. In each step all of them do.", {"e *= decay": "e[s] *= decay"}
        ),
        "no_fading": Mistake("nothing fades: in each step all traces are multiplied by decay.", CHANGED["no_fading"]),
        "counts_visits": Mistake(
            "the visits are counted. A trace also fades with each step since.", CHANGED["counts_visits"]
        ),
        "not_the_last": Mistake("the last state of the path is visited, too.", {"for s in path": "for s in path[:-1]"}),
    },
    hints=(
        "Walk along the path once more: in each step all traces fade, and then the visited state's grows or is set.",
        "e = np.zeros(n_states); for s in path: first e *= decay, then the visit.",
        'The visit: e[s] = e[s] + 1 if kind == "accumulating" else …',
    ),
    gained="A trace is a memory that fades. All that differs between the kinds is what a second visit does to it.",
    witnesses=WITNESSES,
)
