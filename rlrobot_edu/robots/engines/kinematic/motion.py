"""The mobile base in a plane: arcs, walls that push its hull away, and rays; scalars, arrays and loops alone.

place: array (3,), x and y of the axle, the point midway between the wheels [m], and the heading [rad]
walls: array (n, 6), each a box: x and y of its centre, half its length and half its thickness [m], cos and sin of the
    direction of its length
hull: array (m, 4), each a corner of the convex outline, counter-clockwise, and the outward normal of the side that
    begins there: x, y [m], normal's x, normal's y; as the robot sees them from its axle
"""

import math

from rlrobot_edu.jit.dispatcher import compiled

SUBSTEP = 0.05  # longest piece of a motion along a wall [s]
CLEARANCE = 1e-6  # how far from a wall the hull is put [m]
ROUNDS = 8  # of pushing, for a hull between several walls


@compiled
def sine(x):
    """sin x to 15 digits, from its Taylor series, x − x³/3! + …, about the nearest multiple of π.

    The sines of C, of numba and of browsers differ in their last bits. A robot's life would soon be another one then.
    """
    turns = math.floor(
        x * (1 / math.pi) + 0.5
    )  # here and below products, for quotients take several times as long
    x -= turns * math.pi
    y = x * x
    end = 1 / 6227020800 - y * (
        1 / 1307674368000 - y * (1 / 355687428096000 - y * (1 / 121645100408832000))
    )
    end = 1 / 5040 - y * (1 / 362880 - y * (1 / 39916800 - y * end))
    x *= 1 - y * (1 / 6 - y * (1 / 120 - y * end))
    return x if turns % 2 == 0 else -x


@compiled
def cosine(x):
    """cos x, as `sine`."""
    return sine(x + math.pi / 2)


@compiled
def follow_arc(place, v, omega, seconds):
    """Drive at v [m/s] while turning to the left at omega [rad/s]: an arc, whose chord points half a turn to the left.

    The chord of an arc is sin(turn/2) / (turn/2) times as long as the arc. `place` is changed where it stands.
    """
    half_turn, chord = omega * seconds / 2, v * seconds
    if half_turn != 0.0:
        chord *= sine(half_turn) / half_turn
    place[0] += chord * cosine(place[2] + half_turn)
    place[1] += chord * sine(place[2] + half_turn)
    place[2] += 2 * half_turn


@compiled
def is_near(place, reach, walls, i):
    """Whether wall i is nearer to the axle than `reach` [m]."""
    dx, dy = place[0] - walls[i, 0], place[1] - walls[i, 1]
    along = max(abs(dx * walls[i, 4] + dy * walls[i, 5]) - walls[i, 2], 0.0)
    across = max(abs(dy * walls[i, 4] - dx * walls[i, 5]) - walls[i, 3], 0.0)
    return along * along + across * across < reach * reach


@compiled
def walls_within(place, reach, walls, near):
    """How many walls are nearer to the axle than `reach` [m]; their numbers are put at the beginning of `near`."""
    n = 0
    for i in range(walls.shape[0]):
        if is_near(place, reach, walls, i):
            near[n] = i
            n += 1
    return n


@compiled
def gap_to_wall(place, cos, sin, hull, walls, i, enough, touch):
    """Gap between the hull and wall i along the axis that separates them most [m]; below 0: how deep it is inside.

    Never more than their distance (separating axes). An axis with a gap of `enough` will do, then it ends sooner. If
    not, `touch`, array (7,), becomes what the wall would push, as the robot sees it: the direction x, y; the point that
    is nearest, x, y; the one next to it, x, y, and its gap. cos, sin: of the robot's heading
    """
    dx, dy = walls[i, 0] - place[0], walls[i, 1] - place[1]
    x, y = (
        dx * cos + dy * sin,
        dy * cos - dx * sin,
    )  # the wall as the robot sees it: its centre, its length's direction
    ux, uy = (
        walls[i, 4] * cos + walls[i, 5] * sin,
        walls[i, 5] * cos - walls[i, 4] * sin,
    )
    length, thickness = walls[i, 2], walls[i, 3]
    left, right, low, high = (
        math.inf,
        -math.inf,
        math.inf,
        -math.inf,
    )  # how far the hull reaches, as the wall sees it
    for k in range(hull.shape[0]):
        dx, dy = hull[k, 0] - x, hull[k, 1] - y
        along, across = dx * ux + dy * uy, dy * ux - dx * uy
        left, right, low, high = (
            min(left, along),
            max(right, along),
            min(low, across),
            max(high, across),
        )
    off_end, off_face = max(left, -right) - length, max(low, -high) - thickness
    widest, side = max(off_end, off_face), -1
    if widest >= enough:
        return widest
    for k in range(
        hull.shape[0]
    ):  # the sides of the hull: how far ahead of each the wall begins
        nx, ny = hull[k, 2], hull[k, 3]
        gap = nx * (x - hull[k, 0]) + ny * (y - hull[k, 1])  # to the centre of the wall
        if gap >= widest:
            gap = (
                gap
                - abs(nx * ux + ny * uy) * length
                - abs(ny * ux - nx * uy) * thickness
            )
            if gap > widest or (gap == widest and side < 0):
                if gap >= enough:
                    return gap
                widest, side = gap, k
    if side >= 0:
        touch_side(hull, side, widest, x, y, ux, uy, length, thickness, touch)
    elif off_end >= off_face:
        ahead = 1.0 if left >= -right else -1.0
        touch_corner(hull, x, y, ahead * ux, ahead * uy, length, touch)
    else:
        ahead = 1.0 if low >= -high else -1.0
        touch_corner(hull, x, y, -ahead * uy, ahead * ux, thickness, touch)
    return widest


