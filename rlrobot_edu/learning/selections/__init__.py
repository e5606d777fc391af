"""One file a rule by which actions are selected, and nothing else.

greedy.py (greedy, ε-greedy, random), least_explored.py, softmax.py, and qbiassr.py, which adds a bias to softmax.
"""
