"""How several task files command the wheels."""


def no_reversing(wheels: dict[str, float]) -> dict[str, float]:
    """The wheels' speeds [rad/s] for a robot that does not drive backward blindly.

    Both wheels backward means forward at double speed; one backward while the other stands still means no motion.
    """
    left, right = wheels["left_wheel"], wheels["right_wheel"]
    if left < 0 and right < 0:
        return {"left_wheel": -2 * left, "right_wheel": -2 * right}
    if (left < 0 and right == 0) or (left == 0 and right < 0):
        return {"left_wheel": 0.0, "right_wheel": 0.0}
    return wheels
