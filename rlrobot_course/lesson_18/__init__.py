"""Lesson 18, a real robot: who stops it, what goes over ROS, what it may do, and a rehearsal in simulation."""

from rlrobot_course.lesson_18.exercises import check as check
