"""Lesson 08. Loop evasion: a robot that goes round in circles for nothing gets restless."""
