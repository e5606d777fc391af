#!/usr/bin/env bash
# rospy and a ROS 1 master for tests/test_rospy.py: Debian's packages (Ubuntu's do, too), unpacked, not installed.
#
#     tests/unpack_rospy.sh FOLDER
#     RLROBOT_EDU_ROSPY=FOLDER make test
#
# They land in FOLDER/usr/lib/python3/dist-packages. Only what pip does not bring is among them: a folder on PYTHONPATH
# comes before the environment's own packages, and an older yaml or numpy must not hide those.
set -euo pipefail

packages=(
    python3-{rospy,rosgraph,roslib,rosmaster,rospkg,catkin,catkin-pkg,genmsg,genpy}
    python3-{roscpp-msg,rosgraph-msgs,std-msgs,actionlib-msgs,geometry-msgs,nav-msgs,sensor-msgs}
)

if [ $# -ne 1 ]; then
    echo "usage: tests/unpack_rospy.sh FOLDER" >&2
    exit 2
fi
mkdir -p "$1"
folder=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work"/{debs,state/lists/partial,cache/archives/partial,unpacked}
cd "$work/debs"

# What apt knows may be nothing, or old; then it asks again, for this folder alone: so nobody needs to be root.
aside=(-o Dir::State="$work/state" -o Dir::State::status=/var/lib/dpkg/status -o Dir::Cache="$work/cache")
quietly=(-qq -o APT::Sandbox::User="$(id -un)" -o Acquire::Retries=2 -o Acquire::http::Timeout=30)
if ! apt-get "${quietly[@]}" download "${packages[@]}" 2>/dev/null; then
    rm -f ./*
    apt-get "${quietly[@]}" "${aside[@]}" update
    apt-get "${quietly[@]}" "${aside[@]}" download "${packages[@]}"
fi

for package in *.deb; do
    dpkg-deb --extract "$package" "$work/unpacked"
done
cp -R "$work/unpacked/." "$folder"
