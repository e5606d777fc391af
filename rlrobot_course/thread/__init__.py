"""A thread of the learner's own through lessons 14, 16 and 18: their rows, their model, their robot over a link.

`my_robot.txt` is the task file that the learner gets, and may change; `rows` finds the learner's rows, keeps them, and
has a stand-in where there are none; `not_known` draws what a model of them does not know; `numbers` lets an agent learn
in it and measures that agent; `last_page` compares what was promised, simulated and driven.
"""
