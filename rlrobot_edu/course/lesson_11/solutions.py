"""Solutions of lesson 11, as a learner writes them."""

targets = (10.0, 10 + 0.9 * 50)
to_and_fro = (5 - 0.9 * 1) / (1 - 0.9**2)


def shaping(phi, phi_next, terminated, gamma):
    if terminated:
        phi_next = 0.0
    return gamma * phi_next - phi
