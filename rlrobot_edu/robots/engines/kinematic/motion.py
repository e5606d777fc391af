"""The mobile base in a plane: arcs, walls that push its hull away, and rays; scalars, arrays and loops alone.

place: array (3,), x and y of the axle, the point midway between the wheels [m], and the heading [rad]
walls: array (n, 6), each a box: x and y of its centre, half its length and half its thickness [m], cos and sin of the
    direction of its length
hull: array (m, 4), each a corner of the convex outline, counter-clockwise, and the outward normal of the side that
    begins there: x, y [m], normal's x, normal's y; as the robot sees them from its axle
"""

import math

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.robots.engines.kinematic.trigonometry import cosine, sine

SUBSTEP = 0.05  # longest piece of a motion along a wall [s]
CLEARANCE = 1e-6  # how far from a wall the hull is put [m]
ROUNDS = 8  # of pushing, for a hull between several walls

# `touch`, array (7,): where a wall meets the hull, as the robot sees it
PUSH_X = 0  # the direction in which the wall pushes, a unit vector
PUSH_Y = 1
NEAREST_X = 2  # the point of contact that is deepest inside [m]
NEAREST_Y = 3
NEXT_X = 4  # the next deepest [m]
NEXT_Y = 5
NEXT_GAP = 6  # its gap to the wall or the hull [m], below 0 inside


@compiled
def follow_arc(place, v, omega, seconds):
    """Drive at v [m/s] while turning to the left at omega [rad/s] for some seconds; changes `place`.

    The path is an arc that turns by t = omega * seconds. Its chord is sin(t/2) / (t/2) times as long as the arc, and
    points t/2 to the left of the heading at the beginning.
    """
    half = omega * seconds / 2
    chord = v * seconds
    if half != 0.0:
        chord *= sine(half) / half
    place[0] += chord * cosine(place[2] + half)
    place[1] += chord * sine(place[2] + half)
    place[2] += 2 * half


@compiled
def put_in_range(place):
    """Give the heading in (−π, π]."""
    whole_turns = math.ceil(place[2] / (2 * math.pi) - 0.5)
    place[2] = min(math.pi, place[2] - 2 * math.pi * whole_turns)


