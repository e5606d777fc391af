"""A robot that is on now: it is heard and told what to do over ROS 1 or ROS 2."""
