"""Assignment 5, a task of your own, and was it luck: a reward for parking, a policy's value, a verdict."""

from rlrobot_course.assignment_5.exercises import check as check
