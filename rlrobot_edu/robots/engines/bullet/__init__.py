"""Robots in PyBullet (three-dimensional physics): for what has joints, or wheels that slip.

Around the library: PyBullet is the extra ``arm``. The robots' bodies are data: mobile_base.urdf here and arm.urdf in
robots/, in metres, kilograms and radians.

BulletSimulation   PyBullet with a clock, a floor, walls and laser beams, for one robot alone (simulation.py)
Motors, Part       the motors in a robot's joints; wheels or an arm, with their motors and sensors (robot.py)
BulletRobot        what these robots do alike: rest, begin again, move, look (robot.py)
Arm                three joints and a gripper over a table (arm.py)
BulletBase         the mobile base, its wheels held by friction (mobile_base.py)
MobileManipulator  the arm on the base (mobile_manipulator.py)

Begin with arm.py, and look up in robot.py and simulation.py what it uses.
"""
