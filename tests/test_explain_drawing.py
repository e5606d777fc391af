"""The picture of a draw."""

from rlrobot_edu.course.lesson_03.drawing import plot_draw


def test_the_segment_under_the_point_is_the_action_that_is_drawn():
    for u, drawn in ((0.0, 1), (0.49, 1), (0.5, 2), (0.99, 2)):
        figure = plot_draw([0.0, 0.5, 0.5], u)
        assert f"draws action {drawn}" in figure.alt
        strong = [bar for bar in figure.axes[0].patches if bar.get_alpha() == 1]
        assert len(strong) == 1 and strong[0].get_x() <= u < strong[0].get_x() + strong[0].get_width()
