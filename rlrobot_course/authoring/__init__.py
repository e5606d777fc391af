"""For authors of lessons: ``rlrobot-edu course check 04``, ``course new 18 "Title"``, and ``course explain``.

They work in a checkout of the project, where the notebooks and the tests are. Read in this order:

- `lists`: the one list of lessons, which is the folder `notebooks/`, and the places that repeat it;
- `commands`: what follows ``course`` on the command line;
- `one_lesson`: pytest's option ``--lesson 06``, for the tests of one lesson;
- `explain`: which detectors have a hint for a wrong answer;
- `new_lesson`: a lesson is written from `template/`, and its notebook is run.
"""
