"""Lesson 18a, who stops a robot when its program dies, and how one begins with a real robot."""

from rlrobot_course.lesson_18a.exercises import check as check
