"""The commands of this package: ``rlrobot-edu serve-robot``."""

import contextlib

from rlrobot_edu.tools.commands import Commands


def serve_robot(task: str, port: int, simulated_time: bool) -> None:
    """Let a simulated robot speak ROS, as a real one would, until Ctrl-C; to rehearse with RobotLink."""
    from rlrobot_ros.live.served_robot import ServedRobot

    served = ServedRobot(task, simulated_time=simulated_time, port=port)
    with served as robot, contextlib.suppress(KeyboardInterrupt):
        print(
            f"The robot is on: odom, laser_scan and cmd_vel over rosbridge at {robot.address}. Ctrl-C ends it.",
            flush=True,
        )
        robot.wait()


def add_commands(commands: Commands) -> None:
    """Add the commands of this package."""
    command = commands.add("serve-robot", serve_robot, "giraff_wander_1k --port 9091")
    command.add_argument(
        "task",
        nargs="?",
        default="giraff_wander_simple",
        help="%(default)s if not given",
    )
    command.add_argument("--port", type=int, default=9090, help="9090 if not given")
    command.add_argument(
        "--simulated-time",
        action="store_true",
        help="time passes only as commands come",
    )
