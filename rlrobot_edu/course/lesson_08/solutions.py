"""Solutions of lesson 08, as a learner writes them."""

import math

heats = "ACF"
steps_to_the_cap = math.ceil((50 - 1) / (0.25 * 21 / 2))


def push(queue, item, length):
    queue.append(item)
    if len(queue) > length:
        queue.pop(0)


def redundancy(states):
    return len(states) / len(set(states))


def new_temperature(temperature, states, rewards, s, default):
    visited_before = states.count(s) > 1
    low = sum(rewards) / len(rewards) < 0
    if visited_before and low and redundancy(states) > 2:
        return min(50, temperature + 0.25 * redundancy(states))
    return default
