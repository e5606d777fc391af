"""Simulators other than pymunk: bullet/ is physics in three dimensions, kinematic/ is geometry alone, compiled."""
