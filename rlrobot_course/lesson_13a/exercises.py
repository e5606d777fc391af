"""Right answers and tapes of lesson 13a; what is asked, hints and mistakes stand on the pages beside."""

from rlrobot_course.grading.parts import Formula, Question, with_pages
from rlrobot_course.lesson_13a.reward_exercise import RewardExercise
from rlrobot_course.tapes import rows


def arm_reward(before, after):
    if after <= 0.05:
        return 10.0
    return 100 * (before - after)


check = with_pages(
    globals(),
    pays=Question(Formula("((away + 5) / 2, (away + 10) / 2)", away=-1, γ=0.9)),
    arm_reward=RewardExercise(
        arm_reward,
        returns="reward",
        tape=rows(
            "before after",
            (0.20, 0.17),
            (0.17, 0.20),
            (0.12, 0.105),
            (0.105, 0.12),
            (0.15, 0.15),
            (0.06, 0.04),
            (0.04, 0.03),
            (0.03, 0.08),
            (0.09, 0.05),
            (0.085, 0.0501),
            (0.30, 0.24),
            (0.10, 0.135),
        ),
    ),
)
