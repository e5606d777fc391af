"""Robots as kernels, without a physics engine: where the mobile base differs, docs/studies/kinematic_base.md.

trigonometry.py   sine and cosine, the same on every computer
motion.py         arcs, and what a wall makes of them; rays to the walls
holding.py        walls that hold: the same motion along walls with friction
base.py           KinematicBase, the robot that moves by them
robot.py          KinematicRobot, what such robots share: learning with one is one kernel
compiled_task.py  a task's rewards, goal and commands in that kernel

Begin with motion.py.
"""
