"""The maps of what is visited while all values are 0."""

import gymnasium
import numpy as np
from rlrobot_edu.course.lesson_03.ties import count_visits, plot_visits


def test_visits_are_counted_where_steps_end_and_the_map_names_the_cells():
    lake = gymnasium.make("FrozenLake-v1", is_slippery=False)  # action 0 is left, 1 is down
    left, down = count_visits(lake, np.argmax, episodes=2), count_visits(lake, lambda q_s: 1, episodes=3)
    assert left[0] == left.sum() == 2 * 100, "into the wall until time is up"
    assert [down[s] for s in (4, 8, 12)] == [3, 3, 3] and down.sum() == 9, "three steps down into the hole"
    figure = plot_visits(lake, {"left": left, "down": down}, "title")
    assert "left: 1 of 16 squares seen, the goal 0 times; down: 3 of 16" in figure.alt
    texts = [text.get_text() for text in figure.axes[1].texts]
    assert texts[0] == "start\nnever" and texts[12] == "hole\n33.3 %" and len(texts) == 16
