"""Why is this number so? Which rewards a value is made of, exactly.

linear.py   numbers that remember of which rewards they are made, and kernels that run on them
credit.py   `credit`: an agent learns, and each of its values can say who paid for it; begin here
"""
