"""Solutions of lesson 01a, as a learner writes them."""


def discounted_return(rewards, gamma):
    total = 0
    for k, r in enumerate(rewards):
        total += gamma**k * r
    return total


far_from_the_goal = 0.8**3
