"""For authors of lessons: ``rlrobot-edu course check 04``, ``course new 23 "Title"``, ``course table``
and ``course mistakes``.

All but the last work in a checkout of the project, where the notebooks and the tests are. Read in this order:

- `lists`: the one list of lessons, which is the folder `notebooks/`, and the places that repeat it;
- `commands`: what follows ``course`` on the command line;
- `new_lesson`: a lesson is written from `template/`, and its notebook is run;
- `catalogue`: the mistakes of all lessons, as data, with what each does first.
"""
