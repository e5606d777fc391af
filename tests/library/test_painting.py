"""The painter of films and stills: what is nearer hides what is behind, and each thing is where it should be."""

import io

import numpy as np
import pytest
from PIL import Image, ImageColor, ImageSequence

import rlrobot_edu as rl
from rlrobot_edu.robots.scene import Scene, Solid, pose
from rlrobot_edu.show.describe import NEAR, losses
from rlrobot_edu.show.film import Film
from rlrobot_edu.show.images import few_colours, gif_of, reduced
from rlrobot_edu.show.in3d.replay import places
from rlrobot_edu.show.painting import lens
from rlrobot_edu.show.painting.frames import Bar, closer, frames
from rlrobot_edu.show.painting.mesh import mesh
from rlrobot_edu.show.painting.painter import FINE, Painter
from rlrobot_edu.show.painting.room import ASPECT, Room, painted
from rlrobot_edu.show.palette import BACKDROP, DARK, LIGHT
from rlrobot_edu.show.story import AT_OBJECT, caption, finding, key_steps
from rlrobot_edu.task.task_file import available_tasks

WIDTH, HEIGHT = 300, 207
BLUE = ImageColor.getrgb(LIGHT["blue"])
RED = ImageColor.getrgb(LIGHT["red"])
SHAPES = [
    ("box", (0.4, 0.2, 0.1)),
    ("cylinder", (0.2, 0.3)),
    ("sphere", (0.2,)),
    ("prism", (0.2, -0.1, 0.0, 0.2, -0.2, -0.1, 0.3)),
]


def room(x: float, y: float, bumped: bool = False) -> Scene:
    """A room of 2 by 2 metres with a robot in it and a wall amid it."""
    solids = (
        Solid("wall/0", "box", (0.6, 0.1, 0.4), pose(0, 0, 0.2), "wall"),
        Solid("robot/body", "cylinder", (0.15, 0.2), pose(x, y, 0.1), "robot"),
    )
    return Scene(solids, np.empty((0, 2, 3)), (-1.0, -1.0, 1.0, 1.0), bumped)


def first_scene(task: str) -> Scene:
    with rl.make_env(
        task, seed=0, engine="kinematic" if "arm" in task else None
    ) as env:
        env.reset(seed=0)
        return env.unwrapped.robot.scene()


def has(image: Image.Image, colour: tuple[int, ...]) -> np.ndarray:
    """Which pixels have this colour."""
    return (np.asarray(image) == colour).all(axis=2)


@pytest.mark.parametrize(("shape", "size"), SHAPES)
def test_faces_look_outside_and_leave_no_gap(shape: str, size: tuple) -> None:
    body = mesh(shape, size)
    for face, normal in zip(body.faces, body.normals, strict=True):
        assert body.corners[face].mean(axis=0) @ normal > 0
    # each side of a face is a side of one other face, the other way round
    places = [tuple(corner) for corner in np.round(body.corners, 9).tolist()]
    sides = []
    for face in body.faces:
        for i in range(len(face)):
            start, end = places[face[i - 1]], places[face[i]]
            if start != end:  # at a pole several corners are one
                sides.append((start, end))
    assert sorted(sides) == sorted((end, start) for start, end in sides)


def test_a_map_keeps_to_one_scale_with_y_upwards() -> None:
    seen = lens.from_above(room(0, 0), WIDTH, HEIGHT)
    points = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1.0)])
    middle, right, up, above = seen.seen(points)
    assert middle[:2] == pytest.approx((WIDTH / 2, HEIGHT / 2))
    scale = right[0] - middle[0]
    assert scale > 0
    assert middle[1] - up[1] == pytest.approx(scale)
    assert above[:2] == pytest.approx(middle[:2])
    assert above[2] > middle[2]


@pytest.mark.parametrize("task", available_tasks())
@pytest.mark.parametrize("look", [lens.eye, lens.from_above])
def test_the_whole_floor_and_all_walls_are_in_the_picture(task: str, look) -> None:
    scene = first_scene(task)
    seen = look(scene, WIDTH, HEIGHT)
    for solid in scene.solids:
        corners = mesh(solid.shape, solid.size).corners
        if solid.role == "wall":
            at = solid.pose[:3, :3] @ corners.T + solid.pose[:3, 3:]
            x, y, _ = seen.seen(at.T).T
            assert -1 < x.min() <= x.max() < WIDTH + 1
            assert -1 < y.min() <= y.max() < HEIGHT + 1


