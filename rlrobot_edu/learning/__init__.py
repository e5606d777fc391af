"""Learning: agents and the loop in which they learn. This room knows no robot and no picture.

The data, first:

Parameters   (parameters.py)   what can be set about an agent, with domain and default
Memory       (memory.py)       the arrays that an agent's kernels read and write: Q, traces, visits …
Experience   (experience.py)   the outcomes that an agent has met, for one that plans
Algorithm    (algorithm.py)    an update rule, its equation and its name; Selection: a rule by which actions are chosen;
                               Planner: a way to learn from imagined steps
Size, World  (size.py)         what an agent must know of the place it learns in
Step         (loop.py)         one step of learning, as it is seen from outside
Transitions  (transitions.py)  columns of (s, a, r, s') and of the ends of episodes
History      (history.py)      what one learning process was

Begin with q_learning.py and put sarsa.py beside it: the update rule is what differs. Then expected_sarsa.py,
sarsa_lambda.py (with traces.py) and true_online_sarsa.py. Selections are softmax.py, qbiassr.py, greedy.py and
least_explored.py; vbiassr.py changes one thing about qbiassr.py, and loop_evasion.py raises their temperature.
dyna.py is a planner. methods.py lists them all and says what a method is, step.py makes a step of an algorithm and a
selection, and planned_step.py adds a planner. agent.py keeps the memory and writes it to a file, loop.py lets the
agent act, under a bar (progress.py), and observations.py says which state an observation is. validation.py checks the
numbers that reach a kernel, jit.py compiles the kernels, or does not, and kernel_cache.py keeps them, each under a
name that fingerprint.py makes of its code.

An algorithm, selection or planner of your own needs no place here: docs/howto/your_own_algorithm.md. Three selections
and a planner made like that stand in course: lesson_16b/biases.py and lesson_16/sweeping.py.
"""
