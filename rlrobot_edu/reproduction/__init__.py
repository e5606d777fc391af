"""Reproduction: the paper's experiments, run again, and a report in which our numbers stand beside its own.

The data, first:

Experiment, PaperPair (paper.py)   one of the paper's comparisons and what it says of it, as printed
Outcome               (report.py)  what came of it here

Begin with paper.py, which holds what the paper says; run.py runs it (``make reproduce``), report.py writes the page.
"""
