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


def push_of_four(queue, item, length):
    queue.append(item)
    if len(queue) > 4:
        del queue[0]


def push_looks_first(queue, item, length):
    if len(queue) > length:
        queue.pop(0)
    queue.append(item)


def push_new_ones_only(queue, item, length):
    if item not in queue:
        queue.append(item)
    if len(queue) > length:
        queue.pop(0)


def push_removes_the_item(queue, item, length):
    queue.append(item)
    if len(queue) > length:
        queue.remove(item)


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


def redundancy_sum(states):
    return sum(states) / len(set(states))


def redundancy_rounded(states):
    return round(len(states) / len(set(states)), 1)


def redundancy_once(states):
    once = [x for x in states if states.count(x) == 1]
    return len(states) / max(len(once), 1)


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


def new_or(temperature, states, rewards, s, default):
    loop = np.mean(rewards) < 0 or states.count(s) > 1 or ratio(states) > 2
    return min(50, temperature + ratio(states) / 4) if loop else default


def new_no_quarter(temperature, states, rewards, s, default):
    loop = np.mean(rewards) < 0 and states.count(s) > 1 and ratio(states) > 2
    return min(50, temperature + ratio(states)) if loop else default


def new_max(temperature, states, rewards, s, default):
    loop = np.mean(rewards) < 0 and states.count(s) > 1 and ratio(states) > 2
    return max(50, temperature + ratio(states) / 4) if loop else default


def new_more_than_twice(temperature, states, rewards, s, default):
    loop = np.mean(rewards) < 0 and states.count(s) > 2 and ratio(states) > 2
    return min(50, temperature + ratio(states) / 4) if loop else default


def new_any_low(temperature, states, rewards, s, default):
    loop = any(r < 0 for r in rewards) and states.count(s) > 1 and ratio(states) > 2
    return min(50, temperature + ratio(states) / 4) if loop else default


def new_stands_still(temperature, states, rewards, s, default):
    loop = np.mean(rewards) < 0 and s == states[-2] and ratio(states) > 2
    return min(50, temperature + ratio(states) / 4) if loop else default


def new_pops(temperature, states, rewards, s, default):
    states.pop()
    loop = np.mean(rewards) < 0 and s in states and (len(states) + 1) / len({*states, s}) > 2
    return min(50, temperature + (len(states) + 1) / len({*states, s}) / 4) if loop else default


def push_slices_a_new_list(queue, item, length):
    queue.append(item)
    queue = queue[-length:]


def push_does_not_call_pop(queue, item, length):
    queue.append(item)
    if len(queue) > length:
        queue.pop  # noqa: B018


def push_in_else(queue, item, length):
    if len(queue) >= length:
        queue.pop(0)
    else:
        queue.append(item)


def push_removes_zero(queue, item, length):
    queue.append(item)
    if len(queue) > length:
        queue.remove(0)


def new_leaves_the_cap(temperature, states, rewards, s, default):
    if np.mean(rewards) < 0 and states.count(s) > 1 and ratio(states) > 2:
        temperature += ratio(states) / 4
        return temperature if temperature <= 50 else default
    return default


def new_falls_slowly(temperature, states, rewards, s, default):
    if np.mean(rewards) < 0 and states.count(s) > 1 and ratio(states) > 2:
        return min(50, temperature + ratio(states) / 4)
    return max(default, temperature - 0.25 * ratio(states))


def new_pushes_again(temperature, states, rewards, s, default):
    states.append(s)
    if np.mean(rewards) < 0 and states.count(s) > 2 and ratio(states) > 2:
        return min(50, temperature + ratio(states) / 4)
    return default


def new_whole_quarters(temperature, states, rewards, s, default):
    loop = np.mean(rewards) < 0 and states.count(s) > 1 and ratio(states) > 2
    return min(50, temperature + ratio(states) // 4) if loop else default


def new_cap_of_21(temperature, states, rewards, s, default):
    loop = np.mean(rewards) < 0 and states.count(s) > 1 and ratio(states) > 2
    return min(21, temperature + ratio(states) / 4) if loop else default


WRONG = {
    "push": [
        (push_grows, "nothing is dropped"),
        (push_pops_last, "newest item went"),
        (push_refuses, "still takes the new item"),
        (push_in_front, "at the end of the queue"),
        (push_rebinds, "has not changed"),
        (push_too_early, "one item too few"),
        (push_of_four, "argument length"),
        (push_looks_first, "First append"),
        (push_new_ones_only, "once more"),
        (push_removes_the_item, "wherever it stands"),
        (push_slices_a_new_list, "makes a new one"),
        (push_does_not_call_pop, "needs its brackets"),
        (push_in_else, "must still join"),
        (push_removes_zero, "looks for the value 0"),
    ],
    "redundancy": [
        (redundancy_upside_down, "upside down"),
        (redundancy_unique, "number of different states"),
        (redundancy_repeats, "counts the repeats"),
        (redundancy_whole, "after the point"),
        (redundancy_of_last, "the last state"),
        (redundancy_of_21, "not always 21"),
        (redundancy_sum, "added up"),
        (redundancy_rounded, "rounded"),
        (redundancy_once, "only once"),
        (lambda states: np.mean([states.count(s) for s in states]), "on average"),
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
        (new_or, "where you have or"),
        (new_no_quarter, "0.25 is missing"),
        (new_max, "at most 50"),
        (new_more_than_twice, "twice is enough"),
        (new_any_low, "one bad reward"),
        (new_stands_still, "twice in a row"),
        (new_pops, "copy"),
        (new_falls_slowly, "little by little"),
        (new_leaves_the_cap, "falls back to the default"),
        (new_pushes_again, "once more"),
        (new_whole_quarters, "cuts off"),
        (new_cap_of_21, "the cap is 50"),
    ],
    "steps_to_the_cap": [
        (18, "48.25"),
        (18.666666666666668, "whole"),
        (5, "0.25"),
        (196.0, "times the redundancy"),
        (10, "two different"),
        (50 / 2.625, "49 to climb"),
        (40, "full already"),
    ],
    "heats": [
        ("ac", "waiting is wise"),
        ("ABCF", "1.4"),
        ("ACEF", "not below 0"),
        ("ACDF", "above 0"),
        ("A", "one more"),
        ("FC", "look at A"),
        ("ACE", "not below 0"),
    ],
}
