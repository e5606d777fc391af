"""The mobile base as kernels, without a physics engine: where it differs, docs/studies/kinematic_base.md.

motion.py    arcs, and what a wall makes of them; rays to the walls
base.py      KinematicBase, the robot that moves by them

Begin with motion.py.
"""
