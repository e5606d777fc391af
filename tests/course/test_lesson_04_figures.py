"""Lesson 04's figure: the action under the point is the one that is drawn."""

from rlrobot_course.lesson_04.figures import plot_draw


def test_the_segment_under_the_point_is_the_action_that_is_sampled():
    for u in (0.0, 0.49, 0.5, 0.99):
        figure = plot_draw([0.0, 0.5, 0.5], u)
        strong = [bar for bar in figure.axes[0].patches if bar.get_alpha() == 1]
        assert len(strong) == 1 and strong[0].get_x() <= u < strong[0].get_x() + strong[0].get_width()
