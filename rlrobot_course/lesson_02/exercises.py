"""Right answers and tapes of lesson 02; the pages of this folder have the tasks, hints and mistakes."""

from rlrobot_course.exercises.parts import Exercise, Formula, Question, with_pages


def discounted_return(rewards, gamma):
    total = 0
    for k, r in enumerate(rewards):
        total += gamma**k * r
    return total


check = with_pages(
    globals(),
    discounted_return=Exercise(
        discounted_return,
        returns="sum",
        tape=[
            {"rewards": [3.0, -2.0, 7.0, 1.5], "gamma": 0.7},
            {"rewards": [-0.02, 10.0, 10.0], "gamma": 0.9},
            {"rewards": [10.0], "gamma": 0.9},
            {"rewards": [0.0, 0.0, 0.0, 1.0], "gamma": 0.5},
            {"rewards": [1.0, 2.0, 3.0], "gamma": 1.0},
            {"rewards": [5.0, -2.0, 7.0], "gamma": 0.0},
            {"rewards": [-2.0, -0.02, -2.0, 1.0], "gamma": 0.85},
            {"rewards": [], "gamma": 0.9},
            {"rewards": [10.0] * 12, "gamma": 0.99},
            {"rewards": [0.0] * 30 + [50.0], "gamma": 0.95},
            {"rewards": [0.0] * 24 + [50.0], "gamma": 0.5},
            {"rewards": [1.23456, -0.98765, 3.14159], "gamma": 0.87654},
        ],
    ),
    far_from_the_goal=Question(Formula("γ ** (steps - 1)", γ=0.8, steps=4)),
)
