"""Further wrong answers of lesson 01a: errors far from their cause, and mistakes that once had no hint."""

# what is wrong stays as learners write it


def return_index_of_a_value(rewards, gamma):
    total = 0
    for r in rewards:
        total += gamma ** rewards.index(r) * r
    return total


def return_range_of_list(rewards, gamma):
    total = 0
    for k in range(rewards):
        total += gamma**k * rewards[k]
    return total


def return_list_times(rewards, gamma):
    total = 0
    for k in range(len(rewards)):
        total += gamma**k * rewards
    return total


def return_recursion_no_base(rewards, gamma):
    return rewards[0] + gamma * return_recursion_no_base(rewards[1:], gamma)


def return_factor_before(rewards, gamma):
    total, factor = 0, gamma
    for r in rewards:
        factor = factor * gamma
        total += factor * r
    return total


def return_range_from_1(rewards, gamma):
    total = 0
    for k in range(1, len(rewards) + 1):
        total += gamma**k * rewards[k]
    return total


def return_sum_of_generator_parenthesised_wrong(rewards, gamma):
    return sum(gamma**k for k in range(len(rewards))) * sum(rewards)


def return_numpy_with_list_power(rewards, gamma):
    return sum(gamma ** range(len(rewards)) * rewards)


def return_max(rewards, gamma):
    return max(gamma**k * r for k, r in enumerate(rewards))


def return_total_starts_with_first_loop(rewards, gamma):
    total = rewards[0]
    for k, r in enumerate(rewards):
        total += gamma**k * r
    return total


def return_return_indented_one_too_many(rewards, gamma):
    total, factor = 0, 1
    for r in rewards:
        total += factor * r
        factor = factor * gamma
        if factor < 0.01:
            return total
    return total


WRONG = {
    "discounted_return": [
        (return_index_of_a_value, "index(r) finds the first"),
        (return_range_of_list, "a whole number is"),
        (return_list_times, "a whole list is"),
        (return_recursion_no_base, "rewards is empty here"),
        (return_factor_before, "your factor begins with"),
        (return_range_from_1, "rewards has 4 entries, numbered"),
        (return_sum_of_generator_parenthesised_wrong, "each reward has its"),
        (return_numpy_with_list_power, "a range cannot be"),
        (return_max, "this is the largest"),
        (return_total_starts_with_first_loop, "the first reward is"),
        (return_return_indented_one_too_many, "a small factor is"),
    ],
    "far_from_the_goal": [
        (1 / 0.512, "γ makes what comes"),
        (0.8 ** (1 / 3), "this is the third"),
        (0.8**4 + 0.8**3, "only the last of"),
    ],
}
