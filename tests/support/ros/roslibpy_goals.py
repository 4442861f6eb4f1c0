"""A ROS client in Python, which follows a goal, cancels another, and drives by velocities.

    ROSLIBPY_TRANSPORT=twisted|asyncio python roslibpy_goals.py URL KEY

Prints one line of JSON: what it received.
"""

import json
import sys
import threading
import time

import roslibpy

WAIT_S = 20


class Goal:
    """A goal of the action /move."""

    def __init__(self, ros, distance):
        self.feedback = []
        self.is_fed = threading.Event()
        self.result = None
        self.is_over = threading.Event()
        self.client = roslibpy.ActionClient(ros, "/move", "corridor_msgs/action/Move")
        self.id = self.client.send_goal(
            roslibpy.Goal({"distance": distance}), self.on_result, self.on_feedback, self.on_result
        )

    def on_feedback(self, message):
        self.feedback.append(dict(message))
        self.is_fed.set()

    def on_result(self, result):
        self.result = result
        self.is_over.set()

    def wait(self, event):
        if not event.wait(WAIT_S):
            raise SystemExit("a goal has no feedback, or no result")

    def ended(self):
        self.wait(self.is_over)
        values = dict(self.result["values"])
        return {"values": values, "status": self.result["status"].value}


def main():
    url, key = sys.argv[1:]
    ros = roslibpy.Ros(url, headers={"Authorization": f"Bearer {key}"})
    ros.run()
    first = Goal(ros, 0.5)
    completed = first.ended()
    second = Goal(ros, 3.0)
    second.wait(second.is_fed)
    second.client.cancel_goal(second.id)
    cancelled = second.ended()
    velocity = roslibpy.Topic(ros, "/cmd_vel", "geometry_msgs/Twist")
    for speed in [-0.261] * 5 + [0]:
        velocity.publish({"linear": {"x": speed, "y": 0, "z": 0}})
        time.sleep(0.1)
    print(
        json.dumps(
            {
                "feedback": first.feedback + second.feedback,
                "completed": completed,
                "cancelled": cancelled,
                "time": ros.get_time(),
            },
            default=dict,
        ),
        flush=True,
    )
    ros.terminate()


if __name__ == "__main__":
    main()
