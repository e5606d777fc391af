"""Rooms drawn with characters: any text is one or is refused, and in every engine it is the room that was drawn."""

import json
import pickle
import re
from dataclasses import replace

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from hypothesis import example, given, settings
from hypothesis import strategies as st
from in_node import on_its_page
from test_mobile_base import deepest, exact_lasers, wheels

import rlrobot_edu as rl
from rlrobot_edu.robots.arenas import ARENAS, Wall, arena_of
from rlrobot_edu.robots.engines.kinematic.base import KinematicBase, walls_of
from rlrobot_edu.robots.giraff import GIRAFF, Giraff
from rlrobot_edu.robots.mobile_base import PIONEER, MobileBase
from rlrobot_edu.task.drawing import Drawing
from rlrobot_edu.task.robot_cards import LASERS, ROBOTS

CORRIDOR = """
    ###############
    #>            #
    #             #
    ###########   #
              #   #
              # G #
              #####
"""
ROOM = Drawing(CORRIDOR)
BAY = Drawing("""
    +----------+
    |          |
    |  ^  ##   |
    |     ##   |
    |   #  #   |
    |          |
    +----------+
""", cell=0.45)  # fmt: skip


def in_a(room, task="wander_simple", **changed):
    """A task of the toolkit in this room."""
    return replace(rl.load_task(task), scene=room, fingerprint="", **changed)


def cells(room):
    """The same arena, but with a wall of its own for each cell: what `Drawing.walls` must come to."""
    (*lines,), size = room.text.split("\n"), room.cell
    places = [
        (i, j)
        for i, line in enumerate(lines)
        for j, sign in enumerate(line)
        if sign == "#"
    ]
    middle_x, middle_y = len(lines[0]) / 2, len(lines) / 2
    walls = [
        Wall((j + 0.5 - middle_x) * size, (middle_y - i - 0.5) * size, size, size)
        for i, j in places
    ]
    return arena_of(room)._replace(walls=tuple(walls))


signs = st.sampled_from("#+-| .>^<vG\n\t\rS")
rooms = st.builds(
    lambda rows, edge: (
        f"{edge}#######\n"
        + "\n".join(f"{edge}#{row}#" for row in rows)
        + f"\n{edge}#######"
    ),
    st.lists(
        st.text(st.sampled_from("   ..##>G"), min_size=5, max_size=5),
        min_size=1,
        max_size=6,
    ),
    st.sampled_from(["", "  ", "\t"]),
)


@settings(max_examples=400, deadline=None)
@given(st.one_of(rooms, rooms, st.text(signs), st.text()), st.floats(0.05, 10.0))
@example("\n" * 5, 1.0)
@example("###\n#>#\n###\0", 1.0)
@example(" " * 10_000 + "#", 1.0)
def test_any_text_is_a_room_or_is_refused_in_one_sentence(text, cell):
    try:
        room = Drawing(text, cell)
    except ValueError as error:
        assert 10 < len(str(error)) < 300 and "\n" not in str(error)
        return
    assert (
        Drawing(room.text, cell) == room
    )  # its one form is a drawing, too, and the same
    grid = np.array([[*line] for line in room.text.split("\n")])
    covered, (height, width) = np.zeros(grid.shape, dtype=int), grid.shape
    for x_min, y_min, x_max, y_max in room.walls:
        columns = [round(x / cell + width / 2) for x in (x_min, x_max)]
        lines = [round(height / 2 - y / cell) for y in (y_max, y_min)]
        covered[slice(*lines), slice(*columns)] += 1
    assert np.array_equal(covered > 0, grid == "#")
    (x, y, _), (x_min, y_min, x_max, y_max) = room.start, room.bounds
    assert x_min < x < x_max and y_min < y < y_max
    inside, ahead = (
        set(),
        [tuple(int(k) for k in np.argwhere(np.isin(grid, [*">^<v"]))[0])],
    )
    while ahead:  # step by step, no way leads out of the drawing
        i, j = ahead.pop()
        assert 0 <= i < height and 0 <= j < width
        if (i, j) not in inside and grid[i, j] != "#":
            inside.add((i, j))
            ahead += [(i - 1, j), (i + 1, j), (i, j - 1), (i, j + 1)]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (["###"], "a drawing is a text of lines, got ['###']"),
        ("", "the drawing is empty: draw walls"),
        (" \n\t\n", "the drawing is empty: draw walls"),
        (
            "####\n#S #\n####",
            "line 2, column 2 of the drawing is 'S', expected one of # . > ^ < v G",
        ),
        (
            "\n\n    ####\n    #> #\n    ##=#\n",
            "line 3, column 3 of the drawing is '=', expected one of",
        ),
        (
            "####\n#  #\n####",
            "needs one start, > ^ < v, and at most one goal, G; this one has 0 and 0",
        ),
        (
            "####\n#<v#\n####",
            "needs one start, > ^ < v, and at most one goal, G; this one has 2 and 0",
        ),
        (
            "#####\n#>GG#\n#####",
            "needs one start, > ^ < v, and at most one goal, G; this one has 1 and 2",
        ),
        (
            "#####\n#> \n#####",
            "the room is not closed: it can be left in line 2, column 5",
        ),
        (
            "#####\n#>  #\n## ##",
            "the room is not closed: it can be left in line 3, column 3",
        ),
        (">", "the room is not closed: it can be left in line 1, column 1"),
        (
            "#####\n#>#G#\n#####",
            "the goal, in line 2, column 4 of the drawing, is walled off from the start",
        ),
        ("#" * 81, "the drawing is too big: 1 lines of 81 characters; at most 80"),
        ("#\n" * 81, "the drawing is too big: 81 lines of 1 characters; at most 80"),
    ],
)
def test_what_is_no_room_is_refused_with_what_is_wrong_and_where(text, expected):
    with pytest.raises(ValueError) as error:
        Drawing(text)
    assert expected in str(error.value)


