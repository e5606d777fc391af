"""How many steps the temperature takes to its cap."""

from __future__ import annotations

import math

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

steps_to_the_cap = math.ceil((50 - 1) / (0.25 * 21 / 2))

exercise = Question(
    task="the number of steps after which the temperature is at its cap",
    right=steps_to_the_cap,
    because="Each step adds 0.25 · 21 / 2 = 2.625. From 1 to 50 it is 49 / 2.625 = 18.7, so the 19th step gets there.",
    mistakes={
        "one_too_few": Mistake("after 18 steps the temperature is 48.25, not quite 50.", 18),
        "not_whole": Mistake("steps are whole: after how many of them is it there?", 49 / 2.625),
        "from_0_not_whole": Mistake(
            "steps are whole, and the robot starts at T = 1: it has only 49 to climb.", 50 / 2.625
        ),
        "from_0": Mistake("the robot starts at T = 1, not at 0. Count once more.", 20),
        "no_quarter": Mistake("that would be without the factor 0.25: each step adds a quarter of the redundancy.", 5),
        "not_whole_no_quarter": Mistake("each step adds a quarter of the redundancy, and steps are whole.", 49 / 10.5),
        "no_quarter_one_too_few": Mistake("each step adds a quarter of the redundancy, which is 10.5.", 4),
        "the_way": Mistake("this is the way from 1 to 50. How much of it is one step?", 49),
        "quarter_a_step": Mistake("that would be 0.25 a step. Each step adds 0.25 times the redundancy.", 196),
        "quarter_a_step_from_0": Mistake(
            "that would be 0.25 a step, and from 0 on. Each step adds 0.25 times the redundancy.", 200
        ),
        "one_state": Mistake("that would be with a single state in the queue. Here there are two different ones.", 10),
        "one_state_not_whole": Mistake(
            "that would be with a single state in the queue. Here there are two different ones.", 49 / 5.25
        ),
        "one_state_from_0": Mistake(
            "that would be with a single state in the queue, and from 0 on. Here there are two different ones.",
            50 / 5.25,
        ),
        "short_queue": Mistake("the redundancy is 21 / 2 = 10.5: the queue holds 21 states, not 2 or 4.", 98),
        "fills_the_queue": Mistake("its queue is full already: the first step with LRLE heats.", 40),
        "one_step": Mistake("this is how much one step adds. How many of them does it take from 1 to 50?", 2.625),
        "redundancy_itself": Mistake("this is the redundancy. A quarter of it is added in each step.", 10.5),
        "size_of_the_queue": Mistake("this is the size of the queue, which is full already.", 21),
    },
    hints=(
        "How much does one step add? How far is it from the default to the cap?",
        "One step adds 0.25 · 21 / 2, and the way is 50 − 1 long.",
        "49 / 2.625 is not whole: the step in which it gets there is the next whole number.",
    ),
    gained="So a rut of two states is at full heat in 19 steps. A wider one takes longer: 94 at a redundancy of 2.1.",
    witnesses={
        "one_too_few": [18],
        "not_whole": [18.666666666666668],
        "no_quarter": [5],
        "quarter_a_step": [196.0],
        "one_state": [10],
        "from_0_not_whole": [50 / 2.625],
        "fills_the_queue": [40],
    },
)
