"""Typical wrong answers of lesson 11, written as learners write them, and a word of the hint each must get."""


def shaping_past_the_end(phi, phi_next, terminated, gamma):
    return -phi + gamma * phi_next


def shaping_without_gamma(phi, phi_next, terminated, gamma):
    after = 0 if terminated else phi_next
    return after - phi


def shaping_discounts_all(phi, phi_next, terminated, gamma):
    return gamma * ((0 if terminated else phi_next) - phi)


def shaping_turned_round(phi, phi_next, terminated, gamma):
    return phi if terminated else phi - gamma * phi_next


def shaping_pays_gains_only(phi, phi_next, terminated, gamma):
    gain = gamma * phi_next * (not terminated) - phi
    return gain if gain > 0 else 0


def shaping_stops_at_the_end(phi, phi_next, terminated, gamma):
    return (gamma * phi_next - phi) * (not terminated)


WRONG = {
    "targets": [
        ((55, 10), "the other way round"),
        ((10, 10), "really over"),
        ([10, 60], "counts 0.9 times"),
        ((55, 55), "the world ends"),
        ((0, 55), "also at the end"),
    ],
    "to_and_fro": [
        (4.1 / 0.1, "two steps"),
        (4 / 0.19, "one step later"),
        (5 - 0.9, "one round only"),
        (2, "mean reward"),
        (20, "5 comes first"),
        (3.5 / 0.19, "begins with the −1"),
    ],
    "shaping": [
        (shaping_past_the_end, "past the end"),
        (shaping_without_gamma, "γ is missing"),
        (shaping_discounts_all, "not the whole difference"),
        (shaping_turned_round, "the sign"),
        (shaping_pays_gains_only, "only a gain"),
        (shaping_stops_at_the_end, "still taken off"),
    ],
}