@pytest.mark.parametrize("cell", [0, 0.04, 11, float("nan"), "1", None, 10**400])
def test_a_cell_of_no_size_is_refused(cell):
    with pytest.raises(
        ValueError,
        match=r"the cell of a drawing must be a number of metres, at least 0.05 and at most",
    ):
        Drawing(CORRIDOR, cell)


@pytest.mark.parametrize(
    "same",
    [
        CORRIDOR.replace("\n", "\r\n"), re.sub("(?m)^    ", "\t", CORRIDOR), CORRIDOR.replace("#\n", "#  \t\n"),
        CORRIDOR.replace("#", "+"), CORRIDOR.replace(" ", "."), CORRIDOR.strip(), f"\n\n  \n{CORRIDOR}\n\n",
        "\n".join(line[4:] for line in CORRIDOR.split("\n")),
        CORRIDOR.replace("    ###############\n", "###############\n", 1).strip("\n"), ROOM.text,
    ],
)  # fmt: skip
def test_line_ends_tabs_indentation_and_signs_that_mean_the_same_do_not_matter(same):
    drawing = Drawing(same)
    assert (
        drawing == ROOM and hash(drawing) == hash(ROOM) and drawing.walls == ROOM.walls
    )
    assert in_a(drawing).scene == in_a(ROOM).scene


def test_a_room_whose_first_line_is_not_its_leftmost_is_drawn_as_it_stands():
    for text in (
        "  ####\n###  #\n#> ###\n####",
        "\n      ####\n    ###  #\n    #> ###\n    ####\n",
    ):
        assert Drawing(text).text == "..####\n###..#\n#>.###\n####.."


def test_it_reads_and_prints_as_it_was_drawn():
    assert (
        eval(repr(ROOM), {"Drawing": Drawing})
        == ROOM
        == pickle.loads(pickle.dumps(ROOM))
    )
    where = "x = 0, y = 0 is its middle; x = -0.5 to 0.5 m, y = -0.5 to 0.5 m; 4 walls"
    assert (
        str(Drawing("###\n#>#\n###", 1))
        == f"a drawing, each character 1.0 m:\n###\n#>#\n###\n{where}"
    )
    assert Drawing(CORRIDOR, 0.7) != ROOM and ROOM != BAY


def test_walls_are_few_and_long_and_no_straight_face_has_a_seam():
    assert len(Drawing("########\n#>     #\n########").walls) == 4
    assert (
        len(Drawing("##########\n##>     ##\n##      ##\n##########").walls) == 4
    )  # thick ones, too
    assert len(ROOM.walls) == 6
    lines = [f"##{'.' * 30}##" for _ in range(30)]
    busy = Drawing("\n".join(["#" * 34, "##>" + "." * 29 + "##", *lines, "#" * 34]))
    assert len(busy.walls) == 4


def test_the_places_are_those_of_the_drawing():
    room = Drawing("#####\n#  G#\n# v #\n#   #\n#####", cell=2)
    assert (
        room.start == (0, 0, -np.pi / 2)
        and room.goal == (2, 2, 1)
        and room.bounds == (-3, -3, 3, 3)
    )


def test_the_card_says_how_large_the_robots_are():
    x, y = np.array(PIONEER.hull).T
    assert ROBOTS["mobile_base"].size == pytest.approx([np.ptp(x), np.ptp(y)])
    assert ROBOTS["giraff"].size == pytest.approx([2 * GIRAFF.radius] * 2)


