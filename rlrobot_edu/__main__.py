"""``python -m rlrobot_edu COMMAND``: see `tools.commands`."""

from rlrobot_edu.tools.commands import main

if __name__ == "__main__":
    main()
