"""Experiments: many repetitions, the comparison of methods, and what they prove.

The data, first:

Runs         (runs.py)        the histories of one method's repetitions, with their curves and final rewards
Comparison   (comparison.py)  the Runs of several methods, with tests and tables
Anova, Tukey (statistics.py)  analysis of variance, post-hoc test; Interval, an estimate with its bounds
Table        (tables.py)      rows of words and numbers, as text or HTML

Begin with repeat.py: what a repetition does, and how repetitions get their random numbers. Then compare.py,
which does the same for several methods; store.py, the folder of histories in which it keeps what is finished;
and statistics.py. workers.py is how several cores share the work.
"""
