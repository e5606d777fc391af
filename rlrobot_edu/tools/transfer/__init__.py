"""Knowledge carried over from one task to another: from robot to robot, from few inputs to more.

Read in this order: ``bins.py``, which bins of an input are which of another; ``commands.py``, which action does what
another does; ``transfer.py``, the function that carries Q over by both; ``report.py``, what it tells of that.
"""
