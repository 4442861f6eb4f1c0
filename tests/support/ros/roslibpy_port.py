"""A ROS client in Python that knows only a host and a port, as tutorials of ROS do.

    python roslibpy_port.py PORT

Prints one line of JSON: what it received.
"""

import json
import math
import sys
import time

import roslibpy

from roslibpy_client import WAIT_S, goal, once


def main():
    [port] = sys.argv[1:]
    ros = roslibpy.Ros("localhost", int(port))
    ros.run()
    ranges = roslibpy.Topic(ros, "/scan", "sensor_msgs/LaserScan")
    stop = roslibpy.Service(ros, "/stop", "std_srvs/Trigger")
    velocity = roslibpy.Topic(ros, "/cmd_vel", "geometry_msgs/Twist")
    velocity.advertise()
    found = {
        "topics": ros.get_topics(),
        "before": once(ranges)["ranges"],
        "move": goal(ros, "/move", "Move", {"distance": 1.0}),
        "turns": [goal(ros, "/turn", "Turn", {"angle": math.pi / 2})["status"] for _ in range(4)],
        "after": once(ranges)["ranges"],
    }
    for _ in range(10):
        velocity.publish({"linear": {"x": 0.5, "y": 0, "z": 0}, "angular": {"x": 0, "y": 0, "z": 0}})
        time.sleep(0.1)
    found["stop"] = dict(stop.call(roslibpy.ServiceRequest(), timeout=WAIT_S))
    found["driven"] = once(ranges)["ranges"]
    print(json.dumps(found), flush=True)
    ros.terminate()


main()
