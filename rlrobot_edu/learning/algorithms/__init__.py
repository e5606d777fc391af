"""One file an algorithm, and nothing else: put two side by side, and the update rule is what differs.

In each kernel `m` is the agent's memory, see ../memory.py.

Begin with q_learning.py and sarsa.py; then expected_sarsa.py, sarsa_lambda.py and true_online_sarsa.py.
"""
