"""Lesson 18, a real robot: what goes over ROS, what keeps a robot from harm, and a rehearsal in simulation."""

from rlrobot_course.lesson_18.exercises import check as check