@pytest.mark.parametrize("is_first", [True, False])
def test_what_is_nearer_hides_what_is_behind(is_first: bool) -> None:
    """Whichever is painted first."""
    scene = room(0, 0)
    painter = Painter(
        lens.eye(scene, FINE * WIDTH, FINE * HEIGHT), WIDTH, HEIGHT, "#ffffff"
    )
    box = mesh("box", (0.4, 0.02, 0.3))
    bodies = [(pose(0, -0.3, 0.15), LIGHT["blue"]), (pose(0, 0.3, 0.15), LIGHT["red"])]
    for at, colour in bodies if is_first else bodies[::-1]:
        painter.body(box, at, colour)
    picture = painter.picture()
    x, y = painter.place(np.array([0, -0.3, 0.3]))
    assert has(picture, BLUE)[round(y) - 2 : round(y) + 3, round(x)].any()
    assert has(picture, RED).any()


def test_a_robot_behind_a_wall_is_hidden_and_before_it_is_seen() -> None:
    low = room(0, -0.5)
    assert has(Room(low, WIDTH, HEIGHT).picture(low), BLUE).sum() > 100
    tall = (Solid("wall/1", "box", (1.8, 0.1, 2.0), pose(0, 0.3, 1.0), "wall"),)
    behind = room(0, 0.5)
    behind = behind._replace(solids=behind.solids + tall)
    assert not has(Room(behind, WIDTH, HEIGHT).picture(behind), BLUE).any()


@pytest.mark.parametrize("is_map", [True, False])
def test_the_robot_is_painted_where_it_stands(is_map: bool) -> None:
    for x, y in [(-0.7, -0.7), (0.7, 0.6), (0.0, -0.5)]:
        scene = room(x, y)
        picture = Room(scene, WIDTH, HEIGHT, is_map=is_map).picture(scene)
        look = lens.from_above if is_map else lens.eye
        rows, columns = np.nonzero(has(picture, BLUE))
        top = look(scene, WIDTH, HEIGHT).seen(np.array([[x, y, 0.2]]))[0]
        assert columns.mean() == pytest.approx(top[0], abs=3)
        assert rows.mean() == pytest.approx(top[1], abs=4)


def test_the_same_film_is_painted_with_the_same_bytes() -> None:
    film = Film([room(-0.5 + 0.1 * i, -0.5) for i in range(4)], [1, 1, -2, 0])
    assert film.gif() == film.gif()
    assert film.steps() == film.steps()
    assert painted(film.frames) == painted(film.frames)


def test_a_bump_turns_the_robot_red_and_leaves_a_cross() -> None:
    way = [room(-0.7, -0.5), room(-0.6, -0.5, bumped=True), room(0.6, -0.6)]
    before, bump, after = frames(way, [1.0, -2.0, 1.0], (), WIDTH)
    assert not has(before, RED).any()
    assert has(before, BLUE).sum() > 100
    assert has(bump, RED).sum() > 100
    assert has(after, BLUE).sum() > 100
    assert 0 < has(after, RED).sum() < has(bump, RED).sum()


def test_a_step_stands_out_if_it_lost_a_fifth_of_the_most() -> None:
    assert losses([10, -0.02, -2, -1.9]) == [False, False, True, False]
    assert losses([-0.02, -2, -0.02]) == [False, True, False]
    assert losses([-0.02, -0.02]) == [False, False], "none was worse than another"
    assert losses([0, 0]) == [False, False]


@pytest.mark.parametrize("steps", [1, 2, 5, 6, 7, 60])
def test_key_steps_are_few_and_hold_the_first_the_last_and_where_losses_begin(
    steps: int,
) -> None:
    rng = np.random.default_rng(steps)
    loses = rng.random(steps) < 0.1
    scenes = [room(-0.8 + 0.02 * i, -0.5) for i in range(steps)]
    chosen = key_steps(scenes, np.where(loses, -2.0, 1.0).tolist(), "", 6)
    assert chosen == sorted(set(chosen))
    assert len(chosen) == min(6, steps)
    assert {0, steps - 1} <= set(chosen)
    begin = [i for i in range(1, steps) if loses[i] and not loses[i - 1]]
    assert set(begin[:4]) <= set(chosen)


