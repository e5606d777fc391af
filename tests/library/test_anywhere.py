"""Where numba, meshcat and ZeroMQ cannot be had, as in a browser: all but 3D and PyBullet works and learns the same."""

import subprocess
import sys

import pytest

ABSENT = ("numba", "llvmlite", "meshcat", "zmq", "umsgpack", "pybullet")
LESSON = """
import hashlib
import sys

for name in sys.argv[1:]:
    sys.modules[name] = None  # importing it fails

import rlrobot_edu as rl

model = rl.SampleModel.from_recording(rl.read_recording("worked_example"))
agent = rl.Agent(model, seed=0)
history = rl.learn(agent, rl.make_env(model, seed=0), steps=300, progress=False)
again = rl.repeat("worked_example", repetitions=2, steps=100, n_jobs=1)
assert b"PNG" in rl.plot_learning(history).png()
env = rl.make_env("wander_simple", seed=0)
robot = rl.Agent(env, seed=0)
rl.learn(robot, env, steps=20, progress=False)
assert rl.film(robot, env, steps=3).gif()[:3] == b"GIF"
stepper = rl.Stepper(rl.Agent("worked_example", seed=0), rl.make_env("worked_example"), at=5)
assert "data:image/png" in stepper._repr_mimebundle_()["text/html"]
digest = hashlib.sha256(agent.q.tobytes() + robot.q.tobytes())
for repetition in again:
    digest.update(repetition.q.tobytes())
print(digest.hexdigest())
for name in ("meshcat", "umsgpack", "zmq"):  # 3D comes when it is asked for
    assert sys.modules.get(name) is None, name
"""


def learned(*absent: str) -> str:
    """The fingerprint of what is learned without these modules."""
    command = [sys.executable, "-c", LESSON, *absent]
    run = subprocess.run(command, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    return run.stdout


@pytest.mark.long
def test_learning_and_flat_pictures_do_without_numba_and_meshcat_and_the_numbers_are_the_same():
    assert learned(*ABSENT) == learned()
