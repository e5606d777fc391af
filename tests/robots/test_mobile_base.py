"""The mobile base against geometry: closed-form arcs, exact rays, and walls that hold."""

import hashlib
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import rlrobot_edu as rl
from rlrobot_edu.robots.arenas import ARENAS, Arena, Wall
from rlrobot_edu.robots.chassis import PIONEER
from rlrobot_edu.robots.giraff import Giraff
from rlrobot_edu.robots.mobile_base import MobileBase
from rlrobot_edu.task.robot_cards import LASER_RANGE, LASERS, ROBOTS

WHEEL_RADIUS = PIONEER.wheel_radius
speeds = st.one_of(st.sampled_from([-2.0, -1.0, 0.0, 1.0, 2.0]), st.floats(-2, 2))
ROBOT_OF = {
    "square_2x2": MobileBase,
    "maze_6x6": MobileBase,
    "maze_4x4_goal": MobileBase,
    "hexagon_giraff": Giraff,
}
SCENES = list(ROBOT_OF)


def test_every_arena_of_these_robots_is_tested_here():
    assert set(SCENES) == {*ROBOTS["mobile_base"].scenes, *ROBOTS["giraff"].scenes}


def wheels(left, right):
    return {"left_wheel": float(left), "right_wheel": float(right)}


def in_frame_of(wall, points):
    """`points` (n, 2) as seen from the centre of `wall`, along its length and across it [m]; array (n, 2)."""
    c, s = math.cos(wall.angle), math.sin(wall.angle)
    return (np.asarray(points) - (wall.x, wall.y)) @ np.array([[c, -s], [s, c]])


def overlap(one, two):
    """How deep two convex polygons (n, 2) lie in each other [m], below 0 where they are apart: the separating axes."""
    sides = np.concatenate(
        [np.roll(corners, -1, axis=0) - corners for corners in (one, two)]
    )
    across = np.stack([sides[:, 1], -sides[:, 0]]) / np.hypot(*sides.T)
    (low, high), (low_2, high_2) = (
        ((c @ across).min(axis=0), (c @ across).max(axis=0)) for c in (one, two)
    )
    return np.minimum(high - low_2, high_2 - low).min()


def outline(chassis, readings):
    """Corners of the robot's body on the floor [m]; array (n, 2)."""
    angles = np.linspace(0, 2 * math.pi, 60, endpoint=False)
    corners = np.array(
        chassis.hull
        or chassis.radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    )
    c, s = math.cos(readings["theta"]), math.sin(readings["theta"])
    return corners @ np.array([[c, s], [-s, c]]) + (readings["x"], readings["y"])


def deepest(arena, chassis, readings):
    """How deep the robot is in a wall [m]."""
    body = outline(chassis, readings)
    near = [
        wall
        for wall in arena.walls
        if abs(in_frame_of(wall, body)).min(axis=0)[1] < 0.3
    ]
    return max((overlap(body, wall.corners()) for wall in near), default=-math.inf)


def exact_ray(arena, x, y, angle):
    """Length of the ray from (x, y) to the first wall [m], by the slab method."""
    nearest = math.inf
    for wall in arena.walls:
        start, ahead = in_frame_of(
            wall, [(x, y), (x + math.cos(angle), y + math.sin(angle))]
        )
        half = np.array([wall.length, wall.thickness]) / 2
        with np.errstate(divide="ignore"):
            near, far = np.sort(
                [(-half - start) / (ahead - start), (half - start) / (ahead - start)],
                axis=0,
            )
        if max(near) <= min(far) and max(near) >= 0:
            nearest = min(nearest, max(near))
    return nearest


def exact_lasers(arena, chassis, readings):
    """What each laser should measure from its place on the robot [m]."""
    here, inset, lengths = np.array([readings["x"], readings["y"]]), chassis.inset, []
    for x, y, angle in chassis.lasers:
        c, s = math.cos(readings["theta"]), math.sin(readings["theta"])
        ahead = np.array(
            [math.cos(readings["theta"] + angle), math.sin(readings["theta"] + angle)]
        )
        start = (
            here + (c * x - s * y, s * x + c * y) - inset * ahead
        )  # inside the body, as walls may touch it
        lengths.append(
            min(
                max(0.0, exact_ray(arena, *start, readings["theta"] + angle) - inset),
                LASER_RANGE,
            )
        )
    return lengths


@pytest.fixture
def free_space(monkeypatch):
    monkeypatch.setitem(
        ARENAS, "free_space", Arena((), (-5, -5, 5, 5), (0.0, 0.0, 0.0))
    )


def arc(axle, left, right, seconds, chassis):
    """Where the axle (x, y, theta) is after its wheels rolled for a while, in closed form."""
    x, y, theta = axle
    v = chassis.wheel_radius * (left + right) / 2
    turn = chassis.wheel_radius * (right - left) / chassis.wheel_separation
    if not turn:
        return (
            x + v * seconds * math.cos(theta),
            y + v * seconds * math.sin(theta),
            theta,
        )
    after = theta + turn * seconds
    return (
        x + v / turn * (math.sin(after) - math.sin(theta)),
        y - v / turn * (math.cos(after) - math.cos(theta)),
        after,
    )