def test_a_robot_that_does_not_fit_where_it_starts_is_refused_with_the_task():
    for text in ("#####\n#>  #\n#####", "###\n#^#\n# #\n# #\n###"):
        with pytest.raises(
            ValueError,
            match="does not fit where it starts in the drawing; make its cells larger",
        ):
            in_a(Drawing(text, cell=0.5))  # its back would be a centimetre in the wall
        in_a(Drawing(text, cell=0.52))
    in_a(
        Drawing("#####\n# > #\n#####", cell=0.42)
    )  # along a corridor it needs its width alone
    with pytest.raises(ValueError, match="does not fit"):
        in_a(Drawing("#####\n# v #\n#####", cell=0.42))
    with pytest.raises(
        ValueError, match=r"robot 'arm' has no scene Drawing\(.*It has: table"
    ):
        in_a(ROOM, "arm_1k")


def drives(kind, room, n, seed=0, step_time=1.0):
    """What a robot senses at each of `n` random steps, forward more often than backward."""
    robot = kind(room, step_time)
    speeds = np.random.default_rng(seed).choice([-1.0, 1.0, 1.0, 2.0], (n, 2))
    return [robot.readings, *(robot.act(wheels(*pair)) for pair in speeds)]


def bullet():
    module = pytest.importorskip(
        "rlrobot_edu.robots.engines.bullet.mobile_base", exc_type=ImportError
    )
    return module.BulletBase


@pytest.mark.parametrize("room", [ROOM, BAY], ids=["corridor", "bay"])
@pytest.mark.parametrize(
    "kind", [MobileBase, KinematicBase, Giraff, bullet], ids=lambda kind: kind.__name__
)
def test_the_lasers_measure_to_the_cells_that_were_drawn_and_no_wall_is_entered(
    kind, room
):
    kind, chassis = (
        bullet() if kind is bullet else kind,
        getattr(kind, "chassis", PIONEER),
    )
    real = cells(room)
    for readings in drives(kind, room, 60):
        exact = exact_lasers(real, chassis, readings)
        assert [readings[laser] for laser in LASERS] == pytest.approx(exact, abs=1e-6)
        if chassis.hull:
            assert deepest(real, chassis, readings) < 0.01


def test_the_engines_agree_in_a_drawn_room_as_long_as_nothing_is_hit():
    ways = []
    for kind in (MobileBase, KinematicBase, bullet()):
        robot = kind(ROOM, 1.0)
        ways.append(
            [
                robot.act(wheels(*pair))
                for pair in [(1, 1)] * 5 + [(0, 1)] * 2 + [(1, 0)] * 3 + [(1, 1)] * 3
            ]
        )
    for one, other, rolling in zip(*ways, strict=True):
        assert other == pytest.approx(one, abs=1e-6)
        assert [rolling[name] for name in "xy"] == pytest.approx(
            [one[name] for name in "xy"], abs=0.02
        )
        assert rolling["laser_left"] == pytest.approx(one["laser_left"], abs=0.1)


@pytest.mark.parametrize("kind", [MobileBase, KinematicBase])
def test_the_square_drawn_with_the_same_measures_is_the_square_of_the_toolkit(
    kind, monkeypatch
):
    inside, its = "\n".join(["#" + "." * 20 + "#"] * 19), arena_of("square_2x2")
    edge, row = "#" * 22, "#.........>..........#"
    mine = arena_of(Drawing(f"{edge}\n{inside}\n{row}\n{edge}", cell=0.1))._replace(
        start=its.start
    )
    assert mine.bounds == pytest.approx(its.bounds)
    order = [
        next(w for w in mine.walls if (w.x, w.y) == pytest.approx((o.x, o.y)))
        for o in its.walls
    ]
    for wall, other in zip(order, its.walls, strict=True):
        assert sorted(wall.corners().round(9).tolist()) == sorted(
            other.corners().round(9).tolist()
        )
    # which wall pushes first is a matter of their order, and of a bounce's last digits
    monkeypatch.setitem(ARENAS, "drawn", mine._replace(walls=tuple(order)))
    for its, mine in zip(
        drives(kind, "square_2x2", 100), drives(kind, "drawn", 100), strict=True
    ):
        assert mine == pytest.approx(its, abs=1e-6)


@pytest.mark.parametrize("kind", [MobileBase, KinematicBase])
def test_along_a_wall_of_many_cells_a_robot_glides_as_along_one(kind):
    edge, free = "#" * 42, "#" + "." * 40 + "#"
    robot = kind(
        Drawing(
            "\n".join([edge, free, "#.>".ljust(41, ".") + "#", free, edge]), cell=0.3
        ),
        1.0,
    )
    places = [
        robot.act(wheels(1.0, 1.05))["x"] for _ in range(60)
    ]  # it leans against the wall on its left
    assert robot.readings["y"] > 0.2 and np.diff(places).min() > 0.05


