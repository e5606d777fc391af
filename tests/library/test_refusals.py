"""What a public call cannot do it refuses in one sentence; nothing that is given is passed over in silence."""

import pytest

import rlrobot_edu as rl
from rlrobot_edu.widgets.driving.teaching import learn_from

FEW = {"steps": 5, "progress": False, "n_jobs": 1}


def test_a_method_beside_the_methods_of_a_comparison_is_refused():
    with pytest.raises(ValueError, match="name the methods in methods="):
        rl.compare("wander_simple", ["Q+SR"], 1, method="SARSA+SR", **FEW)


def test_a_label_without_names_of_its_parameters_is_refused():
    with pytest.raises(ValueError, match="a label needs parameters by name"):
        rl.compare("wander_simple", {"mine": "Q+SR"}, 1, **FEW)


@pytest.mark.parametrize(
    "wrong", [{"repetitions": 0}, {"steps": "many"}, {"steps": -1}]
)
def test_how_often_and_how_long_to_repeat_are_whole_numbers(wrong):
    with pytest.raises(
        ValueError,
        match=f"{next(iter(wrong))} must be (None or )?a whole number of at least",
    ):
        rl.repeat("wander_simple", "Q+SR", **{"repetitions": 1, **FEW, **wrong})


def test_no_curve_is_drawn_of_no_steps():
    nothing = rl.learn(
        rl.Agent("wander_simple"), rl.make_env("wander_simple"), steps=0, progress=False
    )
    assert len(nothing.last_episode) == len(nothing.returns) == 0
    for histories in (nothing, [nothing, nothing], []):
        with pytest.raises(ValueError, match="a History of at least 1 step"):
            rl.plot_learning(histories)


def test_a_teacher_and_a_pupil_in_the_wrong_order_are_told_so():
    agent, recording = rl.Agent("wander_simple"), rl.read_recording("wander_simple")
    with pytest.raises(ValueError, match="an Agent and a Recording, in this order"):
        learn_from(recording, agent)