def test_no_two_key_steps_are_alike() -> None:
    shuttles = [room(0.1 * (i % 3), -0.5) for i in range(60)]
    assert key_steps(shuttles, [1.0] * 60, "", 6) == [0, 1, 59]


def test_the_title_of_a_film_says_what_became_of_it() -> None:
    drives = [room(0.02 * i, 0) for i in range(4)]
    assert finding(drives, [1, 1, 1, 1]) == "Reward +1 in 4 of 4 steps, no bump"
    assert finding(drives, [1, -2, 1, 1]) == "Reward +1 in 3 of 4 steps, 1 loss (−2)"
    bumps = [*drives[:3], drives[3]._replace(bumped=True)]
    assert finding(bumps, [1, 1, 2, -7]) == "Reward +2 in step 3 of 4, 1 bump (−7)"
    assert finding(drives[:1], [-0.5]) == "Reward −0.5 a step in 1 step, no bump"
    assert finding(drives, [1, 1, 1, 1], "Drive").startswith(
        "Drive: reward +1 in 4 of 4"
    )
    part = Solid("robot/upper_arm", "box", (0.1, 0.1, 0.1), np.eye(4), "robot")
    arms = [one._replace(solids=(*one.solids, part)) for one in drives]
    assert finding(arms, [-1, 10, -1, 10]) == "Reward +10 in 2 of 4 steps"


def test_a_page_without_scripts_shows_the_film_and_its_steps() -> None:
    film = Film([room(-0.8 + 0.02 * i, -0.5) for i in range(60)], [1.0] * 59 + [-2.0])
    page = film._repr_mimebundle_()
    html = page["text/html"] if "text/html" in page else page[0]["text/html"]
    assert html.count("<img") == 5
    assert "<script" not in html
    steps = film.steps()
    assert sum(len(still.data) for _, still in steps) < 30_000
    words, _ = steps[-1]
    assert words == "Step 60: end, a loss, reward −2, sum +57"
    title, picture = html.index(film.finding), html.index("image/gif")
    below = html.index(f"<br>{words}")
    assert title < picture < below, "the film comes first"
    assert below < html.index("A square of the floor is 1 m wide.")
    assert words in film.told, "who cannot see it hears the same story"


def test_flat_colours_come_through_a_gif_as_they_are() -> None:
    """Also those that are in one of its pictures alone."""
    pictures = list(
        frames(
            [room(-0.5, -0.5), room(-0.4, -0.5), room(0.5, 0.5)], [1, -2, 1], (), WIDTH
        )
    )
    film = Image.open(io.BytesIO(gif_of(pictures, 32, 100)))
    for picture, kept in zip(pictures, ImageSequence.Iterator(film), strict=True):
        kept = kept.convert("RGB")
        for code in (LIGHT["blue"], LIGHT["red"], LIGHT["floor"], BACKDROP):
            colour = ImageColor.getrgb(code)
            there = has(picture, colour)
            assert has(kept, colour)[there].all(), code


def test_a_gif_shows_each_of_its_pictures() -> None:
    """What does not change is stored once, and is still there in all of them."""
    pictures = list(
        frames([room(0.02 * i, -0.5) for i in range(8)], [1.0] * 8, (), WIDTH)
    )
    colours = few_colours(pictures, 32)
    film = Image.open(io.BytesIO(gif_of(pictures, 32, 100)))
    for picture, kept in zip(pictures, ImageSequence.Iterator(film), strict=True):
        wanted = reduced(picture, colours).convert("RGB")
        assert np.array_equal(np.asarray(kept.convert("RGB")), np.asarray(wanted))


def test_pictures_are_as_high_as_they_say() -> None:
    (picture,) = frames([room(0, -0.5)], [1.0], ["a note"], WIDTH)
    (plain,) = frames([room(0, -0.5)], [1.0], (), WIDTH)
    assert picture.height > plain.height > round(WIDTH / ASPECT)


def test_films_show_only_what_lasers_find_near() -> None:
    """In the picture that is kept and in the live view."""
    orange = ImageColor.getrgb(LIGHT["orange"])
    for length, is_drawn in [(NEAR - 0.1, True), (NEAR + 0.1, False)]:
        scene = room(-0.7, -0.6)
        start = np.array([-0.5, -0.6, 0.2])
        scene = scene._replace(beams=np.array([[start, start + (length, 0, 0)]]))
        picture = Room(scene, WIDTH, HEIGHT).picture(scene)
        assert has(picture, orange).any() == is_drawn
        beam = places(scene)["beams/0"]
        assert (np.linalg.norm(beam[:3, 1]) > 0.1) == is_drawn


