"""The kernels as JavaScript: the same source runs in a page, as fast as compiled.

translator.py   one function, node by node; it refuses what it cannot translate, with file and line
arrays.py       which names and expressions are whole arrays
vocabulary.py   names, operators and values in both languages
program.py      all functions that a kernel calls, as one self-contained text; a method, and its loop in a sample model

Begin with program.py.
"""
