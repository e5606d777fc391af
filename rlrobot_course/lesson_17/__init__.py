"""Lesson 17, a real robot: what goes over ROS, what keeps a robot from harm, and a rehearsal in simulation."""

from rlrobot_course.lesson_17.exercises import check as check
