"""A task as a Gymnasium environment: the robot acts, its readings become a state, the task gives the reward."""

import importlib
import sys
from collections.abc import Callable
from functools import cache, cached_property, partial
from inspect import signature
from typing import Any, Literal

import gymnasium
import numpy as np

from rlrobot_edu.checks import check_index, check_name
from rlrobot_edu.learning.kernel_world import KernelWorld
from rlrobot_edu.robots.realism import Realism, realistic
from rlrobot_edu.robots.robot import KernelRobot, LinkedRobot, Robot
from rlrobot_edu.seeds import ENVIRONMENT, generator
from rlrobot_edu.task.robot_cards import ROBOTS, Engine
from rlrobot_edu.task.task import Task

RenderMode = Literal["rgb_array", "ansi"]
Info = dict[str, Any]
RENDERED = 480  # width of a picture [pixels]
WORTH_COMPILING = 1000  # steps; fewer are done before the loop's kernels are loaded


class RobotEnv(gymnasium.Env[np.ndarray, int]):
    """The robot of `task` in its scene, as a Gymnasium environment.

    Parameters
    ----------
    task : Task
        What is observed, done and rewarded.
    seed : int or numpy.random.SeedSequence, optional
        Makes resets without a seed repeatable, too.
    engine : Engine, optional
        The simulator of the robot, one of its card's engines; None takes `default_engine`.
    realism : Realism, optional
        Imperfections to simulate; by default the robot is ideal.
    render_mode : RenderMode, optional
        With ``rgb_array``, `render` draws pictures, with ``ansi`` it writes a text; by default it does neither.
    link : LinkedRobot, optional
        A robot that exists already, such as a real one; then nothing is simulated.
    **options
        Other arguments of the robot's class.

    Raises
    ------
    ValueError
        If the robot cannot carry out one of the actions (the message names the task's file), or if `render_mode` is
        another one.
    ImportError
        If the engine is not installed; the message says what to install.

    Notes
    -----
    - `engine`: the simulator of the robot; None for a linked robot
    - `stops_at_once`: whether Ctrl-C interrupts a step, see `learn`; true for a linked robot
    - Observation: array (n_inputs,) of int64, the bin of each input
    - Action: number of an action, 0 to n_actions − 1
    - Info: ``state``, the number of the state; ``readings``, the robot's sensors by name
    - Reward: `task.reward` of the readings before and after the step
    - Episode end: terminated once `task.goal` held for `goal_steps` steps in a row, otherwise truncated after
      `episode_steps`
    - A copy (`copy.deepcopy`, `pickle`) goes on from the same state with the same random numbers, in its own world
    """

    metadata = {"render_modes": ["rgb_array", "ansi"], "render_fps": 7}  # noqa: RUF012 - Gymnasium's own word for it

    def __init__(
        self,
        task: Task,
        seed: int | np.random.SeedSequence | None = None,
        engine: Engine | None = None,
        realism: Realism | None = None,
        render_mode: RenderMode | None = None,
        link: LinkedRobot | None = None,
        **options: Any,
    ) -> None:
        if render_mode not in (None, "rgb_array", "ansi"):
            advice = "for other views give env.unwrapped.robot.scene() to rl.plot_scene or rl.meshcat"
            raise ValueError(
                f"render_mode must be None, 'rgb_array' or 'ansi', got {render_mode!r:.200}; {advice}"
            )
        self.task = task
        self.render_mode = render_mode
        self._link = link
        self.stops_at_once = link is not None
        self._realism = realism
        if link is not None:
            simulated = {"engine": engine, "realism": realism, **options}
            for name, value in simulated.items():
                if value is not None:
                    raise ValueError(f"a linked robot takes no {name}: leave it out")
            if not hasattr(link, "prepare"):
                raise ValueError(
                    f"link must be a linked robot, such as rlrobot_ros.RobotLink('ws://ROBOT:9090'), got {link!r:.200}"
                )
            link.prepare(task)
        else:
            if engine is None:
                engine = default_engine(task.robot)
            if realism is not None:
                realism.check(ROBOTS[task.robot], engine, task.step_time)
                # the base simulates these itself; `realistic` adds the rest
                if realism.lag or realism.wall_friction:
                    options["realism"] = realism
            self._make_robot = _maker(task, engine, options)
        self.engine = engine
        self.r_max = max(task.rewards)
        self.episode_steps = task.episode_steps
        self.state: int | None = None
        self.episode_step = 0
        self._at_goal = 0  # steps at the goal without a break
        self._readings: dict[str, float] = {}
        self._kernel_arrays: Any = None  # of the world that `kernel_world` gave last
        self.observation_space = gymnasium.spaces.MultiDiscrete(list(task.states.shape))
        n_actions = task.actions.n
        self.action_space: gymnasium.Space[Any] = gymnasium.spaces.Discrete(n_actions)
        self._commands = task.commands  # looked up in every step
        self.np_random = generator(seed, ENVIRONMENT)

    @cached_property
    def robot(self) -> Robot:
        """The robot itself: the linked one, or one that is built when it is first needed."""
        if self._link is not None:
            return self._link
        robot = self._make_robot()
        if self._realism is None:
            return robot
        return realistic(robot, ROBOTS[self.task.robot], self._realism)

    @cached_property
    def _camera(self) -> Any:
        # Imported here, because few environments draw pictures.
        from rlrobot_edu.show.painting.room import ASPECT, Room

        return Room(self.robot.scene(), RENDERED, round(RENDERED / ASPECT))

    def __getstate__(self) -> dict[str, Any]:
        state = dict(self.__dict__)
        state.pop("_camera", None)  # a copy makes its own when it needs one
        return state

    def close(self) -> None:
        """End the robot's simulator; `reset` starts it again."""
        self.state = None
        robot = self.__dict__.pop("robot", None)
        if robot is not None:
            robot.close()

    def reset(
        self, *, seed: int | None = None, options: Info | None = None
    ) -> tuple[np.ndarray, Info]:
        """Put the robot at its start.

        Parameters
        ----------
        seed : int, optional
            Makes what follows repeatable; None continues the random numbers.
        options : dict, optional
            Not used; Gymnasium passes it.

        Returns
        -------
        tuple
            The observation and the info.

        Raises
        ------
        ValueError
            If a reading is out of its range; the message names the task's file.
        """
        if seed is not None:
            self.np_random = generator(seed, ENVIRONMENT)
        self.state = None  # until the start is seen: the last episode is over
        self.episode_step = 0
        self._at_goal = 0
        return self._see(self.robot.reset(self.np_random))

    def step(self, action: int) -> tuple[np.ndarray, float, bool, bool, Info]:
        """Let the robot act for one control step.

        Parameters
        ----------
        action : int
            Number of the action, 0 to n_actions − 1.

        Returns
        -------
        tuple
            Observation, reward, terminated, truncated and info.

        Raises
        ------
        ValueError
            If there is no such action, or if a reading is out of its range (the message names the task's file).
        gymnasium.error.ResetNeeded
            Before the first `reset`.
        """
        if self.state is None:
            raise gymnasium.error.ResetNeeded("call reset() before the first step()")
        a = check_index("action", action, len(self._commands))
        command = self._commands[a]
        before = self._readings
        observation, info = self._see(self.robot.act(command))
        reward = self.task.reward_for(before, self._readings)
        self.episode_step += 1
        self._at_goal = self._at_goal + 1 if self.task.at_goal(self._readings) else 0
        terminated = self._at_goal >= self.task.goal_steps
        limit = self.episode_steps
        is_last = limit is not None and self.episode_step >= limit
        truncated = is_last and not terminated
        return observation, reward, terminated, truncated, info

    def kernel_world(self, steps: int) -> KernelWorld | None:
        """The robot and its task as a world of kernels, see `KernelEnv`; `learn` asks for it.

        Parameters
        ----------
        steps : int
            How many steps will be taken.

        Returns
        -------
        KernelWorld or None
            None if the robot or its task has no kernels, if there are few steps, and for a class of your own, which may
            step in another way.
        """
        if steps < WORTH_COMPILING or type(self) is not RobotEnv:
            return None
        robot = self.robot
        if not isinstance(robot, KernelRobot):
            return None
        world = robot.kernel_world(self.task, self._commands, self._at_goal)
        if world is not None:
            self._kernel_arrays = world.arrays
        return world

    def arrive(self, s: int) -> None:
        """Take over the state that the kernels have reached.

        Parameters
        ----------
        s : int
            Number of the state.
        """
        robot = self.robot
        assert isinstance(robot, KernelRobot)  # kernels have moved it
        self.state = s
        self._at_goal = int(self._kernel_arrays.at_goal[0])
        self._readings = robot.look()

    def render(self) -> Any:
        """Show the world as it is now: draw it, or say in words where the robot is and what it reads.

        Returns
        -------
        numpy.ndarray, str or None
            A picture, array (height, width, 3) of uint8; a text of two lines; None (and a warning) if `render_mode` is
            None.

        Raises
        ------
        gymnasium.error.ResetNeeded
            Before the first `reset`.
        """
        if self.render_mode is None:
            gymnasium.logger.warn(
                "nothing is shown: make the environment with render_mode='rgb_array' or 'ansi'"
            )
            return None
        if self.state is None:
            raise gymnasium.error.ResetNeeded("call reset() before the first render()")
        if self.render_mode == "ansi":
            return self._in_words()
        return np.array(self._camera.picture(self.robot.scene()))

    def _in_words(self) -> str:
        """Where the robot is, and what it reads."""
        # Imported here, as the camera is.
        from rlrobot_edu.show.describe import describe

        sensors = ROBOTS[self.task.robot].sensors
        readings = []
        for name, reading in self._readings.items():
            readings.append(f"{name} = {reading:.4g} {sensors[name].unit}".strip())
        place = describe(self.robot.scene())
        return f"Step {self.episode_step}. {place}\n{', '.join(readings)}"

    def _see(self, readings: dict[str, float]) -> tuple[np.ndarray, Info]:
        """Observation and info of these readings."""
        self.state = None  # until it is known: after an error only `reset` helps
        try:
            self.state = self.task.states.encode(readings)
        except ValueError as error:
            raise ValueError(f"{self.task.path}: {error}") from error
        self._readings = readings
        observation = np.array(np.unravel_index(self.state, self.task.states.shape))
        return observation, {"state": self.state, "readings": dict(readings)}


