"""What is wrong with three task files."""

from __future__ import annotations

from itertools import product

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

faults = [3, 1, 4]

# What is at fault, by number, and why it cannot be so in one of the three files
CLUES = (
    "in file A, the reward 10 was never given, whatever the robot did. Which fault puts it out of reach?",
    "in file B, one bin of an input was never reached, and that input is always in its other bin. What is it that it "
    "cannot see?",
    "in file C, two actions do the same. Where is it said what the wheels are told?",
)

FAULTS = (1, 2, 3, 4)

EXAMPLE = [2, 2, 2]

exercise = Question(
    task="the number of the fault in A, B and C, such as [2, 2, 2]",
    right=faults,
    because="A asks for 7 metres in a step, B cuts its laser where no wall ever is, and C's command stops one wheel.",
    mistakes={
        "as_shown": Mistake(
            "that was only to show how it is written. Read the three reports, one after the other.", EXAMPLE
        ),
        **{
            "_".join(map(str, tried)): Mistake(CLUES[next(i for i in range(3) if tried[i] != faults[i])], list(tried))
            for tried in product(FAULTS, repeat=3)
            if list(tried) not in (EXAMPLE, faults)
        },
    },
    hints=(
        "Read the sentences under “Worth a look” first; the tables say where they come from.",
        "A: look at reports['A'].rewards. B: look at reports['B'].inputs. C: look at reports['C'].actions.",
        "A is 3. B is one of 1 and 2, and C is 4.",
    ),
    gained="You can read a report: it names the symptom, and the fault is for you to find.",
    witnesses={
        "as_shown": [[2, 2, 2]],
        "1_1_4": [[1, 1, 4]],
        "3_2_4": [[3, 2, 4]],
        "3_1_2": [[3, 1, 2]],
        "4_1_3": [(4, 1, 3)],
        "3_1_3": [[3, 1, 3]],
    },
)
