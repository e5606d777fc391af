"""Who stops the robot in five mishaps."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

who_stops = (3, 4, 1, 2, 4)

exercise = Question(
    task="five numbers from 1 to 4, such as (1, 2, 3, 4, 1)",
    right=who_stops,
    because="Who is dead cannot say stop, so a second process does; where no message gets through any more, only the "
    "robot itself can.",
    mistakes={
        "exception_after_a_kill": Mistake(
            "a kernel that was killed runs no line more, neither the stop after the step nor what follows an "
            "exception. A second process must do it.",
            (2, 4, 1, 2, 4),
        ),
        "step_after_a_kill": Mistake(
            "a kernel that was killed runs no line more, not even the stop that comes a tenth of a second after "
            "the step.",
            (1, 4, 1, 2, 4),
        ),
        "watchdog_after_a_kill": Mistake(
            "a kernel that was killed need not wait for the robot's own watchdog: the guardian is a process of its "
            "own, and still there.",
            (4, 4, 1, 2, 4),
        ),
        "guardian_without_cable": Mistake(
            "with the cable out, the guardian can say stop as often as it likes: nobody hears it.", (3, 3, 1, 2, 4)
        ),
        "link_without_cable": Mistake(
            "with the cable out, the link notices and says stop, but nobody hears it.", (3, 2, 1, 2, 4)
        ),
        "guardian_without_computer": Mistake(
            "when the computer is off, the guardian is off, too: it is a process of the same computer.", (3, 4, 1, 2, 3)
        ),
        "no_message_either_way": Mistake(
            "cable out, computer off: in both cases no message gets through, whoever says it.", (3, 3, 1, 2, 3)
        ),
        "exception_of_a_reward": Mistake(
            "the reward is computed when the step is over. Nothing has to catch the exception: no next step comes "
            "within a tenth of a second, and so the robot is stopped.",
            (3, 4, 2, 2, 4),
        ),
        "kernel_after_a_stop": Mistake(
            "■ in the middle of a step is an exception in Python (KeyboardInterrupt). The link catches it and says "
            "stop before the step would have ended.",
            (3, 4, 1, 1, 4),
        ),
        "c_and_d_swapped": Mistake(
            "c and d have changed places. The reward is computed after the step; ■ comes in the middle of one.",
            (3, 4, 2, 1, 4),
        ),
        "guardian_after_a_stop": Mistake(
            "■ ends a step, not the kernel: the kernel lives on, and says stop itself.", (3, 4, 1, 3, 4)
        ),
    },
    hints=(
        "For each case: who is still alive, and does what he says still reach the robot?",
        "a: the kernel is dead, the network is well. b and e: nothing reaches the robot. c: the step is over. d: it is "
        "not.",
        "(3, 4, 1, …, 4)",
    ),
    gained="Whoever can say why each of the four is there can also say what happens if one of them is missing.",
    witnesses={
        "watchdog_after_a_kill": [(4, 4, 1, 2, 4)],
        "guardian_without_cable": [(3, 3, 1, 2, 4)],
        "exception_of_a_reward": [(3, 4, 2, 2, 4)],
        "kernel_after_a_stop": [(3, 4, 1, 1, 4)],
        "guardian_without_computer": [(3, 4, 1, 2, 3)],
        "c_and_d_swapped": [(3, 4, 2, 1, 4)],
    },
)
