"""Open challenges with a score, and the scoreboard of the learner's code so far."""
