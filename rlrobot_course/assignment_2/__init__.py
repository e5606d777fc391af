"""Assignment 2, on or off policy: what a target promises, and a maximum that is too hopeful."""

from rlrobot_course.assignment_2.exercises import check as check
