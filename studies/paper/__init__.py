"""Reproduction: the paper's experiments, run again, and a report in which our numbers stand beside its own.

The data, first:

PaperPair  (paper.py)        what the paper says of two methods, as printed
Experiment (experiments.py)  one comparison: where, which methods, how long, how often
Outcome    (outcome.py)      what came of it
Verdict    (verdicts.py)     in what the two agree
Cause      (cause.py)        why they do not, and whether an experiment shows it

Begin with paper.py and experiments.py; worlds.py changes one thing of a task or a model, to show a cause. run.py runs
all of it (``make reproduce``); causes.py, causes_in_models.py and claims.py judge; report.py, sections.py and
figures.py write the page.
"""
