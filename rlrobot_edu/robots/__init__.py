"""Robots, the arenas that they move about in, and the environment that lets an agent act through them.

The data, each in the words of those before it:

Solid, Scene    a rigid body; all that a viewer draws of one instant (scene.py)
Wall, Arena     an upright box; walls, a starting place and perhaps a goal (arenas.py)
Chassis         dimensions of a robot on two wheels: those of the Pioneer and of Giraff (chassis.py)
Realism         how far a robot is from ideal (realism.py)

What uses them:

Robot           what an environment asks of a robot: reset, act, readings, scene, close (robot.py)
CellRobot       the robot of the paper's worked example, the shortest one (cell_robot.py)
WheeledBase     a Pioneer 3-DX with eight lasers: its arena, and how it looks (wheeled_base.py)
MobileBase      the same, moved by pymunk (mobile_base.py); Giraff keeps its distance (giraff.py)
RealisticRobot  any robot, with noise, slip and delay (realism.py)
KinematicRobot  a robot of geometry alone, compiled (engines/kinematic/)
RobotEnv        a task and its robot as a Gymnasium environment (robot_env.py)

arm/ holds all of the arm, engines/ the other simulators: PyBullet, and geometry alone.

Begin with robot.py and cell_robot.py, then robot_env.py; mobile_base.py holds the physics.
"""
