"""What only agents need that plan: they learn from imagined steps between two real ones.

experience.py    the outcomes that an agent has met
dyna.py          Dyna-Q, which imagines steps that it draws from them

A real step with the imagined ones after it is ../templates/planned_step.py.
"""
