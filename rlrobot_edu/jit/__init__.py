"""The compiler: kernels become machine code with numba, where it is installed.

dispatcher.py   `compiled`, which makes a function a dispatcher of numba's: it compiles when it is first called
caching.py      where compiled kernels are kept, so that a computer compiles each of them once
fingerprint.py  a short name of all that a function is made of, by which the cache and stores know it

Begin with dispatcher.py. Nothing here is needed to understand how an agent learns.
"""
