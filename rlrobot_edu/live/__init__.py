"""Pages that are told what is new while a program runs.

window.py   served to the browsers of this computer
carried.py  in a notebook, whose own connection carries the news (frame.js), so that it is seen wherever the notebook is
"""
