"""A ROS client in Python that publishes ten velocities a second, whatever happens to its connection.

    ROSLIBPY_TRANSPORT=twisted|asyncio python velocity_stream.py URL KEY

Turns on the spot: angular z is 1 rad/s, and one thousandth more for each velocity. Prints a line of
JSON for each published velocity and each received pose, until its input ends.
"""

import json
import sys
import threading
import time

import roslibpy

PER_SECOND = 10


def report(what, number):
    line = json.dumps({"what": what, "number": number, "at": time.time() * 1000})
    # One call: messages arrive in a thread of their own.
    sys.stdout.write(line + "\n")
    sys.stdout.flush()


def main():
    url, key = sys.argv[1:]
    ended = threading.Event()

    def read():
        sys.stdin.read()
        ended.set()

    threading.Thread(target=read, daemon=True).start()
    ros = roslibpy.Ros(url, headers={"Authorization": f"Bearer {key}"})
    ros.run()
    poses = roslibpy.Topic(ros, "/pose2d", "geometry_msgs/Pose2D")
    poses.subscribe(lambda pose: report("pose", pose["theta"]))
    velocity = roslibpy.Topic(ros, "/cmd_vel", "geometry_msgs/Twist")
    velocity.advertise()
    number = 0
    while not ended.wait(1 / PER_SECOND):
        number += 1
        twist = {
            "linear": {"x": 0, "y": 0, "z": 0},
            "angular": {"x": 0, "y": 0, "z": 1 + number / 1000},
        }
        velocity.publish(roslibpy.Message(twist))
        report("published", number)
    ros.terminate()


main()
