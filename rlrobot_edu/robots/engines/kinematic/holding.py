"""Walls that hold: the mobile base along walls with friction; geometry and loops alone, as in motion.py.

The robot drives in pieces of 0.05 s. In each piece a wall acts on the points of the hull that are inside it when the
piece begins:

- it pushes, so that they go no deeper;
- it holds them where they are, but no stronger than `friction` times its push: beyond that they slide;
- it is soft: what is deeper than GIVE comes back, a part of it in each piece.

This is geometry, not physics: there are no masses and no forces. But the rules and their numbers are those by which
pymunk moves its base.

base: the `Parts` of base.py
motion: array (3,), of a piece, as the robot sees it when it begins: ahead [m], aside [m], to the left [rad]
contacts: array (m, 7), the points at which walls touch the hull, as the robot sees them; its columns are below
"""

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.robots.engines.kinematic.motion import (
    CLEARANCE,
    PUSH_X,
    PUSH_Y,
    SUBSTEP,
    follow_arc,
    gap_to_wall,
    is_near,
    put_in_range,
    walls_within,
)
from rlrobot_edu.robots.engines.kinematic.trigonometry import cosine, sine

GIVE = 0.001  # how deep a wall lets the hull stay [m]
RETURNS = 1 - 0.9 * 0.9 * 0.9  # the part of what is deeper that comes back in a piece
PASSES = 10  # over all contacts, because each changes what the others have to do

NORMAL_X = 0  # the direction in which the wall pushes, a unit vector
NORMAL_Y = 1
LEVER = 2  # of the push about the axle [m]
SIDE_LEVER = 3  # of the hold [m]
DEPTH = 4  # how far inside the wall the point is [m]
PUSHED = 5  # how far the push has moved the axle [m]
HELD = 6  # how far the hold has, to the left of the push [m]


@compiled
def drive_held(base, v, omega, seconds):
    """Drive at v [m/s] and omega [rad/s] for some seconds: on an arc until the hull is in a wall, then as walls let it.

    Changes ``base.place``.
    """
    place = base.place
    hull = base.body.hull
    radius = base.body.radius
    speed = abs(v) + abs(omega) * radius  # no point of the hull moves faster
    n = walls_within(place, radius + 2 * speed * seconds, base.walls, base.near)
    while seconds > 0.0:
        cos = cosine(place[2])
        sin = sine(place[2])
        free = speed * seconds  # how far the hull may move before it can meet a wall
        for k in range(n):
            i = base.near[k]
            if is_near(place, radius + free, base.walls, i):
                gap = gap_to_wall(
                    place, cos, sin, hull, base.walls, i, free, base.touch
                )
                free = min(free, gap)
        m = 0
        if free < 0.0:
            m = find_contacts(base, n, cos, sin)
        if m > 0:
            piece = min(seconds, SUBSTEP)
            if move_held(base, v, omega, piece, m, cos, sin) < CLEARANCE:
                break  # it stands still, and would for the rest of the time
        else:
            piece = min(seconds, SUBSTEP)
            if free > speed * piece:
                piece = free / speed
            follow_arc(place, v, omega, piece)
        seconds -= piece
    put_in_range(place)


@compiled
def find_contacts(base, n, cos, sin):
    """Fill ``base.contacts`` with the points at which the hull is in one of n near walls; how many they are."""
    m = 0
    for k in range(n):
        i = base.near[k]
        if is_near(base.place, base.body.radius, base.walls, i):
            gap = gap_to_wall(
                base.place, cos, sin, base.body.hull, base.walls, i, 0.0, base.touch
            )
            if gap < 0.0:
                m = add_contacts(base, i, cos, sin, m)
    return m