@compiled
def touch_side(hull, k, gap, x, y, ux, uy, length, thickness, touch):
    """Let `touch` tell where a wall (its centre, its length's direction, half its sides) meets side k of the hull."""
    nx, ny = hull[k, 2], hull[k, 3]
    along, across = nx * ux + ny * uy, ny * ux - nx * uy
    touch[0], touch[1] = -nx, -ny
    a, b = (
        (-length if along > 0.0 else length),
        (-thickness if across > 0.0 else thickness),
    )
    touch[2], touch[3] = x + a * ux - b * uy, y + a * uy + b * ux
    if abs(along) * length < abs(across) * thickness:
        a, touch[6] = -a, gap + 2 * abs(along) * length
    else:
        b, touch[6] = -b, gap + 2 * abs(across) * thickness
    touch[4], touch[5] = x + a * ux - b * uy, y + a * uy + b * ux


@compiled
def touch_corner(hull, x, y, nx, ny, half, touch):
    """Let `touch` tell which corners of the hull meet a side of a wall, `half` from its centre; (nx, ny): normal."""
    gap, next_gap, nearest, next_nearest = math.inf, math.inf, 0, 0
    for k in range(hull.shape[0]):
        outside = (hull[k, 0] - x) * nx + (hull[k, 1] - y) * ny - half
        if outside < gap:
            gap, next_gap, nearest, next_nearest = outside, gap, k, nearest
        elif outside < next_gap:
            next_gap, next_nearest = outside, k
    touch[0], touch[1] = nx, ny
    touch[2], touch[3] = hull[nearest, 0], hull[nearest, 1]
    touch[4], touch[5], touch[6] = (
        hull[next_nearest, 0],
        hull[next_nearest, 1],
        next_gap,
    )


@compiled
def push(place, cos, sin, gap, moment, touch):
    """Push the hull, a plate that lies loosely, out of the wall that `touch` tells of: at one point, or at two.

    A push by p at a point whose lever is l moves the plate by p and turns it by p l / moment, so that another point,
    whose lever is k, moves out by p (1 + k l / moment). Two points that shall end on the wall: two such equations.
    """
    nx, ny = touch[0], touch[1]
    first, second = (
        touch[2] * ny - touch[3] * nx,
        touch[4] * ny - touch[5] * nx,
    )  # levers
    depth, next_depth = CLEARANCE - gap, CLEARANCE - touch[6]
    one, both, two = (
        1.0 + first * first / moment,
        1.0 + first * second / moment,
        1.0 + second * second / moment,
    )
    p, q = depth / one, 0.0
    if (
        next_depth > p * both
    ):  # pushed there alone, it would turn its next corner into the wall
        determinant = one * two - both * both
        p, q = (
            (two * depth - both * next_depth) / determinant,
            (one * next_depth - both * depth) / determinant,
        )
        if p < 0.0:  # walls do not pull
            p, q = 0.0, next_depth / two
    place[0] += (p + q) * (nx * cos - ny * sin)
    place[1] += (p + q) * (nx * sin + ny * cos)
    place[2] += (p * first + q * second) / moment


