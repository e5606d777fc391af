"""A learner's own task file: Python text whose parts are good or odd. It is run, so nothing in it could do harm."""

from __future__ import annotations

from hypothesis import strategies as st

import rlrobot_edu as rl
from fuzz import things
from fuzz.contract import attempt
from fuzz.strategies import Draw
from fuzz.targets import Case, Target, lay, snapshot, unchanged
from fuzz.values import value

FILE = """{doc}
from rlrobot_edu import InputVariable, OutputVariable, Task
from rlrobot_edu.task.drawing import Drawing
import sys
nan, inf = float("nan"), float("inf")

def command(values):
    {command}

def reward(before, after):
    {reward}

def goal(readings):
    {goal}

task = Task(
    robot={robot}, scene={scene}, inputs={inputs}, outputs={outputs}, rewards={rewards}, reward=reward, command={own},
    step_time={step_time}, episode_steps={episode_steps}, goal={goal_given}, goal_steps={goal_steps},
)
{end}
"""
ODD = [
    "None", "0", "-1", "10**400", "1e9", "1e-9", "nan", "inf", "'x'", "[]", "()", "{}", "...", "1j", "sys.exit",
    "object()", "[nan]", "True", "'x' * 10**5", "'a\\nb'", "[[1]]", "b'x'", "lambda: 0", "2**63", "range(10)", "0.5",
]  # fmt: skip
DOES = [
    "sys.exit()", "sys.exit('x')", "raise KeyError('x')", "raise SystemExit", "raise Exception", "return 1 / 0",
    "pass", "yield 1", "raise RecursionError", "raise ValueError('a\\nb')", "assert False", "raise ValueError",
    "return command(None)",
]  # fmt: skip
INPUTS = [
    "[InputVariable('laser_front', cuts=[0.2, 0.1], unit='m')]", "[InputVariable('theta', sectors=10**7, unit='rad')]",
    "[InputVariable('x', cuts=[1e308], unit='m')]", "[InputVariable('theta', values=[0], unit='rad')]",
    "[InputVariable('x')]",
]  # fmt: skip
OUTPUTS = [
    "[OutputVariable('left_wheel', values=[-1, 9], unit='rad/s')]",
    "[OutputVariable('x', values=[1])]",
]
DOCS = [
    "",
    "#",
    '""',
    '"""\n\n"""',
    "'''<b>'''",
    "3",
    "nonsense here",
    "\ufeff",
    "\t",
    "sys.exit()",
]
ENDS = [
    "del task", "task = None", "sys.exit()", "raise KeyError", "(", "\0", "task.name = 3", "x = 1 / 0", "del __doc__",
]  # fmt: skip
NAMES = [
    "mine copy.py", "é.py", "a-b.py", "class.py", ".py", "a.b.py", "<b>.py", "$x$.py", "x" * 200 + ".py",
    "wander_1k.py", "1.py",
]  # fmt: skip


def does(*good: str) -> st.SearchStrategy[str]:
    """The body of a function."""
    return value(*good, other=[*DOES, *(f"return {x}" for x in ODD)])


def usually(*good: str, other: list[str] = ODD) -> st.SearchStrategy[str]:
    """Nine times in ten one of the good ones, since there are many parts."""
    return st.integers(0, 9).flatmap(
        lambda i: value(*good, other=other) if i == 0 else st.sampled_from(good)
    )


def drawings() -> st.SearchStrategy[str]:
    """Rooms with something odd in them, and a few that are sound."""
    rows = st.lists(
        st.text("   .#>^vGS\t", min_size=4, max_size=6).map("##{}##".format), max_size=5
    )
    rooms = rows.map(lambda rows: "\n".join(["##########", *rows, "##########"]))
    cells = st.sampled_from(["0.6", "0.06", "9", *ODD])
    return st.builds(
        "Drawing({!r}, cell={})".format, rooms | st.text(max_size=30), cells
    )


PARTS = dict(
    doc=usually('"""A task."""', other=DOCS),
    command=does("return values"),
    reward=does("return 10.0 if after['x'] > before['x'] else -0.02", "return -0.02"),
    goal=does("return False", "return True"),
    robot=usually("'mobile_base'", other=["'giraff'", "'arm '", *ODD]),
    scene=st.one_of(usually("'square_2x2'", other=["'maze_6x6'", *ODD]), drawings()),
    inputs=usually("[InputVariable('laser_front', cuts=[0.2], unit='m')]", other=INPUTS + ODD),
    outputs=usually("[OutputVariable(w, values=[-1, 1], unit='rad/s') for w in ('left_wheel', 'right_wheel')]",
    other=OUTPUTS + ODD),
    rewards=usually("[-0.02, 10]", other=["[1e308, 1e308]", "[5e-324]", "[10, nan]", "[-0.02, 10] * 1000", *ODD]),
    own=usually("None", "command"),
    step_time=usually("1.0", "0.1"),
    episode_steps=usually("None", "20"),
    goal_given=usually("None", "goal"),
    goal_steps=usually("1"),
    end=usually("", other=ENDS),
)  # fmt: skip


@st.composite
def files(draw: Draw) -> Case:
    """A task file; the end of some is missing, others begin with bytes that are no text."""
    data = FILE.format(**{name: draw(part) for name, part in PARTS.items()}).encode()
    match draw(st.integers(0, 19)):
        case 0:
            data = data[: draw(st.integers(0, len(data)))]
        case 1:
            data = (
                draw(
                    st.sampled_from(
                        [b"\xff", b"\x00", b"\xef\xbb\xbf", b"# coding: nonsense\n"]
                    )
                )
                + data
            )
    return {draw(st.sampled_from(["mine.py"] * 30 + NAMES)): data}


def attack(case: Case) -> str:
    """Load it, build its robot, let an agent learn."""
    lay(case)
    before, tasks, envs = snapshot(), [], []
    answer = attempt(lambda: tasks.append(rl.load_task(*case)))
    for task in tasks:
        attempt(lambda task=task: repr(task))
        answer = attempt(lambda task=task: envs.append(rl.make_env(task, 0)))
        for env in envs:
            answer = attempt(
                lambda task=task, env=env: things.usable_agent(
                    rl.Agent(task, seed=0), env, 10
                )
            )
    unchanged(before, ("./again",))
    return answer


TARGETS = [Target("task_file", files(), 9, attack)]
