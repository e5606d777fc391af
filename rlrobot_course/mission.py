"""The mission: one robot and one task file of the learner's own, from lesson 10 to lesson 17.

Each stage is a function that needs nothing but the folder `mission/` beside the notebooks. What it finds there it goes
on with; what is missing it names, and takes the toolkit's own instead. `page` writes one page of all that was done.
"""

from __future__ import annotations

import hashlib
import re
from pathlib import Path
from typing import Any

import numpy as np

from rlrobot_course.clinic import follower
from rlrobot_course.learners_files import Text, enter, entries, put_aside
from rlrobot_edu.environments import make_env
from rlrobot_edu.experiments.compare import compare
from rlrobot_edu.files import write_whole
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import learn as let_learn
from rlrobot_edu.learning.loop import steps as let_drive
from rlrobot_edu.models.formats.reading import read_recording
from rlrobot_edu.models.recording import Recording, record
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.robots.realism import Realism
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task
from rlrobot_edu.tools.new_task import new_task

FOLDER, TASK, RECORDING, AGENT, NOTES = "mission", "my_robot.py", "recording", "agent.npz", "notes.json"
PAGE = "mission.md"
SHIPPED = "wander_simple"  # stands in for what is missing
STAGES = {"drive": "10", "learn": "11", "model": "13", "report": "14", "plan": "16", "rehearse": "17", "serve": "17"}
WEAK = Realism(laser_noise=0.03, wheel_slip=0.1, wall_friction=0.72)
SLIPS = Realism(wheel_slip=0.1)  # for a robot without lasers or walls
LEG = 10  # steps, after which it is seen how far a robot has got
METHODS = ("TOSL+QBIASSR", "SARSA+SR", "Q+RANDOM")


def drive(folder: str | Path = FOLDER, steps: int = 2000) -> None:
    """Lesson 10: a task file of your own, written if it is not there; the robot learns, and is recorded."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    if not (folder / TASK).exists():
        print(f"Written: {new_task(Path(TASK).stem, folder)}. It is yours: change it, and run this cell again.")
    task = _task(folder)
    recording = record(Agent(task, seed=0), make_env(task, seed=0), steps)
    recording.save(folder / RECORDING)
    _note(folder, "drive", task, f"{task.states.n} states, {steps} steps recorded, {_mean(recording.r)} a step.")


def learn(folder: str | Path = FOLDER, steps: int = 3000) -> None:
    """Lesson 11: an agent learns the task; it is kept."""
    task = _task(Path(folder))
    agent = Agent(task, seed=1)
    rewards = let_learn(agent, make_env(task, seed=1), steps, progress=False).rewards
    Path(folder).mkdir(parents=True, exist_ok=True)
    agent.save(Path(folder) / AGENT)
    first, last = _mean(rewards[: steps // 10]), _mean(rewards[-steps // 10 :])
    _note(
        Path(folder), "learn", task, f"{agent.method.name}, {steps} steps: {first} a step at first, {last} in the end."
    )


def model(folder: str | Path = FOLDER) -> None:
    """Lesson 13: a model of the recording, and what it does not know."""
    task, made = _model(Path(folder))
    pairs = len(made.offsets) - 1
    seen, best = int((made.pair_count > 0).sum()), made.best_average_reward()
    told = f"it knows {seen} of {pairs} pairs; the best that it promises is {best:.2f} a step."
    _note(Path(folder), "model", task, told)


def report(folder: str | Path = FOLDER, repetitions: int = 10, steps: int = 1000) -> None:
    """Lesson 14: three methods on the task, and Tukey's test of all pairs."""
    task = _task(Path(folder))
    result = compare(task, METHODS, repetitions, steps=steps, seed=0, progress=False)
    means = ", ".join(f"{who} {_mean(final)}" for who, final in result.final.items())
    pairs = "; ".join(f"{p.first} − {p.second} = {p.difference:.2f} (p = {p.p:.2g})" for p in result.tukey().pairs)
    _note(Path(folder), "report", task, f"{repetitions} robots each, {steps} steps: {means}. Tukey: {pairs}.")


def plan(folder: str | Path = FOLDER, steps: int = 1000) -> None:
    """Lesson 16: plan in the model, and drive by the plan on the robot."""
    task, made = _model(Path(folder))
    rewards, far = _driven(follower(task, made), make_env(task, seed=2), steps)
    promised = f"the model promises {made.best_average_reward():.2f} a step"
    _note(Path(folder), "plan", task, f"{promised}, the robot that follows the plan earns {_mean(rewards)}{far}.")