@compiled
def push_out(place, hull, radius, moment, walls, near, n, touch):
    """Let n walls push the hull out, one after the other, until it is free of all: the rounds that takes, or ROUNDS."""
    cos, sin = cosine(place[2]), sine(place[2])
    for pushes in range(ROUNDS):
        free = True
        for k in range(n):
            if is_near(place, radius, walls, near[k]):
                gap = gap_to_wall(place, cos, sin, hull, walls, near[k], 0.0, touch)
                if gap < 0.0:
                    free = False
                    push(place, cos, sin, gap, moment, touch)
                    cos, sin = cosine(place[2]), sine(place[2])
        if free:
            return pushes
    return ROUNDS


@compiled
def drive(place, v, omega, seconds, hull, radius, moment, walls, near, touch):
    """Drive at v [m/s] and omega [rad/s] for some seconds: on an arc until the hull meets a wall, then along it.

    radius: of the circle about the axle in which the hull fits [m]
    moment: the hull's moment of inertia about the axle over its mass [m²]
    near, touch: room to work in, arrays (n,) of int64 and (7,)
    """
    speed = abs(v) + abs(omega) * radius  # no point of the hull moves faster
    n, pushes = walls_within(place, radius + 2 * speed * seconds, walls, near), 0
    while seconds > 0.0 and speed > 0.0:
        free = 0.0  # how far the hull may move before it can meet a wall
        if pushes == 0:
            free, cos, sin = speed * seconds, cosine(place[2]), sine(place[2])
            for k in range(n):
                if is_near(place, radius + free, walls, near[k]):
                    free = min(
                        free,
                        gap_to_wall(place, cos, sin, hull, walls, near[k], free, touch),
                    )
        piece = min(seconds, max(SUBSTEP, free / speed))
        x, y, theta = place[0], place[1], place[2]
        follow_arc(place, v, omega, piece)
        seconds -= piece
        pushes = (
            push_out(place, hull, radius, moment, walls, near, n, touch)
            if piece * speed > free
            else 0
        )
        if pushes == ROUNDS:  # wedged between walls
            place[0], place[1], place[2] = x, y, theta
        if (
            pushes > 0
            and abs(place[0] - x) + abs(place[1] - y) + abs(place[2] - theta)
            < CLEARANCE
        ):
            seconds = 0.0  # it stands still, and would for the rest of the time
    place[2] = min(
        math.pi, place[2] - 2 * math.pi * math.ceil(place[2] / (2 * math.pi) - 0.5)
    )  # to (−π, π]


@compiled
def ray_to_wall(x, y, dx, dy, walls, i):
    """Length of the ray from (x, y) in direction (dx, dy) to wall i [m]; infinity if it misses it.

    Between the lines of two parallel sides lies a part of the ray; it is in the wall where both such parts overlap.
    """
    x, y = x - walls[i, 0], y - walls[i, 1]
    enter, leave = 0.0, math.inf
    ux, uy, half, other = walls[i, 4], walls[i, 5], walls[i, 2], walls[i, 3]
    for _ in range(2):
        start, ahead = x * ux + y * uy, dx * ux + dy * uy
        if abs(ahead) > 1e-12:
            one, two = (-half - start) / ahead, (half - start) / ahead
            enter, leave = max(enter, min(one, two)), min(leave, max(one, two))
        elif abs(start) > half:  # parallel to these sides, and outside
            return math.inf
        ux, uy, half, other = -uy, ux, other, half
    return enter if enter <= leave else math.inf


@compiled
def look(place, rays, reach, walls, lengths):
    """How long each ray is up to the first wall, at most `reach` [m]; fills `lengths`, array (n,).

    rays: array (n, 4), where each begins [m] and its direction, as the robot sees them from its axle: x, y, cos, sin
    """
    cos, sin = cosine(place[2]), sine(place[2])
    for k in range(rays.shape[0]):
        x, y = (
            place[0] + rays[k, 0] * cos - rays[k, 1] * sin,
            place[1] + rays[k, 0] * sin + rays[k, 1] * cos,
        )
        dx, dy = (
            rays[k, 2] * cos - rays[k, 3] * sin,
            rays[k, 2] * sin + rays[k, 3] * cos,
        )
        lengths[k] = reach
        for i in range(walls.shape[0]):
            to_x, to_y, size = (
                walls[i, 0] - x,
                walls[i, 1] - y,
                walls[i, 2] + walls[i, 3] + CLEARANCE,
            )
            if abs(to_x * dy - to_y * dx) < size:  # it may meet it
                lengths[k] = min(lengths[k], ray_to_wall(x, y, dx, dy, walls, i))
