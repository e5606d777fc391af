"""Lesson 01. States, actions, rewards and returns."""