@compiled
def add_contacts(base, i, cos, sin, m):
    """Add the points at which the hull is in wall i to m contacts; how many they are now.

    A side of the hull and one of the wall face each other. The points are the ends of the stretch that both share.
    """
    hull = base.body.hull
    nx = base.touch[PUSH_X]
    ny = base.touch[PUSH_Y]
    # The side of the hull that faces the wall, from corner a to corner b
    a = 0
    for k in range(hull.shape[0]):
        if hull[k, 2] * nx + hull[k, 3] * ny < hull[a, 2] * nx + hull[a, 3] * ny:
            a = k
    b = (a + 1) % hull.shape[0]
    # The side of the wall that faces the hull: its middle (x, y), its direction (ux, uy), half its length
    dx = base.walls[i, 0] - base.place[0]
    dy = base.walls[i, 1] - base.place[1]
    x = dx * cos + dy * sin
    y = dy * cos - dx * sin
    ux = base.walls[i, 4] * cos + base.walls[i, 5] * sin
    uy = base.walls[i, 5] * cos - base.walls[i, 4] * sin
    half = base.walls[i, 2]
    half_across = base.walls[i, 3]
    if abs(nx * ux + ny * uy) > abs(ny * ux - nx * uy):  # it is an end of the wall
        ux, uy = -uy, ux
        half, half_across = half_across, half
    if ny * ux - nx * uy < 0.0:  # the wall's other side
        ux, uy = -ux, -uy
    x -= half_across * uy
    y += half_across * ux

    # Both sides from where to where, along the wall and to the left of its push
    hull_a = hull[a, 1] * nx - hull[a, 0] * ny
    hull_b = hull[b, 1] * nx - hull[b, 0] * ny
    middle = y * nx - x * ny
    slope = uy * nx - ux * ny
    begin = max(min(hull_a, hull_b), middle - half * abs(slope))
    end = min(max(hull_a, hull_b), middle + half * abs(slope))
    for k in range(2):
        along = begin if k == 0 else end
        part = min(max((along - hull_a) / (hull_b - hull_a), 0.0), 1.0)
        px = hull[a, 0] + part * (hull[b, 0] - hull[a, 0])
        py = hull[a, 1] + part * (hull[b, 1] - hull[a, 1])
        way = min(max((along - middle) / slope, -half), half)
        depth = (x + way * ux - px) * nx + (y + way * uy - py) * ny
        if depth > 0.0:
            contact = base.contacts[m]
            contact[NORMAL_X] = nx
            contact[NORMAL_Y] = ny
            contact[LEVER] = px * ny - py * nx
            contact[SIDE_LEVER] = px * nx + py * ny
            contact[DEPTH] = depth
            m += 1
    return m


@compiled
def move_held(base, v, omega, seconds, m, cos, sin):
    """Move for a piece as m contacts let the hull: how far, the sum of ways [m] and turn [rad]."""
    half = omega * seconds / 2
    chord = v * seconds  # see `follow_arc`
    if half != 0.0:
        chord *= sine(half) / half
    motion = base.motion
    motion[0] = chord * cosine(half)
    motion[1] = chord * sine(half)
    motion[2] = 2 * half
    settle(motion, base.contacts, m, base.friction, base.body.moment, 0.0)
    back = base.back
    back[:] = 0.0
    settle(back, base.contacts, m, 0.0, base.body.moment, RETURNS)

    ahead = motion[0] + back[0]
    aside = motion[1] + back[1]
    turn = motion[2] + back[2]
    base.place[0] += ahead * cos - aside * sin
    base.place[1] += ahead * sin + aside * cos
    base.place[2] += turn
    return abs(ahead) + abs(aside) + abs(turn)


@compiled
def settle(motion, contacts, m, friction, moment, returns):
    """Change `motion` until m contacts let it be.

    A push by p whose lever is l moves the axle by p and turns the hull by p l / moment, so its own point moves by
    p (1 + l l / moment). Each contact corrects its own point, and so do the others, again and again.

    returns: the part of what is deeper than GIVE that has to come back
    """
    for k in range(m):
        contacts[k, PUSHED] = 0.0
        contacts[k, HELD] = 0.0
    for _ in range(PASSES):
        for k in range(m):
            contact = contacts[k]
            nx = contact[NORMAL_X]
            ny = contact[NORMAL_Y]
            lever = contact[LEVER]
            side_lever = contact[SIDE_LEVER]
            out = motion[0] * nx + motion[1] * ny + motion[2] * lever
            aside = motion[1] * nx - motion[0] * ny + motion[2] * side_lever
            wanted = returns * max(contact[DEPTH] - GIVE, 0.0)

            pushed = contact[PUSHED] + (wanted - out) / (1 + lever * lever / moment)
            pushed = max(pushed, 0.0)  # walls do not pull
            push = pushed - contact[PUSHED]
            contact[PUSHED] = pushed

            held = contact[HELD] - aside / (1 + side_lever * side_lever / moment)
            held = min(max(held, -friction * pushed), friction * pushed)
            hold = held - contact[HELD]
            contact[HELD] = held

            motion[0] += push * nx - hold * ny
            motion[1] += push * ny + hold * nx
            motion[2] += (push * lever + hold * side_lever) / moment