@pytest.mark.parametrize(
    ("kind", "lag"),
    [(MobileBase, 0.0), (MobileBase, 0.1), (MobileBase, 0.73), (Giraff, 0.0)],
)
def test_in_free_space_the_axle_follows_the_closed_form_arc_of_the_command_that_acts(
    free_space, kind, lag
):
    rng = np.random.default_rng(7)
    for commands in [
        *rng.uniform(-2, 2, (10, 20, 2)),
        *rng.choice([-2, -1, 0, 1, 2], (10, 20, 2)),
    ]:
        robot, ahead = (
            kind("free_space", 1.0, realism=rl.Realism(lag=lag)),
            kind.chassis.axle,
        )
        axle, former = (ahead, 0.0, 0.0), (0.0, 0.0)
        for left, right in commands:
            readings = robot.act(wheels(left, right))
            axle = arc(
                arc(axle, *former, lag, robot.chassis),
                left,
                right,
                1.0 - lag,
                robot.chassis,
            )
            x, y, former = (
                axle[0] - ahead * math.cos(axle[2]),
                axle[1] - ahead * math.sin(axle[2]),
                (left, right),
            )
            assert math.hypot(readings["x"] - x, readings["y"] - y) < 1e-9
            assert abs(math.remainder(readings["theta"] - axle[2], 2 * math.pi)) < 1e-9
            assert -math.pi < readings["theta"] <= math.pi


def test_a_spin_turns_the_frame_round_the_axle_45_mm_ahead_of_it(free_space):
    readings = MobileBase("free_space", 1.0).act(wheels(-1, 1))
    theta = 2 * 0.0975 / 0.331
    assert readings["theta"] == pytest.approx(theta)
    assert (readings["x"], readings["y"]) == pytest.approx(
        (0.045 - 0.045 * math.cos(theta), -0.045 * math.sin(theta))
    )


@pytest.mark.parametrize("step_time", [0.1, 0.32, 2.0])
def test_a_step_of_any_duration_covers_the_same_ground_a_second(free_space, step_time):
    reading = MobileBase("free_space", step_time).act(wheels(1, 1))
    assert reading["x"] == pytest.approx(WHEEL_RADIUS * step_time)


@settings(max_examples=60, deadline=None)
@given(st.sampled_from(SCENES), st.lists(st.tuples(speeds, speeds), max_size=12))
def test_the_lasers_measure_exactly_to_the_walls(scene, commands):
    robot = ROBOT_OF[scene](scene, 1.0)
    readings = robot.readings
    for left, right in commands:
        readings = robot.act(wheels(left, right))
    exact = exact_lasers(ARENAS[scene], robot.chassis, readings)
    assert [readings[laser] for laser in LASERS] == pytest.approx(exact, abs=1e-9)


def test_the_lasers_stand_inside_the_hull_deeper_than_walls_ever_come():
    tiny = np.array([(-1e-9, -1e-9), (1e-9, -1e-9), (1e-9, 1e-9), (-1e-9, 1e-9)])
    assert all(
        overlap(np.array(PIONEER.hull), tiny + place[:2]) > 0.03
        for place in PIONEER.lasers
    )


def test_the_lasers_see_no_further_than_their_range(free_space):
    assert all(
        MobileBase("free_space", 1.0).readings[laser] == LASER_RANGE for laser in LASERS
    )


@pytest.mark.long
@pytest.mark.parametrize("wall_friction", [0.0, 0.72])
@pytest.mark.parametrize("scene", SCENES)
def test_no_wall_is_entered_by_a_centimetre_in_2000_steps_at_double_speed(
    scene, wall_friction
):
    robot = ROBOT_OF[scene](scene, 1.0, realism=rl.Realism(wall_friction=wall_friction))
    path = []
    for command in np.random.default_rng(3).choice([-2.0, 2.0], (2000, 2)).tolist():
        readings = robot.act(wheels(*command))
        assert deepest(ARENAS[scene], robot.chassis, readings) < 0.01
        path.append((readings["x"], readings["y"]))
    x_min, y_min, x_max, y_max = ARENAS[scene].bounds
    assert ((x_min, y_min) < np.min(path, axis=0)).all() and (
        np.max(path, axis=0) < (x_max, y_max)
    ).all()
    assert (
        np.hypot(*np.diff(path, axis=0).T).max() < 2 * WHEEL_RADIUS + 0.08
    )  # walls push it out, and do not throw it


def test_a_robot_that_pushes_a_wall_stands_still_with_its_front_on_it_and_sees_it():
    robot = MobileBase("square_2x2", 1.0)
    for _ in range(10):
        pushing = robot.act(wheels(2, 2))
    again = robot.act(wheels(2, 2))
    assert (
        again["x"]
        == pytest.approx(pushing["x"], abs=1e-4)
        == pytest.approx(1 - 0.260, abs=0.002)
    )
    assert again["laser_front"] == pytest.approx(0.260 - 0.220, abs=0.002)


