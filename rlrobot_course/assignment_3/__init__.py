"""Assignment 3, credit where it is due: returns of n steps, three kinds of traces, Watkins's Q(λ)."""

from rlrobot_course.assignment_3.exercises import check as check
