"""Typical wrong answers of lesson 17, written as learners write them, and a word of the hint each must get."""

import math

import numpy as np


def wheels_whole_separation(v, omega, radius, separation):
    return (v - omega * separation) / radius, (v + omega * separation) / radius


def wheels_swapped(v, omega, radius, separation):
    half = separation / 2
    return (v + omega * half) / radius, (v - omega * half) / radius


def wheels_in_metres(v, omega, radius, separation):
    return v - omega * separation / 2, v + omega * separation / 2


def wheels_multiplied(v, omega, radius, separation):
    return radius * (v - omega * separation / 2), radius * (v + omega * separation / 2)


def wheels_from_degrees(v, omega, radius, separation):
    omega = omega * math.pi / 180
    return (v - omega * separation / 2) / radius, (v + omega * separation / 2) / radius


def wheels_to_degrees(v, omega, radius, separation):
    turn = math.degrees(omega) * separation / 2
    return (v - turn) / radius, (v + turn) / radius


def wheels_without_separation(v, omega, radius, separation):
    return (v - omega) / radius, (v + omega) / radius


def wheels_without_brackets(v, omega, radius, separation):
    return v - omega * separation / 2 / radius, v + omega * separation / 2 / radius


def wheels_of_the_giraff(v, omega, radius, separation):
    return (v - omega * 0.23) / 0.075, (v + omega * 0.23) / 0.075


def angles_of(ranges, angle_min, increment):
    return angle_min + increment * np.arange(len(ranges))


def nearest_of_all(ranges, angle_min, increment):
    met = [r for r in ranges if 0 < r < math.inf]
    return min(met) if met else math.nan


def nearest_in_degrees(ranges, angle_min, increment):
    found = [(r, angle_min + i * increment) for i, r in enumerate(ranges) if 0 < r < math.inf]
    return min([r for r, angle in found if abs(angle) <= 60], default=math.inf) if found else math.nan


def nearest_takes_zeros(ranges, angle_min, increment):
    r = np.array(ranges)
    met = np.isfinite(r) & (r >= 0)
    if not met.any():
        return math.nan
    return r[met & (np.cos(angles_of(ranges, angle_min, increment)) >= 0.5)].min(initial=math.inf)


def nearest_takes_nan(ranges, angle_min, increment):
    r = np.array(ranges)
    met = (r != 0) & (r != math.inf)
    if not met.any():
        return math.nan
    return np.min(r[met & (np.cos(angles_of(ranges, angle_min, increment)) >= 0.5)], initial=math.inf)


def nearest_on_one_side(ranges, angle_min, increment):
    found = [(r, angle_min + i * increment) for i, r in enumerate(ranges) if 0 < r < math.inf]
    return min([r for r, angle in found if -1.0472 <= angle <= 1.0472], default=math.inf) if found else math.nan


def nearest_of_nothing_is_far(ranges, angle_min, increment):
    found = [(r, angle_min + i * increment) for i, r in enumerate(ranges) if 0 < r < math.inf]
    return min([r for r, angle in found if math.cos(angle) >= 0.5], default=math.inf)


def nearest_of_nothing_ahead_is_nan(ranges, angle_min, increment):
    found = [(r, angle_min + i * increment) for i, r in enumerate(ranges) if 0 < r < math.inf]
    return min([r for r, angle in found if math.cos(angle) >= 0.5], default=math.nan)


def nearest_from_zero_on(ranges, angle_min, increment):
    found = [(r, i * increment) for i, r in enumerate(ranges) if 0 < r < math.inf]
    return min([r for r, angle in found if math.cos(angle) >= 0.5], default=math.inf) if found else math.nan


def allowed_without_nan(v, omega, ahead, age):
    if age > 0.5:
        return 0, 0
    if ahead < 0.18 and v > 0:
        v = 0
    return v, omega


def allowed_compares_nan(v, omega, ahead, age):
    if age > 0.5 or ahead == math.nan:
        return 0, 0
    return (0 if ahead < 0.18 and v > 0 else v), omega


def allowed_stands_at_walls(v, omega, ahead, age):
    if age > 0.5 or ahead != ahead or (ahead < 0.18 and v > 0):
        return 0.0, 0.0
    return v, omega


def allowed_never_backs(v, omega, ahead, age):
    if age > 0.5 or math.isnan(ahead):
        return 0.0, 0.0
    if ahead < 0.18:
        v = 0.0
    return v, omega


def allowed_turns_blindly(v, omega, ahead, age):
    if math.isnan(ahead) or age > 0.5 or (v > 0 and ahead < 0.18):
        v = 0.0
    return v, omega


def allowed_forgets_age(v, omega, ahead, age):
    if math.isnan(ahead):
        return 0.0, 0.0
    return (0.0 if v > 0 and ahead < 0.18 else v), omega


def allowed_fears_infinity(v, omega, ahead, age):
    if age > 0.5 or not np.isfinite(ahead):
        return 0.0, 0.0
    return (0.0 if v > 0 and ahead < 0.18 else v), omega


def allowed_at_the_border(v, omega, ahead, age):
    if age > 0.5 or math.isnan(ahead):
        return 0.0, 0.0
    return (0.0 if v > 0 and ahead <= 0.18 else v), omega


def allowed_asks_in_the_other_order(v, omega, ahead, age):
    if ahead < 0.18 and v > 0:
        return 0, omega
    if age > 0.5 or math.isnan(ahead):
        return 0, 0
    return v, omega


WRONG = {
    "wheels": [
        (wheels_whole_separation, "half of the separation"),
        (wheels_swapped, "wrong way"),
        (wheels_in_metres, "in m/s"),
        (wheels_multiplied, "must be divided"),
        (wheels_from_degrees, "math.radians"),
        (wheels_to_degrees, "math.degrees"),
        (wheels_without_separation, "different units"),
        (wheels_without_brackets, "brackets"),
        (wheels_of_the_giraff, "Giraff only"),
    ],
    "nearest_ahead": [
        (nearest_of_all, "all directions"),
        (nearest_in_degrees, "in radians"),
        (nearest_takes_zeros, "0 counts as a wall"),
        (nearest_takes_nan, "NaN gets through"),
        (nearest_on_one_side, "315 degrees"),
        (nearest_of_nothing_is_far, "covered scanner"),
        (nearest_of_nothing_ahead_is_nan, "ahead is free"),
        (nearest_from_zero_on, "at angle_min"),
    ],
    "allowed": [
        (allowed_without_nan, "NaN gets through"),
        (allowed_compares_nan, "math.isnan"),
        (allowed_stands_at_walls, "never gets away"),
        (allowed_never_backs, "backward"),
        (allowed_turns_blindly, "must not turn"),
        (allowed_forgets_age, "old readings is missing"),
        (allowed_fears_infinity, "may drive"),
        (allowed_at_the_border, "still enough"),
        (allowed_asks_in_the_other_order, "order of the rules"),
    ],
    "who_stops": [
        ((4, 4, 1, 2, 4), "guardian is a process of its own"),
        ((3, 3, 1, 2, 4), "nobody hears it"),
        ((3, 4, 2, 2, 4), "when the step is over"),
        ((3, 4, 1, 1, 4), "KeyboardInterrupt"),
        ((3, 4, 1, 2, 3), "same computer"),
        ((3, 4, 2, 1, 4), "changed places"),
    ],
}