def rehearse(folder: str | Path = FOLDER, steps: int = 1000) -> None:
    """Lesson 17: the agent that has learned on the ideal robot meets a weak one, and goes on learning."""
    task, agent = _agent(Path(folder))
    weaknesses = f"noise {WEAK.laser_noise} m, slip {WEAK.wheel_slip}, walls that hold ({WEAK.wall_friction})"
    try:
        env = make_env(task, seed=3, realism=WEAK)
    except ValueError:  # an arm, which has neither lasers nor walls
        env, weaknesses = make_env(task, seed=3, realism=SLIPS), f"slip {SLIPS.wheel_slip} alone"
    rewards, far = _driven(agent, env, steps)
    first, last = _mean(rewards[: steps // 5]), _mean(rewards[-steps // 5 :])
    _note(Path(folder), "rehearse", task, f"with {weaknesses}: {first} a step at first, {last} in the end{far}.")


def serve(folder: str | Path = FOLDER, steps: int = 100) -> None:
    """Lesson 17: the agent drives a served robot, over ROS."""
    from rlrobot_edu.ros.live.link import RobotLink  # here, because the extra `ros` may be missing
    from rlrobot_edu.ros.live.served_robot import ServedRobot

    task, agent = _agent(Path(folder))
    with ServedRobot(task, port=0, simulated_time=True, seed=0) as robot:
        link = RobotLink("rosbridge", **robot.where, confirmed=True, simulated_time=True)
        env = make_env(task, link=link, seed=0)
        rewards = let_learn(agent, env, steps, progress=False).rewards
        held, said = link.report.held_back, link.report.said
        env.close()
    _note(Path(folder), "serve", task, f"{_mean(rewards)} a step over ROS; {held} of {said} commands were held back.")


def page(folder: str | Path = FOLDER) -> Path:
    """Write the page of the mission, `mission.md`: what was done, and which lesson has what is missing."""
    folder, lines = Path(folder), []
    notes, file = _notes(folder), _digest(folder)
    for stage, number in STAGES.items():
        told, of = notes.get(stage, ("not yet.", file))
        lines.append(f"- **{stage}** (lesson {number}): {told}{f' (Of an older {TASK}.)' * (of != file)}")
    folder.mkdir(parents=True, exist_ok=True)
    if _has_more(folder / PAGE):
        print(put_aside(folder / PAGE))
    write_whole(folder / PAGE, "\n".join([f"# My mission: {_task(folder).name}", "", *lines, ""]))
    return folder / PAGE


def _has_more(page: Path) -> bool:
    """Whether a page of the mission has lines that no stage wrote."""
    text = Text.of(page.read_bytes()) if page.exists() else Text("")
    ours = rf"# My mission: .*|- \*\*({'|'.join(STAGES)})\*\* \(lesson .*|"
    return text is None or not all(re.fullmatch(ours, line) for line in text.text.splitlines())


def _task(folder: Path) -> Task:
    if (folder / TASK).exists():
        return load_task(folder / TASK)
    print(f"{folder / TASK} is missing (lesson {STAGES['drive']} writes it): {SHIPPED} stands in.")
    return load_task(SHIPPED)


def _model(folder: Path) -> tuple[Task, SampleModel]:
    task = _task(folder)
    try:
        recording = Recording.load(folder / RECORDING, task=task)
    except (OSError, ValueError) as error:
        missing = f"{folder} has no recording (lesson {STAGES['drive']})"
        older = f"Your recording is of an older {TASK}: run the mission's cell in lesson {STAGES['drive']} again"
        print(f"{older if isinstance(error, ValueError) else missing}. That of {SHIPPED} stands in.")
        task, recording = load_task(SHIPPED), read_recording(SHIPPED)
    return task, SampleModel.from_recording(recording, unseen="stay")


def _agent(folder: Path) -> tuple[Task, Agent]:
    """The agent that was kept, if it is still one of this task; else one that has just learned it."""
    task = _task(folder)
    agent = Agent(task, seed=1)
    try:
        kept = Agent.load(folder / AGENT)
        if kept.q.shape == agent.q.shape:
            agent.q[:] = kept.q
            return task, agent
    except (OSError, ValueError):
        pass
    print(f"{folder} has no agent of this task (lesson {STAGES['learn']}): one learns for 1000 steps.")
    let_learn(agent, make_env(task, seed=1), 1000, progress=False)
    return task, agent


def _driven(agent: Agent, env: Any, steps: int) -> tuple[np.ndarray, str]:
    """What an agent is paid while it drives and learns, array (steps,), and in words how far the robot gets."""
    rewards, places = [], []
    for step in let_drive(agent, env, steps):
        rewards.append(step.r)
        readings = env.unwrapped.robot.readings
        if "x" in readings:
            places.append((readings["x"], readings["y"]))
    if len(places) <= LEG:
        return np.array(rewards), ""
    way = np.linalg.norm(np.array(places[LEG:]) - np.array(places[:-LEG]), axis=1).mean()
    return np.array(rewards), f"; after {LEG} steps it is {way:.2f} m from where it was, on average"


def _mean(rewards: np.ndarray) -> str:
    return f"{rewards.mean():.2f}"


def _digest(folder: Path) -> str:
    """What tells one version of the task file from another; empty where there is none."""
    path = folder / TASK
    return hashlib.sha256(path.read_bytes()).hexdigest()[:16] if path.exists() else ""


def _notes(folder: Path) -> dict[str, tuple[str, str]]:
    """What was noted of each stage, and of which task file; nothing where the file is missing or damaged."""
    return entries(folder / NOTES, _told_of)


def _told_of(note: Any) -> tuple[str, str]:
    return str(note["told"]), str(note["file"])


def _note(folder: Path, stage: str, task: Task, text: str) -> None:
    """Keep and print what a stage found, with the name of the task and the version of the learner's file."""
    folder.mkdir(parents=True, exist_ok=True)
    told = f"{task.name}: {text}"
    print(f"Mission, {stage}: {told}")
    if lost := enter(folder / NOTES, stage, {"told": told, "file": _digest(folder)}, _told_of):
        print(lost)
