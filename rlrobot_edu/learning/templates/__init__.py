"""Kernels that are made for a method: templates, see jit/building.py. As they stand here they are Q+SR's.

step.py          one step of learning: the transition goes in, the next action comes out
planned_step.py  the same with the steps that a planner imagines
checked.py       an update and a selection of one's own, and a look at what they leave
loop.py          a whole learning process, in a world of kernels
"""
