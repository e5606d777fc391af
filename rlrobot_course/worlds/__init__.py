"""What the learner's own code acts in: recorded tapes, short and tabular worlds, an environment with another reward."""
