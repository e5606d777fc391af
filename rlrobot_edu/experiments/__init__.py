"""Experiments: many repetitions, the comparison of methods, and what they prove.

The data, first:

Runs         (runs.py)        the histories of one method's repetitions, with their curves and final rewards
Comparison   (comparison.py)  the Runs of several methods, with tests and tables
Anova, Tukey (statistics.py)  analysis of variance, post-hoc test; Interval, an estimate with its bounds
Table        (tables.py)      rows of words and numbers, as text or HTML
Sweep        (sweep.py)       what one method earned at many settings, each with the same robots

Begin with compare.py: `compare`, how each repetition gets its random numbers, and `repeat`, which compares one method.
Then repetitions.py: what a repetition does, and how all of them run on several cores; store.py, the folder of
histories in which a comparison keeps what is finished; and statistics.py, which takes numbers that rounding alone
makes unequal as equal (rounding.py). Last, sweep.py: `sweep` asks how much tuning gains, and how much of that is luck.
"""
