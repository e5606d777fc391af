"""A robot of wander_simple learns by Q-learning, and draws its actions by the learner's function."""

from rlrobot_course.drives.by_your_code import Reel
from rlrobot_course.drives.worlds import FilmedWorld, run
from rlrobot_course.lesson_04.exercises import normalise, softmax
from rlrobot_course.worlds.callbacks import QLearner
from rlrobot_grading.answers.values import Function

TASK, SEED, STEPS = "wander_simple", 0, 500


def by_draw(draw: Function, reel: Reel) -> None:
    """The learner's draw chooses by softmax, while the robot learns; the film has its last steps."""
    world = FilmedWorld(TASK, SEED, reel, STEPS)
    q, learn = world.table(), QLearner(0.1, 0.9)

    def choose(s: int) -> int:
        p = softmax(normalise(q[s], world.r_max, 0.9), 1.0)
        a: int = draw(p, world.u)
        return a

    run(world, choose, lambda *step: learn(q, *step))


drives = {"draw": by_draw}
