"""Assignment 4, advice and escape: who advises a state, when a robot goes in circles, and what it does then."""

from rlrobot_course.assignment_4.exercises import check as check
