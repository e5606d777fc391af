"""Task files: those of the toolkit load, and a bad one is refused with a message that names the file."""

import pickle

import pytest

import rlrobot_edu as rl
from rlrobot_edu.task.task_file import available_tasks

GOOD = '''"""A task of my own."""
from rlrobot_edu import InputVariable, OutputVariable, Task

task = Task(
    robot="mobile_base",
    scene="square_2x2",
    inputs=[InputVariable("laser_front", cuts=[0.2, 0.5], unit="m")],
    outputs=[OutputVariable("left_wheel", values=[0, 1], unit="rad/s"),
             OutputVariable("right_wheel", values=[0, 1], unit="rad/s")],
    rewards=[-1, 1],
    reward=lambda before, after: 1 if after["laser_front"] > 0.5 else -1,
)
'''


def write(folder, old="", new=""):
    """A task file that is good but for one place."""
    assert old in GOOD
    path = folder / "my_own.py"
    path.write_text(GOOD.replace(old, new, 1) if old else GOOD)
    return path


@pytest.mark.parametrize(
    ("name", "shape", "n_actions"),
    [
        ("wander_simple", (2, 2), 4),
        ("wander_1k", (4, 4, 4, 4, 4), 9),
        ("worked_example", (2, 2, 3, 2), 3),
    ],
)
def test_the_shipped_tasks_have_the_states_and_actions_of_the_paper(
    name, shape, n_actions
):
    task = rl.load_task(name)
    assert (task.name, task.states.shape, task.actions.n) == (name, shape, n_actions)


OUTLINE = [
    "Description",
    "Inputs",
    "Outputs",
    "Rewards",
    "Episode end",
    "Scene",
    "Differs from the paper",
]


@pytest.mark.parametrize("name", available_tasks())
def test_every_shipped_task_loads_and_is_described_in_the_fixed_order(name):
    description = rl.load_task(name).description
    places = [description.find(f"\n{word}:") for word in OUTLINE]
    assert -1 not in places and places == sorted(places)


def test_a_task_file_of_ones_own_loads_and_survives_a_trip_to_another_process(tmp_path):
    task = rl.load_task(write(tmp_path))
    copy = pickle.loads(pickle.dumps(task))
    assert (
        (copy.name, copy.description)
        == (task.name, task.description)
        == ("my_own", "A task of my own.")
    )
    assert copy.reward_for({}, {"laser_front": 1.0}) == 1


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('"laser_front", cuts', '"laser_fornt", cuts', "did you mean 'laser_front'"),
        ('"mobile_base"', '"mobile_bass"', "did you mean 'mobile_base'"),
        ('"square_2x2"', '"square_3x3"', "did you mean 'square_2x2'"),
        ('"left_wheel"', '"left_weel"', "did you mean 'left_wheel'"),
        ("cuts=[0.2, 0.5]", "cuts=[0.5, 0.2]", "increase"),
        ("cuts=[0.2, 0.5]", "cuts=[0.2, 0.2]", "increase"),
        ("cuts=[0.2, 0.5]", "cuts=[0.2, 6.0]", "range"),
        ("cuts=[0.2, 0.5]", "cuts=[]", "one or more"),
        ('unit="m"', 'unit="cm"', "'m'"),
        ("values=[0, 1]", "values=[]", "values must be one or more finite numbers"),
        ("outputs=[", "outputs=[] and [", "no actions"),
        ("inputs=[", "inputs=[] and [", "at least one input"),
        ("rewards=[-1, 1]", "rewards=[float('nan'), 1]", "finite"),
        ("rewards=[-1, 1]", "rewards=[-1]", "above 0"),
        ("rewards=[-1, 1]", "rewards=[-1, 1], step_time=0", "step_time"),
        ("rewards=[-1, 1]", "rewards=[-1, 1], episode_steps=0", "episode_steps"),
        ("rewards=[-1, 1]", "rewards=[-1, 1], colour=3", "colour"),
        ("task = Task(", "task = Task((", "never closed"),
        ("task = Task(", "my_task = Task(", "must define task"),
        ("task = Task(", "task = dict(", "must define task"),
    ],
)
def test_a_bad_task_file_is_refused_with_a_message_that_names_it(
    tmp_path, old, new, words
):
    path = write(tmp_path, old, new)
    with pytest.raises(ValueError) as refusal:
        rl.load_task(path)
    assert str(path) in str(refusal.value)
    assert words in str(refusal.value)


@pytest.mark.parametrize("reward", ["float('nan')", "0.5", "None"])
def test_a_reward_that_is_not_listed_is_refused_and_names_the_file(tmp_path, reward):
    path = write(tmp_path, "1 if after", f"{reward} if after")
    with pytest.raises(ValueError, match="not one of rewards") as refusal:
        rl.load_task(path).reward_for({}, {"laser_front": 1.0})
    assert str(path) in str(refusal.value)


def test_a_task_that_does_not_exist_is_named_and_the_nearest_one_suggested(tmp_path):
    with pytest.raises(ValueError, match="did you mean 'wander_1k'"):
        rl.load_task("wander_1kk")
    with pytest.raises(FileNotFoundError, match="nowhere"):
        rl.load_task(tmp_path / "nowhere.py")
    for slip in ("Wander-1K", "WANDER 1k", "wander1k"):
        with pytest.raises(ValueError, match="did you mean 'wander_1k'"):
            rl.load_task(slip)
    write(tmp_path)
    with pytest.raises(FileNotFoundError, match="did you mean 'my_own"):
        rl.load_task(tmp_path / "my-own.py")
