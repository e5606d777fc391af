"""The compiler: kernels become machine code with numba, where it is installed.

dispatcher.py   `compiled`, which hands a kernel to numba
building.py     `build`, which puts kernels together: a template with other parts
call.py         the smallest template: one kernel, called from Python
own.py          somebody's own kernels, with what they call
python_math.py  what `math` is to these: it raises where Python's does
fingerprint.py  a short name of all that a function is made of, by which stores and files know it

Begin with dispatcher.py. Nothing here is needed to understand how an agent learns.
"""