def beside_a_wall(monkeypatch, heading, wall_friction):
    """A robot whose front corner touches the right side of a long wall, as it heads into the wall at an angle [rad]."""
    arena = Arena((Wall(0, 0.05, 9),), (-5, -5, 5, 5), (0.0, 0.0, heading))
    top = outline(PIONEER, {"x": 0.0, "y": 0.0, "theta": heading})[:, 1].max()
    monkeypatch.setitem(
        ARENAS, "beside", arena._replace(start=(0.0, -top + 0.001, heading))
    )
    return MobileBase("beside", 1.0, realism=rl.Realism(wall_friction=wall_friction))


def test_a_wall_that_is_grazed_turns_the_robot_along_and_it_slides(monkeypatch):
    robot = beside_a_wall(monkeypatch, math.radians(20), 0.0)
    way = [robot.act(wheels(1, 1)) for _ in range(12)]
    assert abs(way[-1]["theta"]) < math.radians(5)  # flush, or on its way
    assert way[-1]["x"] - way[-2]["x"] == pytest.approx(WHEEL_RADIUS, rel=0.02)


def test_friction_holds_a_robot_at_a_wall_that_it_would_slide_along_and_slows_its_spin(
    monkeypatch,
):
    def way(wall_friction, *command):
        robot = beside_a_wall(monkeypatch, math.radians(45), wall_friction)
        before, after = robot.readings, robot.act(wheels(*command))
        turned = math.remainder(after["theta"] - before["theta"], 2 * math.pi)
        return math.hypot(after["x"] - before["x"], after["y"] - before["y"]), turned

    slid, held = way(0.0, 1, 1), way(0.72, 1, 1)
    assert held[0] < 0.8 * slid[0]
    free, rubbed = way(0.0, -1, 1), way(0.72, -1, 1)
    assert abs(rubbed[1]) < abs(free[1]) - 0.01


@pytest.mark.parametrize("scene", SCENES)
def test_the_robot_starts_clear_of_all_walls(scene):
    start = ROBOT_OF[scene](scene, 1.0).readings
    lasers = [
        "laser_front",
        "laser_front_left",
        "laser_left",
        "laser_right",
        "laser_front_right",
    ]
    clear = {
        "square_2x2": 0.5,
        "maze_6x6": 0.8,
        "maze_4x4_goal": 0.25,
        "hexagon_giraff": 0.25,
    }
    assert min(start[laser] for laser in lasers) > clear[scene]


def fingerprint_of_a_run(robot):
    """All the bits of all readings of 300 random steps after a reset."""
    commands = np.random.default_rng(5).uniform(-2, 2, (300, 2))
    runs = [robot.reset(), *(robot.act(wheels(*command)) for command in commands)]
    return hashlib.sha256(
        np.array([list(readings.values()) for readings in runs]).tobytes()
    ).hexdigest()


@pytest.mark.parametrize(
    "command",
    [
        {"left_wheel": 1.0, "right_weel": 1.0},
        {"left_wheel": 1.0},
        {"left_wheel": 1.0, "right_wheel": 1.0, "gripper": 0.0},
        {"left_wheel": math.nan, "right_wheel": 1.0},
        {"left_wheel": 1.0, "right_wheel": 4.1},
        {"left_wheel": -math.inf, "right_wheel": 0.0},
    ],
)
def test_a_command_that_cannot_be_carried_out_is_refused_and_moves_nothing(command):
    robot = MobileBase("square_2x2", 1.0)
    before = robot.readings
    with pytest.raises(ValueError, match="command"):
        robot.act(command)
    assert robot.readings == before


@pytest.mark.parametrize("scene", SCENES)
def test_the_scene_shows_the_robot_where_its_readings_say_and_beams_as_long_as_they_measure(
    scene,
):
    robot = ROBOT_OF[scene](scene, 1.0)
    robot.act(wheels(1, -1))
    readings = robot.act(wheels(2, 1))
    assert set(readings) == set(ROBOTS["mobile_base"].sensors)
    picture = robot.scene()
    names = [solid.name for solid in picture.solids]
    assert len(set(names)) == len(names)
    body, nose = (
        picture.solids[names.index(name)].pose for name in ("robot/body", "robot/nose")
    )
    assert body[:2, 3] == pytest.approx([readings["x"], readings["y"]])
    ahead = nose[:2, 3] - body[:2, 3]
    assert math.atan2(ahead[1], ahead[0]) == pytest.approx(readings["theta"])
    on_the_robot = (
        np.linalg.inv(body)[:2] @ np.column_stack([picture.beams[:, 0], np.ones(8)]).T
    )
    assert np.allclose(on_the_robot.T, np.array(robot.chassis.lasers)[:, :2])
    wheel = picture.solids[names.index("robot/left_wheel")].pose
    assert (np.linalg.inv(body) @ wheel)[0, 3] == pytest.approx(robot.chassis.axle)
    lengths = np.linalg.norm(picture.beams[:, 1] - picture.beams[:, 0], axis=1)
    assert lengths == pytest.approx([readings[laser] for laser in LASERS])
