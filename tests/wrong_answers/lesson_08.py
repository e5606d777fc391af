"""Typical wrong answers of lesson 08, written as learners write them, and a word of the hint each must get."""

import numpy as np


def push_grows(queue, item, length):
    queue += [item]


def push_pops_last(queue, item, length):
    if len(queue) >= length:
        del queue[-1]
    queue.extend([item])


def push_refuses(queue, item, length):
    queue.extend([item])
    if len(queue) > length:
        queue.pop()


def push_in_front(queue, item, length):
    queue[:] = ([item] + queue)[:length]


def push_rebinds(queue, item, length):
    queue = queue + [item]
    if len(queue) > length:
        queue = queue[1:]
    return queue


def push_too_early(queue, item, length):
    queue[:] = (queue + [item])[-(length - 1) :]


def redundancy_upside_down(states):
    return len(np.unique(states)) / len(states)


def redundancy_unique(states):
    return float(np.unique(states).size)


def redundancy_repeats(states):
    return len(states) - np.unique(states).size


def redundancy_whole(states):
    return len(states) // np.unique(states).size


def redundancy_of_21(states):
    return 21 / len(set(states))


def redundancy_of_last(states):
    return sum(x == states[-1] for x in states)


def ratio(states):
    return len(states) / np.unique(states).size


def new_stays_hot(temperature, states, rewards, s, default):
    if np.mean(rewards) < 0 and np.sum(np.array(states) == s) >= 2 and ratio(states) > 2:
        temperature = np.minimum(50, temperature + ratio(states) / 4)
    return temperature


def new_sizes_of_rewards(temperature, states, rewards, s, default):
    loop = np.abs(rewards).sum() < 0 and states.count(s) > 1 and ratio(states) > 2
    return min(50, temperature + ratio(states) / 4) if loop else default


def new_upside_down(temperature, states, rewards, s, default):
    loop = np.mean(rewards) < 0 and states.count(s) > 1 and 1 / ratio(states) > 2
    return min(50, temperature + 1 / ratio(states) / 4) if loop else default


def new_boils(temperature, states, rewards, s, default):
    loop = np.mean(rewards) < 0 and states.count(s) > 1 and ratio(states) > 2
    return temperature + ratio(states) / 4 if loop else default


def new_any_reward(temperature, states, rewards, s, default):
    loop = states.count(s) > 1 and ratio(states) > 2
    return min(50, temperature + ratio(states) / 4) if loop else default


def new_at_least_two(temperature, states, rewards, s, default):
    loop = np.mean(rewards) < 0 and states.count(s) > 1 and ratio(states) >= 2
    return min(50, temperature + ratio(states) / 4) if loop else default


def new_s_in_states(temperature, states, rewards, s, default):
    loop = np.mean(rewards) < 0 and s in states and ratio(states) > 2
    return min(50, temperature + ratio(states) / 4) if loop else default


def new_last_reward(temperature, states, rewards, s, default):
    loop = rewards[-1] < 0 and states.count(s) > 1 and ratio(states) > 2
    return min(50, temperature + ratio(states) / 4) if loop else default


def new_always_one(temperature, states, rewards, s, default):
    loop = np.mean(rewards) < 0 and states.count(s) > 1 and ratio(states) > 2
    return min(50, temperature + ratio(states) / 4) if loop else 1


def new_from_default(temperature, states, rewards, s, default):
    loop = np.mean(rewards) < 0 and states.count(s) > 1 and ratio(states) > 2
    return min(50, default + ratio(states) / 4) if loop else default


def new_zero_is_low(temperature, states, rewards, s, default):
    loop = np.mean(rewards) <= 0 and states.count(s) > 1 and ratio(states) > 2
    return min(50, temperature + ratio(states) / 4) if loop else default


def new_no_return(temperature, states, rewards, s, default):
    if np.mean(rewards) < 0 and states.count(s) > 1 and ratio(states) > 2:
        return min(50, temperature + ratio(states) / 4)


WRONG = {
    "push": [
        (push_grows, "without end"),
        (push_pops_last, "newest item went"),
        (push_refuses, "still takes the new item"),
        (push_in_front, "at the end of the queue"),
        (push_rebinds, "has not changed"),
        (push_too_early, "never gets full"),
    ],
    "redundancy": [
        (redundancy_upside_down, "upside down"),
        (redundancy_unique, "number of different states"),
        (redundancy_repeats, "counts the repeats"),
        (redundancy_whole, "after the point"),
        (redundancy_of_last, "the last state"),
        (redundancy_of_21, "not always 21"),
    ],
    "new_temperature": [
        (new_stays_hot, "falls back to the default"),
        (new_sizes_of_rewards, "never rises"),
        (new_upside_down, "upside down"),
        (new_boils, "cap"),
        (new_any_reward, "pays"),
        (new_at_least_two, "not ≥"),
        (new_s_in_states, "just been pushed"),
        (new_last_reward, "last reward only"),
        (new_always_one, "not always 1"),
        (new_from_default, "from where it is"),
        (new_zero_is_low, "not ≤"),
        (new_no_return, "returns nothing"),
    ],
    "steps_to_the_cap": [
        (18, "48.25"),
        (18.666666666666668, "whole"),
        (5, "0.25"),
        (196.0, "times the redundancy"),
        (10, "two different"),
    ],
    "heats": [
        ("ac", "waiting is wise"),
        ("ABCF", "1.4"),
        ("ACEF", "not below 0"),
        ("ACDF", "above 0"),
        ("A", "two more"),
    ],
}