def default_engine(robot: str) -> Engine:
    """The first engine on the robot's card; ``kinematic`` if the first is PyBullet and it is not installed."""
    first = next(iter(ROBOTS[robot].engines))
    if first == "pybullet" and not _has_pybullet():
        return "kinematic"
    return first


@cache
def _has_pybullet() -> bool:
    """Whether PyBullet is installed. If it is not, one line names its replacement."""
    try:
        importlib.import_module("rlrobot_edu.robots.engines.bullet.simulation")
    except ImportError as error:
        # A notebook shows stderr in red, as if something had failed.
        stream = sys.stdout if "ipykernel" in sys.modules else sys.stderr
        note = "Note: arms are geometry alone (engine='kinematic') and touch nothing"
        print(f"{note}: {error}.", file=stream)
        return False
    return True


def _maker(task: Task, engine: Engine, options: dict[str, Any]) -> Callable[[], Robot]:
    """A function that makes the task's robot with these options of its class.

    Raises ValueError if this engine does not simulate the robot, or if its class has no such option; ImportError if the
    engine is not installed.
    """
    engines = ROBOTS[task.robot].engines
    check_name(engine, engines, "engine", f"{task.path}: robot {task.robot!r}")
    module, class_name = engines[engine].split(":")
    robot_class = getattr(importlib.import_module(f"rlrobot_edu.{module}"), class_name)
    settings = ["task", "seed", "engine", "realism", "render_mode", "link"]
    for parameter in signature(robot_class).parameters:
        if parameter not in ("scene", "step_time", "realism"):
            settings.append(parameter)
    for option in options:
        check_name(option, settings, "setting", repr(task.robot))
    return partial(robot_class, task.scene, task.step_time, **options)
