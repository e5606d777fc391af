"""Lesson 18, a real robot: who stops it, what goes over ROS, and what it may do."""

from rlrobot_course.lesson_18.exercises import check as check
