"""What the reader of lesson 01 moves: the cut points of the lasers."""

from collections.abc import Mapping, Sequence

from rlrobot_course.handles.handle import Handle
from rlrobot_course.lesson_01.figures import plot_bins
from rlrobot_edu.task.variables import InputVariable

PAIR = (0.3, 0.5)  # two distances that a robot should tell apart [m]


def bin_of(x, cuts):
    """Number of the bin of the reading x: how many of the cuts, array (k,), are smaller."""
    number = 0
    for i in range(cuts.shape[0]):
        if x > cuts[i]:
            number += 1
    return number


def cuts_under(
    inputs: Sequence[InputVariable], readings: Mapping[str, float]
) -> Handle:
    """The cut points of lasers, all moved together, under the robot's readings.

    inputs: lasers with the same cut points, at most five; readings: by the inputs' names [m]
    """
    picture = plot_bins(inputs, readings)
    cuts = inputs[0].cuts
    assert cuts is not None  # plot_bins would have refused
    feed = {
        "names": [variable.name for variable in inputs],
        "readings": [float(readings[variable.name]) for variable in inputs],
        "cuts": list(cuts),
        "end": 2 * cuts[-1],
        "pair": list(PAIR),
    }
    return Handle(
        "Cut points under the readings of lasers",
        __package__,
        ["cuts.js"],
        feed,
        picture,
        {"bin_of": bin_of},
    )
