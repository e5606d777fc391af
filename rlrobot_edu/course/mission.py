"""The mission: one robot and one task file of the learner's own, from lesson 10 to lesson 17.

Each stage is a function that needs nothing but the folder `mission/` beside the notebooks. What it finds there it goes
on with; what is missing it names, and takes the toolkit's own instead. `page` writes one page of all that was done.
"""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from rlrobot_edu.course.clinic import follower
from rlrobot_edu.environments import make_env
from rlrobot_edu.exchange.reading import read_recording
from rlrobot_edu.experiments.compare import compare
from rlrobot_edu.files import write_whole
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import learn as let_learn
from rlrobot_edu.models.planning import best_average_reward
from rlrobot_edu.models.recording import Recording, record
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.robots.realism import Realism
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task
from rlrobot_edu.workshop.new_task import new_task

FOLDER, TASK, RECORDING, AGENT, NOTES = "mission", "my_robot.py", "recording", "agent.npz", "notes.json"
SHIPPED = "wander_simple"  # stands in for what is missing
STAGES = {"drive": "10", "learn": "11", "model": "13", "report": "14", "plan": "16", "rehearse": "17", "serve": "17"}
WEAK = Realism(laser_noise=0.03, wheel_slip=0.1, wall_friction=0.72)
METHODS = ("TOSL+QBIASSR", "SARSA+SR", "Q+RANDOM")


def drive(folder: str | Path = FOLDER, steps: int = 2000) -> None:
    """Lesson 10: a task file of your own, written if it is not there; the robot learns, and is recorded."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    if not (folder / TASK).exists():
        print(f"Written: {new_task(Path(TASK).stem, folder)}. It is yours: change it, and run this cell again.")
    task = _task(folder)
    recording = record(make_env(task, seed=0), Agent(task, seed=0), steps)
    recording.save(folder / RECORDING)
    _note(folder, "drive", f"{task.name}: {task.states.n} states, {steps} steps recorded, {_mean(recording.r)} a step.")


def learn(folder: str | Path = FOLDER, steps: int = 3000) -> None:
    """Lesson 11: an agent learns the task; it is kept."""
    task = _task(Path(folder))
    agent = Agent(task, seed=1)
    rewards = let_learn(agent, make_env(task, seed=1), steps, progress=False).rewards
    Path(folder).mkdir(parents=True, exist_ok=True)
    agent.save(Path(folder) / AGENT)
    first, last = _mean(rewards[: steps // 10]), _mean(rewards[-steps // 10 :])
    _note(Path(folder), "learn", f"{agent.method}, {steps} steps: {first} a step at first, {last} in the end.")


def model(folder: str | Path = FOLDER) -> None:
    """Lesson 13: a model of the recording, and what it does not know."""
    _, made = _model(Path(folder))
    pairs = len(made.offsets) - 1
    seen, best = int((made.sum_by_pair(1) > 0).sum()), best_average_reward(made)
    _note(Path(folder), "model", f"it knows {seen} of {pairs} pairs; the best that it promises is {best:.2f} a step.")


def report(folder: str | Path = FOLDER, repetitions: int = 10, steps: int = 1000) -> None:
    """Lesson 14: three methods on the task, and Tukey's test of all pairs."""
    result = compare(_task(Path(folder)), METHODS, repetitions, steps=steps, seed=0, progress=False)
    means = ", ".join(f"{who} {_mean(final)}" for who, final in result.final.items())
    pairs = "; ".join(f"{p.first} − {p.second} = {p.difference:.2f} (p = {p.p:.2g})" for p in result.tukey().pairs)
    _note(Path(folder), "report", f"{repetitions} robots each, {steps} steps: {means}. Tukey: {pairs}.")


def plan(folder: str | Path = FOLDER, steps: int = 1000) -> None:
    """Lesson 16: plan in the model, and drive by the plan on the robot."""
    task, made = _model(Path(folder))
    rewards = let_learn(follower(task, made), make_env(task, seed=2), steps, progress=False).rewards
    promised = f"the model promises {best_average_reward(made):.2f} a step"
    _note(Path(folder), "plan", f"{promised}, the robot that follows the plan earns {_mean(rewards)}.")


def rehearse(folder: str | Path = FOLDER, steps: int = 1000) -> None:
    """Lesson 17: the agent that has learned on the ideal robot meets a weak one, and goes on learning."""
    task, agent = _agent(Path(folder))
    env = make_env(task, seed=3, realism=WEAK)
    rewards = let_learn(agent, env, steps, progress=False).rewards
    first, last = _mean(rewards[: steps // 5]), _mean(rewards[-steps // 5 :])
    weaknesses = f"noise {WEAK.laser_noise} m, slip {WEAK.wheel_slip}, walls that hold ({WEAK.wall_friction})"
    _note(Path(folder), "rehearse", f"with {weaknesses}: {first} a step at first, {last} in the end.")


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
    _note(Path(folder), "serve", f"{_mean(rewards)} a step over ROS; {held} of {said} commands were held back.")


def page(folder: str | Path = FOLDER) -> Path:
    """Write the page of the mission, `mission.md`: what was done, and which lesson has what is missing."""
    notes, folder = _notes(Path(folder)), Path(folder)
    lines = [f"- **{stage}** (lesson {number}): {notes.get(stage, 'not yet.')}" for stage, number in STAGES.items()]
    folder.mkdir(parents=True, exist_ok=True)
    write_whole(folder / "mission.md", "\n".join([f"# My mission: {_task(folder).name}", "", *lines, ""]))
    return folder / "mission.md"


def _task(folder: Path) -> Task:
    if (folder / TASK).exists():
        return load_task(folder / TASK)
    print(f"{folder / TASK} is missing (lesson {STAGES['drive']} writes it): {SHIPPED} stands in.")
    return load_task(SHIPPED)


def _model(folder: Path) -> tuple[Task, SampleModel]:
    task = _task(folder)
    try:
        recording = Recording.load(folder / RECORDING, task=task)
    except (OSError, ValueError):  # there is none, or task and recording have parted
        print(f"{folder} has no recording of this task (lesson {STAGES['drive']}): that of {SHIPPED} stands in.")
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


def _mean(rewards: np.ndarray) -> str:
    return f"{rewards.mean():.2f}"


def _notes(folder: Path) -> dict[str, str]:
    """What was noted of each stage; nothing where the file is missing or damaged."""
    try:
        notes = json.loads((folder / NOTES).read_text(encoding="utf-8"))
        return {stage: str(notes[stage]) for stage in STAGES if stage in notes}
    except (OSError, ValueError, TypeError):
        return {}


def _note(folder: Path, stage: str, text: str) -> None:
    """Keep and print what a stage found."""
    folder.mkdir(parents=True, exist_ok=True)
    print(f"Mission, {stage}: {text}")
    write_whole(folder / NOTES, json.dumps(_notes(folder) | {stage: text}, indent=1, ensure_ascii=False) + "\n")