def test_key_steps_hold_the_goal_that_the_title_names() -> None:
    scenes = [room(-0.8 + 0.02 * i, -0.5) for i in range(20)]
    rewards = [1.0] * 20
    rewards[7] = 10.0
    assert "eward +10 in step 8" in finding(scenes, rewards)
    assert 7 in key_steps(scenes, rewards, "", 4)


def arm(gap: float) -> Scene:
    """An arm on a table whose fingertips are so far from the object [m]."""
    finger = (0.05, 0.01, 0.02)
    solids = (
        Solid("object", "cylinder", (0.02, 0.05), pose(0.2, 0.0, 0.0), "object"),
        Solid("robot/upper_arm", "box", (0.1, 0.1, 0.1), pose(0, 0, 0.3), "robot"),
        Solid("robot/body", "box", (0.03, 0.03, 0.03), pose(0.1 - gap, 0, 0), "robot"),
        Solid("robot/gripper_2", "box", finger, pose(0.175 - gap, 0.02, 0), "robot"),
        Solid("robot/gripper_3", "box", finger, pose(0.175 - gap, -0.02, 0), "robot"),
    )
    return Scene(solids, np.empty((0, 2, 3)), (-0.5, -0.5, 0.5, 0.5))


def test_the_title_of_an_arms_film_says_whether_it_reached_its_object() -> None:
    far, near = arm(2 * AT_OBJECT), arm(0.8 * AT_OBJECT)

    def told(*scenes: Scene) -> str:
        return finding(scenes, [0.0] * len(scenes), "Reach it")

    assert told(far, near, near) == (
        "Reach it: reached in step 2, and it stays there to step 3"
    )
    assert told(far, near, far) == "Reach it: reached in step 2, there in 1 of 3 steps"
    assert told(far, near) == "Reach it: reached in step 2, there in 1 of 2 steps"
    assert told(arm(0.2), far) == (
        "Reach it: not reached in 2 steps; nearest in step 2, 10 cm away"
    )


def test_captions_tell_the_story_of_an_arm() -> None:
    scenes = [arm(0.3), arm(0.1), arm(0.03), arm(0.02)]
    rewards = [-1.0, 5.0, 10.0, 10.0]
    assert [caption(scenes, rewards, i) for i in range(4)] == [
        "Step 1: start, 30 cm from the object, reward −1, sum −1",
        "Step 2: 10 cm from the object, reward +5, sum +4",
        "Step 3: reaches the object, reward +10, sum +14",
        "Step 4: end, at the object, reward +10, sum +24",
    ]
    many = [arm(0.3)] * 10 + [arm(0.04)] * 10
    assert 10 in key_steps(many, [0.0] * 20, "", 3)


def test_steps_show_the_robot_closer_and_all_the_same_part_of_the_room() -> None:
    way = [room(-0.7, -0.5), room(-0.5, -0.5), room(-0.3, -0.5)]
    pictures = list(frames(way, [1.0] * 3, (), WIDTH))
    near = list(closer(way, pictures, WIDTH // 2))
    assert [picture.size for picture in near] == [(150, 103)] * 3
    whole = [has(picture, BLUE).mean() for picture in pictures]
    assert all(has(a, BLUE).mean() > 1.5 * b for a, b in zip(near, whole, strict=True))
    everywhere = [room(-0.9, -0.9), room(0.9, 0.9)]
    pictures = list(frames(everywhere, [1.0] * 2, (), WIDTH))
    for picture, part in zip(
        pictures, closer(everywhere, pictures, WIDTH), strict=True
    ):
        assert np.array_equal(np.asarray(picture)[:HEIGHT], np.asarray(part))


@pytest.mark.parametrize("width", [372, 560])
def test_the_numbers_in_a_films_bar_do_not_run_into_each_other(width: int) -> None:
    bar = Bar(100, width, has_notes=False)
    ground = np.array(ImageColor.getrgb(DARK["paper"]))
    long = bar.picture(99, -0.02, True, "a loss", -1234.5, "")
    row = np.asarray(long)[: bar.row]
    is_free = (row == ground).all(axis=(0, 2))
    longest, run = 0, 0
    for free in is_free[width // 2 :]:
        run = run + 1 if free else 0
        longest = max(longest, run)
    assert longest >= 8
