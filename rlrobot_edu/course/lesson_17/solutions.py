"""Solutions of lesson 17, as a learner writes them."""

import math

who_stops = (3, 4, 1, 2, 4)


def wheels(v, omega, radius, separation):
    aside = omega * separation / 2
    left = (v - aside) / radius
    right = (v + aside) / radius
    return left, right


def nearest_ahead(ranges, angle_min, increment):
    met, nearest = False, math.inf
    for i, r in enumerate(ranges):
        angle = angle_min + i * increment
        if 0 < r < math.inf:
            met = True
            if math.cos(angle) >= 0.5:
                nearest = min(nearest, r)
    return nearest if met else math.nan


def allowed(v, omega, ahead, age):
    if age > 0.5 or math.isnan(ahead):
        return 0.0, 0.0
    if v > 0 and ahead < 0.18:
        return 0.0, omega
    return v, omega
