"""Right answers and tapes of lesson 08a; what is asked, hints and mistakes stand on the pages beside."""

from rlrobot_course.grading.parts import Exercise, Formula, Question, with_pages


def lambda_return(rewards, values, gamma, lam):
    n, total, mean = len(rewards), 0.0, 0.0
    for k in range(1, n + 1):
        total += gamma ** (k - 1) * rewards[k - 1]
        g = total + gamma**k * values[k - 1]  # the k-step return
        weight = lam ** (n - 1) if k == n else (1 - lam) * lam ** (k - 1)
        mean += weight * g
    return mean


check = with_pages(
    globals(),
    lambda_return=Exercise(
        lambda_return,
        returns="G",
        tape=[
            {"rewards": [10.0, -0.02, -2.0], "values": [7.0, 5.0, 4.0], "gamma": 0.9, "lam": 0.8},
            {"rewards": [10.0], "values": [4.0], "gamma": 0.9, "lam": 0.9},
            {"rewards": [10.0, 10.0], "values": [0.0, 5.0], "gamma": 0.95, "lam": 0.9},
            {"rewards": [1.0, -2.0], "values": [6.0, -3.0], "gamma": 0.7, "lam": 0.5},
            {"rewards": [-0.02, -0.02, 10.0, 10.0], "values": [1.0, 2.0, 3.0, 0.0], "gamma": 0.8, "lam": 0.9},
            {"rewards": [1.0, 2.0, 3.0], "values": [4.0, 5.0, 6.0], "gamma": 0.9, "lam": 0.0},
            {"rewards": [-2.0, 3.0, -0.02], "values": [2.0, 5.5, 6.0], "gamma": 0.6, "lam": 1.0},
        ],
    ),
    largest_alpha=Question(Formula("1 / trace", γ=0.9, λ=0.9, trace="1 / (1 - γ * λ)")),
)