@compiled
def is_near(place, reach, walls, i):
    """Whether wall i is nearer to the axle than `reach` [m]."""
    dx = place[0] - walls[i, 0]
    dy = place[1] - walls[i, 1]
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

    The gap is never more than their distance (separating axis theorem). As soon as an axis shows a gap of `enough`, it
    is returned. Otherwise `touch` becomes where the wall meets the hull. cos, sin: of the robot's heading
    """
    # The wall as the robot sees it: its centre (x, y) and the direction of its length (ux, uy)
    dx = walls[i, 0] - place[0]
    dy = walls[i, 1] - place[1]
    x = dx * cos + dy * sin
    y = dy * cos - dx * sin
    ux = walls[i, 4] * cos + walls[i, 5] * sin
    uy = walls[i, 5] * cos - walls[i, 4] * sin
    half_length = walls[i, 2]
    half_thickness = walls[i, 3]

    # How far the hull reaches, as the wall sees it
    left = math.inf
    right = -math.inf
    low = math.inf
    high = -math.inf
    for k in range(hull.shape[0]):
        dx = hull[k, 0] - x
        dy = hull[k, 1] - y
        along = dx * ux + dy * uy
        across = dy * ux - dx * uy
        left = min(left, along)
        right = max(right, along)
        low = min(low, across)
        high = max(high, across)
    off_end = max(left, -right) - half_length
    off_face = max(low, -high) - half_thickness
    widest = max(off_end, off_face)
    if widest >= enough:
        return widest

    # The sides of the hull: how far ahead of each the wall begins. If gaps are equal, the hull's first side is taken.
    side = -1
    for k in range(hull.shape[0]):
        nx = hull[k, 2]
        ny = hull[k, 3]
        gap = nx * (x - hull[k, 0]) + ny * (y - hull[k, 1])  # to the centre of the wall
        if gap >= widest:
            along = abs(nx * ux + ny * uy) * half_length
            across = abs(ny * ux - nx * uy) * half_thickness
            gap = gap - along - across
            if gap > widest or (gap == widest and side < 0):
                if gap >= enough:
                    return gap
                widest = gap
                side = k

    if side >= 0:
        touch_side(hull, side, widest, x, y, ux, uy, half_length, half_thickness, touch)
    elif off_end >= off_face:
        ahead = 1.0 if left >= -right else -1.0
        touch_corner(hull, x, y, ahead * ux, ahead * uy, half_length, touch)
    else:
        ahead = 1.0 if low >= -high else -1.0
        touch_corner(hull, x, y, -ahead * uy, ahead * ux, half_thickness, touch)
    return widest


@compiled
def touch_side(hull, k, gap, x, y, ux, uy, half_length, half_thickness, touch):
    """Fill `touch` where a wall, given by its centre, direction and half sizes, meets side k of the hull."""
    nx = hull[k, 2]
    ny = hull[k, 3]
    touch[PUSH_X] = -nx
    touch[PUSH_Y] = -ny
    # The corner of the wall that is deepest: a along the wall and b across it, from its centre
    along = nx * ux + ny * uy
    across = ny * ux - nx * uy
    a = -half_length if along > 0.0 else half_length
    b = -half_thickness if across > 0.0 else half_thickness
    touch[NEAREST_X] = x + a * ux - b * uy
    touch[NEAREST_Y] = y + a * uy + b * ux
    # The next deepest is at the other end of the side that is more nearly parallel to the hull's
    if abs(along) * half_length < abs(across) * half_thickness:
        a = -a
        touch[NEXT_GAP] = gap + 2 * abs(along) * half_length
    else:
        b = -b
        touch[NEXT_GAP] = gap + 2 * abs(across) * half_thickness
    touch[NEXT_X] = x + a * ux - b * uy
    touch[NEXT_Y] = y + a * uy + b * ux


@compiled
def touch_corner(hull, x, y, nx, ny, half, touch):
    """Fill `touch` where corners of the hull meet a side of a wall, `half` from its centre; (nx, ny): its normal."""
    gap = math.inf
    next_gap = math.inf
    nearest = 0
    next_nearest = 0
    for k in range(hull.shape[0]):
        outside = (hull[k, 0] - x) * nx + (hull[k, 1] - y) * ny - half
        if outside < gap:
            next_gap = gap
            next_nearest = nearest
            gap = outside
            nearest = k
        elif outside < next_gap:
            next_gap = outside
            next_nearest = k
    touch[PUSH_X] = nx
    touch[PUSH_Y] = ny
    touch[NEAREST_X] = hull[nearest, 0]
    touch[NEAREST_Y] = hull[nearest, 1]
    touch[NEXT_X] = hull[next_nearest, 0]
    touch[NEXT_Y] = hull[next_nearest, 1]
    touch[NEXT_GAP] = next_gap


@compiled
def push(place, cos, sin, gap, moment, touch):
    """Push the hull, a plate that lies loosely, out of the wall that `touch` describes: at one point, or at two.

    A push by p at a point whose lever is l moves the plate by p and turns it by p l / moment, so that another point,
    whose lever is k, moves out by p (1 + k l / moment). Two points that shall end on the wall: two such equations.
    """
    nx = touch[PUSH_X]
    ny = touch[PUSH_Y]
    lever = touch[NEAREST_X] * ny - touch[NEAREST_Y] * nx
    next_lever = touch[NEXT_X] * ny - touch[NEXT_Y] * nx
    depth = CLEARANCE - gap
    next_depth = CLEARANCE - touch[NEXT_GAP]
    # How far a push by 1 at one of the points moves the same one, and the other one
    own = 1.0 + lever * lever / moment
    both = 1.0 + lever * next_lever / moment
    next_own = 1.0 + next_lever * next_lever / moment

    p = depth / own
    q = 0.0
    if (
        next_depth > p * both
    ):  # pushed at one point, it would turn the next into the wall
        determinant = own * next_own - both * both
        p = (next_own * depth - both * next_depth) / determinant
        q = (own * next_depth - both * depth) / determinant
        if p < 0.0:  # walls do not pull
            p = 0.0
            q = next_depth / next_own
    place[0] += (p + q) * (nx * cos - ny * sin)
    place[1] += (p + q) * (nx * sin + ny * cos)
    place[2] += (p * lever + q * next_lever) / moment


@compiled
def push_out(place, hull, radius, moment, walls, near, n, touch):
    """Let n walls push the hull out, one after the other, until it is free of all: the rounds that takes, or ROUNDS."""
    cos = cosine(place[2])
    sin = sine(place[2])
    for rounds in range(ROUNDS):
        free = True
        for k in range(n):
            if is_near(place, radius, walls, near[k]):
                gap = gap_to_wall(place, cos, sin, hull, walls, near[k], 0.0, touch)
                if gap < 0.0:
                    free = False
                    push(place, cos, sin, gap, moment, touch)
                    cos = cosine(place[2])
                    sin = sine(place[2])
        if free:
            return rounds
    return ROUNDS


@compiled
def drive(place, v, omega, seconds, hull, radius, moment, walls, near, touch):
    """Drive at v [m/s] and omega [rad/s] for some seconds: on an arc until the hull meets a wall, then along it.

    radius: of the circle about the axle in which the hull fits [m]
    moment: the hull's moment of inertia about the axle over its mass [m²]
    near, touch: room to work in, arrays (n,) of int64 and (7,)
    """
    speed = abs(v) + abs(omega) * radius  # no point of the hull moves faster
    # twice as far as it drives: walls that it meets may push it further
    n = walls_within(place, radius + 2 * speed * seconds, walls, near)
    rounds = 0
    while seconds > 0.0 and speed > 0.0:
        free = 0.0  # how far the hull may move before it can meet a wall
        if rounds == 0:
            free = speed * seconds
            cos = cosine(place[2])
            sin = sine(place[2])
            for k in range(n):
                if is_near(place, radius + free, walls, near[k]):
                    gap = gap_to_wall(
                        place, cos, sin, hull, walls, near[k], free, touch
                    )
                    free = min(free, gap)
        piece = min(seconds, max(SUBSTEP, free / speed))
        x = place[0]
        y = place[1]
        theta = place[2]
        follow_arc(place, v, omega, piece)
        seconds -= piece
        rounds = 0
        if piece * speed > free:
            rounds = push_out(place, hull, radius, moment, walls, near, n, touch)
        if rounds == ROUNDS:  # wedged between walls
            place[0] = x
            place[1] = y
            place[2] = theta
        if rounds > 0:
            change = abs(place[0] - x) + abs(place[1] - y) + abs(place[2] - theta)
            if (
                change < CLEARANCE
            ):  # it stands still, and would for the rest of the time
                break
    put_in_range(place)


@compiled
def ray_to_wall(x, y, dx, dy, walls, i):
    """Length of the ray from (x, y) in direction (dx, dy) to wall i [m]; infinity if it misses it.

    Between the lines of two parallel sides lies a part of the ray; it is in the wall where both such parts overlap.
    """
    x = x - walls[i, 0]
    y = y - walls[i, 1]
    enter = 0.0
    leave = math.inf
    ux = walls[i, 4]
    uy = walls[i, 5]
    half = walls[i, 2]
    other_half = walls[i, 3]
    for _ in range(2):
        start = x * ux + y * uy
        ahead = dx * ux + dy * uy
        if abs(ahead) > 1e-12:
            one = (-half - start) / ahead
            two = (half - start) / ahead
            enter = max(enter, min(one, two))
            leave = min(leave, max(one, two))
        elif abs(start) > half:  # parallel to these sides, and outside
            return math.inf
        # the other two sides: a quarter of a turn to the left
        ux, uy = -uy, ux
        half, other_half = other_half, half
    return enter if enter <= leave else math.inf


@compiled
def look(place, rays, reach, walls, lengths):
    """How long each ray is up to the first wall, at most `reach` [m]; fills `lengths`, array (n,).

    rays: array (n, 4), where each begins [m] and its direction, as the robot sees them from its axle: x, y, cos, sin
    """
    cos = cosine(place[2])
    sin = sine(place[2])
    for k in range(rays.shape[0]):
        x = place[0] + rays[k, 0] * cos - rays[k, 1] * sin
        y = place[1] + rays[k, 0] * sin + rays[k, 1] * cos
        dx = rays[k, 2] * cos - rays[k, 3] * sin
        dy = rays[k, 2] * sin + rays[k, 3] * cos
        lengths[k] = reach
        for i in range(walls.shape[0]):
            to_x = walls[i, 0] - x
            to_y = walls[i, 1] - y
            size = walls[i, 2] + walls[i, 3] + CLEARANCE
            if abs(to_x * dy - to_y * dx) < size:  # it may meet it
                lengths[k] = min(lengths[k], ray_to_wall(x, y, dx, dy, walls, i))
