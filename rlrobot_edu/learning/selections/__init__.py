"""One file a rule by which actions are selected, and nothing else.

In each kernel `m` is the agent's memory, see ../memory.py.

greedy.py (greedy, ε-greedy, random), least_explored.py, softmax.py, and qbiassr.py, which adds a bias to softmax.
"""
