"""Robots in PyBullet (three-dimensional physics): for what has joints, or wheels that slip. It is the extra ``arm``.

BulletSimulation   PyBullet with a clock, a floor, walls and laser beams, for one robot alone (simulation.py)
Motors, Part       the motors in a robot's joints; wheels or an arm, with their motors and sensors (robot.py)
BulletRobot        what these robots do alike: rest, begin again, move (robot.py)
BulletBase         the mobile base, its wheels held by friction (mobile_base.py, mobile_base.urdf)

The arm's robots are in robots/arm. Begin with robots/arm/bullet_arm.py, and look up in robot.py and simulation.py what
it uses.
"""