def test_scenes_films_and_three_dimensions_show_the_walls(tmp_path):
    task = in_a(ROOM)
    env = rl.make_env(task, seed=0, render_mode="rgb_array")
    env.reset(seed=0)
    assert env.render().std() > 10
    scene = env.unwrapped.robot.scene()
    assert [solid.role for solid in scene.solids].count(
        "wall"
    ) == 6 and scene.bounds == ROOM.bounds
    assert [solid.name for solid in scene.solids if solid.role == "goal"] == ["goal"]
    assert rl.plot_scene(scene).still().alt
    film = rl.film(rl.Agent(task, seed=0), env, steps=3)
    film.save(tmp_path / "film.html")
    pytest.importorskip("meshcat")
    film.show3d().save(tmp_path / "film3d.html")
    assert (tmp_path / "film3d.html").stat().st_size > 10_000


def test_a_page_in_javascript_lives_the_same_life_in_a_drawn_room():
    task = in_a(BAY)
    agent, env = (
        rl.Agent(task, "TOSL+QBIASSR", seed=4),
        rl.make_env(task, seed=3, engine="kinematic"),
    )
    stepper = rl.Stepper(agent, env, at=150)
    relived = "((relived) => { for (let i = 0; i < 150; i++) relived.step(); return relived; })"
    q = on_its_page(
        stepper,
        f"{relived}(new Relived(stepper.about, lives, {{}})).life.m.q.map((row) => [...row])",
    )
    assert np.array_equal(stepper._tape.q, q)


def test_gymnasium_registers_a_task_in_a_drawn_room():
    gymnasium.register(
        "drawn-v0",
        entry_point="rlrobot_edu.environments:make_env",
        kwargs={"task": in_a(ROOM)},
    )
    try:
        check_env(gymnasium.make("drawn-v0").unwrapped, skip_render_check=True)
    finally:
        del gymnasium.registry["drawn-v0"]


def test_a_recording_keeps_the_drawing_line_by_line_and_asks_for_the_same(tmp_path):
    task = in_a(BAY)
    recording = rl.record(rl.Agent(task, seed=0), rl.make_env(task, seed=0), steps=30)
    recording.save(tmp_path)
    package = json.loads((tmp_path / "datapackage.json").read_text())
    assert package["rlrobot"]["scene"] == {"lines": BAY.text.split("\n"), "cell": 0.45}
    assert rl.Recording.load(tmp_path, task).source == recording.source
    for other in (ROOM, "square_2x2"):
        with pytest.raises(
            ValueError,
            match="not a recording of task wander_simple: scene is a drawing",
        ):
            rl.Recording.load(tmp_path, in_a(other))
    for spoilt in (
        {},
        {"lines": ["#"], "cell": 1},
        {"lines": 3, "cell": 1},
        {"lines": [3], "cell": 1},
        {"lines": []},
    ):
        package["rlrobot"]["scene"] = spoilt
        (tmp_path / "datapackage.json").write_text(json.dumps(package))
        with pytest.raises(ValueError, match="put back the original file") as error:
            rl.Recording.load(tmp_path)
        assert str(error.value).startswith(
            f"{tmp_path / 'datapackage.json'}: "
        ) and "\n" not in str(error.value)


@pytest.mark.long
def test_agents_compare_in_a_drawn_room_in_any_number_of_processes_and_a_store_knows_the_room(
    tmp_path,
):
    task, rewards = in_a(BAY), []
    for jobs, store in ((1, tmp_path), (2, None)):
        result = rl.compare(
            task, ["Q+SR"], 2, steps=40, n_jobs=jobs, progress=False, store=store
        )
        rewards.append([history.rewards for history in result["Q+SR"]])
    assert np.array_equal(*rewards)
    with pytest.raises(ValueError, match="has another experiment: scene is"):
        rl.compare(
            in_a(ROOM), ["Q+SR"], 2, steps=40, n_jobs=1, progress=False, store=tmp_path
        )
    agent = rl.Agent(task, "Q+SR", seed=0)
    rl.learn(agent, rl.make_env(task, seed=0), steps=50, progress=False)
    agent.save(tmp_path / "agent.npz")
    assert np.array_equal(rl.Agent.load(tmp_path / "agent.npz").q, agent.q)


def test_a_copy_of_the_environment_goes_on_in_the_same_room():
    env = rl.make_env(in_a(BAY), seed=0)
    env.reset(seed=1)
    twin = pickle.loads(pickle.dumps(env))
    for a in np.random.default_rng(0).integers(4, size=30):
        assert env.step(int(a))[4] == twin.step(int(a))[4]


def test_the_drawn_walls_are_what_the_kernels_get():
    assert walls_of(arena_of(ROOM)).shape == (6, 6)
