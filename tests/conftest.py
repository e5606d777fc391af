from pathlib import Path

import pytest

import rlrobot_edu as rl

VREP = Path(__file__).parents[2] / "shared" / "vrep_recordings" / "wander_1k_SASR_step.npy"
VREP_INPUTS = ["laser_front", "laser_front_left", "laser_front_right", "laser_left", "laser_right"]


@pytest.fixture(scope="session")
def vrep_recording():
    """The paper's own recording of wander_1k."""
    if not VREP.is_file():
        pytest.skip("the recording of the paper's authors is not here (it is not part of the project)")
    return rl.read_recording(VREP, legacy=True, task=rl.load_task("wander_1k"), inputs=VREP_INPUTS)


@pytest.fixture(scope="session")
def wander_model():
    """The sample model of the toolkit's own wander_1k dataset."""
    return rl.SampleModel.from_recording(rl.read_recording("wander_1k"))
