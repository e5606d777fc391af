"""The robot that walls hold learns by the learner's functions; the film has the last steps."""

from types import FunctionType

from rlrobot_course.drives.by_your_code import Reel
from rlrobot_course.drives.worlds import FilmedWorld
from rlrobot_course.lesson_10 import exercises
from rlrobot_grading.answers.values import Function

TASK, STEPS = "wander_1k", 400
# seed and temperature; the cold robot of this seed gets stuck without loop evasion
WARM, COLD = (5, 1.0), (1, 0.01)


def by_learner(learner: Function, reel: Reel, how: tuple[int, float]) -> None:
    """A whole learner drives for all steps. how: seed and temperature"""
    seed, temperature = how
    world = FilmedWorld(TASK, seed, reel, STEPS, held=True)
    about = world.size.shape, world.n_actions, world.r_max
    learner(world, *about, STEPS, world, 0.1, 0.9, 0.9, temperature)


def by_learn(learn: Function, reel: Reel) -> None:
    """The learner's loop without loop evasion."""
    by_learner(learn, reel, WARM)


def by_learn_and_evade(learn_and_evade: Function, reel: Reel) -> None:
    """The learner's loop with loop evasion."""
    by_learner(learn_and_evade, reel, COLD)


def by_choose(choose: Function, reel: Reel) -> None:
    """The right loop, in which the learner's function chooses."""
    names = vars(exercises) | {"choose": choose}
    by_learn(FunctionType(exercises.learn.__code__, names), reel)


drives = {
    "choose": by_choose,
    "learn": by_learn,
    "learn_and_evade": by_learn_and_evade,
}
