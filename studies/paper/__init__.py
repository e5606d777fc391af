"""Reproduction: the paper's experiments, run again, and their tables in which our numbers stand beside its own.

The data, first:

PaperPair  (paper.py)        what the paper says of two methods, as printed
Experiment (experiments.py)  one comparison: where, which methods, how long, how often
Outcome    (outcome.py)      what came of it, as averages.csv has it
Verdict    (verdicts.py)     in what the two agree

Begin with paper.py and experiments.py; worlds.py changes one thing of a task or a model, to show a cause. run.py runs
all of it (``make reproduce``); tables.py, tally.py (the paper's pairs, counted by several tests) and figures.py make
what report.py puts into the page. People write the rest.
"""
