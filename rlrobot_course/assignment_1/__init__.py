"""Assignment 1, a robot's day as numbers: a corridor with a charger, from readings to a policy."""

from rlrobot_course.assignment_1.exercises import check as check
