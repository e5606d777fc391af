"""The room of pages: a place lands where Python puts it, and what is drawn is what happened."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from matplotlib.figure import Figure

import rlrobot_edu as rl
from rlrobot_edu.robots.scene import Scene, Solid, pose
from rlrobot_edu.show.describe import loss_of
from rlrobot_edu.show.palette import DARK, LIGHT
from rlrobot_edu.show.room.scene_data import (
    moving_data,
    near_of,
    scene_data,
)
from rlrobot_edu.show.room.tokens import look, tokens
from rlrobot_edu.show.top_down import footprint
from rlrobot_edu.task.robot_cards import LASERS
from rlrobot_edu.task.task_file import load_task

ROOM = files("rlrobot_edu.show.room") / "room.js"
DRIVER = Path(__file__).parents[1] / "javascript" / "room.js"
SCENE = {
    "bounds": [0, 0, 4, 2],
    "walls": [],
    "solids": [],
    "beams": [],
    "place": [1, 1, 0],
    "outline": [[0.2, 0], [-0.2, 0.2], [-0.2, -0.2]],
}
DRAW = """
const { canvas, told } = paint(400, 200);
drawRoom(canvas, given.scene, { colours, ...given.options });
return told;
"""

needs_node = pytest.mark.skipif(
    shutil.which("node") is None, reason="node is missing: it runs JavaScript"
)


@pytest.fixture(scope="module")
def run():
    """Runs a program with room.js, see tests/javascript/room.js."""
    process = subprocess.Popen(
        ["node", str(DRIVER), str(ROOM)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )

    def run(program, **given_to_it):
        process.stdin.write(json.dumps({"program": program, "given": given_to_it}))
        process.stdin.write("\n")
        process.stdin.flush()
        return json.loads(process.stdout.readline())

    yield run
    process.stdin.close()
    process.stdout.close()
    assert process.wait(60) == 0


def drawn(run, scene=None, **options):
    """What is drawn of a scene: how, in which colour, along which points."""
    return run(DRAW, scene={**SCENE, **(scene or {})}, options=options)


lengths = st.floats(0.5, 10)
pixels = st.integers(200, 1500)


@needs_node
@settings(max_examples=30, deadline=None)
@given(
    low=st.tuples(st.floats(-5, 5), st.floats(-5, 5)),
    wide=lengths,
    high=lengths,
    width=pixels,
    height=pixels,
)
def test_a_place_lands_where_matplotlib_puts_it(run, low, wide, high, width, height):
    x, y = low
    bounds = [x, y, x + wide, y + high]
    margin = 0.02 * max(wide, high)
    ax = Figure((width / 100, height / 100), dpi=100).add_axes((0, 0, 1, 1))
    ax.set_xlim(x - margin, x + wide + margin)
    ax.set_ylim(y - margin, y + high + margin)
    ax.set_aspect("equal", anchor="C")
    ax.apply_aspect()
    point = [x + 0.3 * wide, y + 0.9 * high]
    left, up = ax.transData.transform(point)
    program = """
    const view = RoomView.of(given.bounds, given.width, given.height);
    const at = view.at(...given.point);
    return [at, view.from(...at)];
    """
    at, back = run(program, bounds=bounds, width=width, height=height, point=point)
    assert at == pytest.approx([left, height - up], abs=1e-6)
    assert back == pytest.approx(point, abs=1e-9)


@needs_node
def test_a_robot_lies_where_its_body_is_in_the_scene(run):
    env = rl.make_env("wander_1k", seed=0, engine="kinematic")
    env.reset()
    for a in (8, 1, 1, 8):
        env.step(a)
    scene = env.unwrapped.robot.scene()
    body = next(each for each in scene.solids if each.name == "robot/body")
    told = run(
        """
        const view = RoomView.of(given.bounds, 600, 600);
        const of = (points) => points.map(([x, y]) => view.at(x, y));
        return [given.outline.map((point) => view.seenFrom(given.place, point)), of(given.body)];
        """,
        **scene_data(scene),
        body=footprint(body).tolist(),
    )
    np.testing.assert_allclose(*told, atol=0.3)


@needs_node
def test_the_way_is_green_grey_or_red_and_begins_anew_where_it_was_put(run):
    trail = [
        [0, 0, None],
        [1, 0, 10],
        [2, 0, -0.1],
        [3, 0, -2],
        [0, 1, None],
        [1, 1, 5],
    ]
    told = drawn(run, trail=trail, loss=-2)
    lines = [colour for how, colour, path in told if how == "stroke" and len(path) == 2]
    assert lines == ["floor", "green", "grey", "red", "green"]
    crosses = [path for _, colour, path in told if colour == "red" and len(path) == 4]
    assert len(crosses) == 1
    middle = np.mean(crosses[0], axis=0)
    assert middle[0] > 250, "at the third step"


@needs_node
@pytest.mark.parametrize(
    "near, seen", [(None, 2), (1.0, 1), ([1.0, 3.0], 2), ([0, 3], 1)]
)
def test_only_near_rays_are_drawn_each_with_a_dot(run, near, seen):
    beams = [[1, 1, 1.5, 1], [1, 1, 3, 1]]
    told = drawn(run, {"beams": beams}, near=near)
    orange = [how for how, colour, _ in told if colour == "orange"]
    assert orange == ["stroke", "fill"] * seen


@needs_node
def test_a_bump_makes_the_robot_red_with_a_ring_and_a_word(run):
    calm = drawn(run, trail=[[0, 0, None], [1, 1, -0.5]], loss=-2)
    bump = drawn(run, trail=[[0, 0, None], [1, 1, -2]], loss=-2)
    assert ["text", "red", "bump!"] not in [[*each[:2], each[2][0][0]] for each in calm]
    assert ["text", "red", "bump!"] in [[*each[:2], each[2][0][0]] for each in bump]
    bodies = [colour for how, colour, path in calm if how == "fill" and len(path) == 3]
    assert bodies == ["blue", "on-blue"]
    bodies = [colour for how, colour, path in bump if how == "fill" and len(path) == 3]
    assert bodies == ["red", "on-blue"]


@needs_node
def test_the_bar_tells_step_reward_sum_and_one_metre(run):
    bar = {"step": 7, "of": 60, "reward": -2, "sum": 12.5}
    told = drawn(run, bar=bar, loss=-2)
    words = {path[0][0]: colour for how, colour, path in told if how == "text"}
    assert set(words) == {"step 7", "of 60", "−2", "so far 12.5", "1 m"}
    assert words["−2"] == "red"
    metre = told[[each[2][0][0] for each in told].index("1 m") - 1][2]
    at_0, at_1 = run(
        "const v = RoomView.of(given.bounds, 400, 160); return [v.at(0, 0)[0], v.at(1, 0)[0]]",
        bounds=SCENE["bounds"],
    )
    assert metre[1][0] - metre[0][0] == pytest.approx(at_1 - at_0)


def test_a_robot_that_drives_is_one_sign_and_an_arm_is_its_parts():
    data = scene_data(rl.make_env("navigation_1k", seed=0).unwrapped.robot.scene())
    assert [role for role, _ in data["solids"]] == ["goal"]
    assert data["place"] is not None and len(data["beams"]) == 8
    assert min(x for x, _ in data["outline"]) < 0 < max(x for x, _ in data["outline"])
    box = Solid("robot/body", "box", (0.1, 0.1, 0.1), pose(0, 0, 0), "robot")
    arm = moving_data(Scene((box,), np.zeros((0, 2, 3)), (0, 0, 1, 1)))
    assert arm["place"] is None and [role for role, _ in arm["solids"]] == ["robot"]


def test_what_is_near_and_what_is_lost_comes_from_the_task():
    wander = load_task("wander_1k")
    used = {each.name for each in wander.inputs}
    assert near_of(wander) == [0.8 if name in used else 0.0 for name in LASERS]
    assert near_of(load_task("worked_example")) is None
    assert loss_of(wander.rewards) == -2
    assert loss_of(load_task("navigation_1k").rewards) == -2
    assert loss_of(load_task("arm_1k").rewards) is None
    assert loss_of([1.0, 0.0]) is None


def test_every_colour_of_the_palette_is_a_token_light_and_dark():
    found = re.findall(r"--([\w-]+): light-dark\((#\w+), (#\w+)\);", tokens())
    assert {name: light for name, light, _ in found} == LIGHT
    assert {name: dark for name, _, dark in found} == DARK


# Files that hold a colour of their own, and why
OWN_COLOURS = {
    "show/palette.py": "the list itself",
    "widgets/playground/host_page.js": "a page around it that has no colour is white",
    "widgets/stage/style.css": "its shadows",
    "widgets/stage/view.js": "white light on a wall",
}


def test_only_the_palette_lists_colours():
    folder = Path(rl.__file__).parent
    found = set()
    for kind in ("py", "css", "js", "html"):
        for path in folder.rglob(f"*.{kind}"):
            text = path.read_text("utf-8")
            if re.search(r"#[0-9a-fA-F]{3,8}\b|rgba?\(\d|0x[0-9a-fA-F]{6}\b", text):
                found.add(path.relative_to(folder).as_posix())
    assert found == set(OWN_COLOURS)


def test_the_colours_that_are_used_are_in_the_palette():
    script = ROOM.read_text("utf-8")
    listed = script.partition("ROOM_COLOURS = [")[2].partition("];")[0]
    names = set(re.findall(r'"([\w-]+)"', listed))
    used = set(re.findall(r"colours\.(\w+)", script))
    assert used <= names <= set(LIGHT)
    own = {"serif", "sans", "round", "round-button"}
    assert set(re.findall(r"var\(--([\w-]+)\)", look())) <= set(LIGHT) | own
