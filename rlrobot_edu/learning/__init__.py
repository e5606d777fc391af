"""Learning: agents and the loop in which they learn. This folder knows no robot and no picture.

The data, first:

Parameters   (parameters.py)   what can be set about an agent, with domain and default
Memory       (memory.py)       the arrays that an agent's kernels read and write: Q, traces, visits …
Experience   (planning/)       the outcomes that an agent has observed, for one that plans
Algorithm    (algorithm.py)    an update rule, its equation and its name; Selection: a rule by which actions
                               are chosen; Planner: a way to learn from imagined steps
Size         (size.py)         what an agent must know of the place it learns in
Step         (loop.py)         one step of learning, as it is seen from outside
Transitions  (transitions.py)  columns of (s, a, r, s') and of the ends of episodes
History      (history.py)      what one learning process was

Begin with algorithms/q_learning.py and compare it with algorithms/sarsa.py: only the update rule differs. In every
kernel `m` is the agent's memory, see memory.py. Each algorithm and each selection has its own file; planning/ holds
what only planners need. traces.py serves SARSA(λ) and true online SARSA(λ); loop_evasion.py raises the temperature of
a softmax. methods.py lists them all and says what a method is. templates/step.py is one step of learning, and
step.py puts an algorithm and a selection in their places there.

agent.py keeps the memory and writes what was learned to a file. loop.py lets the agent act, under a bar (progress.py),
and observations.py numbers the states that an environment shows. divergence.py notices values that grow without end.
resolve.py finds the world that a name stands for.
resume.py says where an agent left its episode; interrupts.py lets Ctrl-C wait until a step is done.
compiled_loop.py is the same loop as one kernel, in the worlds that kernel_world.py describes. own_code.py says what is
wrong with an algorithm of your own.
The folder jit, beside this one, compiles the kernels where numba is installed.

An algorithm, selection or planner of your own needs no place here: docs/howto/your_own_algorithm.md. Four selections
and a planner made like that are in rlrobot_course: lesson_22 and lesson_17/sweeping.py.
"""
