"""All of the arm: its body, and the robots that have one.

arm_body.py               lengths, joints and sensors, from arm.urdf
kinematic_arm.py          the arm as geometry alone
bullet_arm.py             the arm in PyBullet, with weights and contact
kinematic_manipulator.py  the arm on the mobile base in pymunk
bullet_manipulator.py     the same in PyBullet

Its card, with sensors, commands and engines, is in task/robot_cards.toml, as those of all robots.
Begin with arm_body.py and kinematic_arm.py.
"""
