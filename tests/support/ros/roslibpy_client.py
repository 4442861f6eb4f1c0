"""A ROS client in Python, which connects by each kind of key and drives.

    ROSLIBPY_TRANSPORT=twisted|asyncio python roslibpy_client.py URL KEY URL_WITH_KEY

Prints one line of JSON: what it received.
"""

import json
import sys
import threading
import time

import roslibpy

WAIT_S = 20


def once(topic):
    """The next message of a topic."""
    found = []
    arrived = threading.Event()

    def on_message(message):
        found.append(message)
        arrived.set()

    topic.subscribe(on_message)
    if not arrived.wait(WAIT_S):
        raise SystemExit(f"no message of {topic.name}")
    topic.unsubscribe()
    return found[0]


def goal(ros, name, kind, values):
    """The result of a goal."""
    client = roslibpy.ActionClient(ros, name, f"corridor_msgs/action/{kind}")
    results = []
    goal_id = client.send_goal(
        roslibpy.Goal(values), results.append, lambda _: None, results.append
    )
    client.wait_goal(goal_id, WAIT_S)
    [result] = results
    values = result["values"]
    # A goal that could not be served has a text.
    return {
        "values": values if isinstance(values, str) else dict(values),
        "status": result["status"].value,
    }


def main():
    url, key, url_with_key = sys.argv[1:]
    by_header = roslibpy.Ros(url, headers={"Authorization": f"Bearer {key}"})
    by_path = roslibpy.Ros(url_with_key)
    by_auth = roslibpy.Ros(url)
    by_auth.authenticate(key, "", "", "", 0, "", 0)
    for each in (by_header, by_path, by_auth):
        each.run()
    ros = by_header
    odom = once(roslibpy.Topic(ros, "/odom", "nav_msgs/Odometry"))
    scan = once(roslibpy.Topic(by_path, "/scan", "sensor_msgs/LaserScan"))
    pose = once(roslibpy.Topic(by_auth, "/pose2d", "geometry_msgs/Pose2D"))
    stop = roslibpy.Service(ros, "/stop", "std_srvs/Trigger")
    reset = roslibpy.Service(ros, "/reset", "std_srvs/Trigger")
    found = {
        "position": odom["pose"]["pose"]["position"],
        "ranges": scan["ranges"],
        "pose": pose,
        "topics": ros.get_topics(),
        "type": ros.get_topic_type("/odom"),
        "time": ros.get_time()["secs"],
        "move": goal(ros, "/move", "Move", {"distance": 1.0}),
        "crash": goal(ros, "/move", "Move", {"distance": 50.0}),
        "wrong": goal(ros, "/do", "Do", {"action": "fly"}),
        "reset": dict(reset.call(roslibpy.ServiceRequest(), timeout=WAIT_S)),
    }
    velocity = roslibpy.Topic(ros, "/cmd_vel", "geometry_msgs/Twist")
    velocity.advertise()
    for _ in range(5):
        velocity.publish({"linear": {"x": 0.5, "y": 0, "z": 0}, "angular": {"x": 0, "y": 0, "z": 0}})
        time.sleep(0.1)
    found["stop"] = dict(stop.call(roslibpy.ServiceRequest(), timeout=WAIT_S))
    print(json.dumps(found), flush=True)
    for each in (by_header, by_path, by_auth):
        each.close()
    ros.terminate()


if __name__ == "__main__":
    main()
