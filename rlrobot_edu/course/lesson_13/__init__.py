"""Lesson 13, sample models: a recording becomes a world to learn in, quick, and at times too good to be true."""
