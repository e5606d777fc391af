"""The kernels as JavaScript: the same source runs in a page, where it learns as fast as compiled.

translator.py   one function, node by node; what it does not know it refuses, with file and line
arrays.py       which expressions are whole arrays
vocabulary.py   names, operators and values in both languages
program.py      all functions that a kernel calls, as one self-contained text; a method, and its loop in a sample model

Begin with program.py.
"""
