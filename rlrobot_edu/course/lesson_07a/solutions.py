"""Solution of appendix 07a, as a learner writes it."""

best_adviser = "floor"
