/**
 * Programs of ROS: they turn the robot left and print the free distance in front of it. A velocity has
 * no answer, so they also print why it is refused, such as while Remote is not driving.
 */
import { rosUrlOf, type RobotParts } from "./robot-parts.ts";

export function roslibpy(robot: RobotParts): string {
  return `# First: pip install roslibpy
import time
import roslibpy

ros = roslibpy.Ros("${rosUrlOf(robot)}", headers={"Authorization": "Bearer ${robot.key}"})
ros.run()
scan = roslibpy.Topic(ros, "/scan", "sensor_msgs/LaserScan", throttle_rate=500)
scan.subscribe(lambda message: print("front", message["ranges"][2]))
roslibpy.Topic(ros, "/rosout", "rcl_interfaces/Log").subscribe(lambda message: print(message["msg"]))
velocity = roslibpy.Topic(ros, "/cmd_vel", "geometry_msgs/Twist")
for _ in range(15):
    velocity.publish({"linear": {"x": 0.0}, "angular": {"z": 1.5}})
    time.sleep(0.1)
ros.terminate()
`;
}

export function roslib(robot: RobotParts): string {
  return `// First: npm install roslib
import { Ros, Topic } from "roslib";

const ros = new Ros({ url: "${rosUrlOf(robot)}" });
ros.authenticate("${robot.key}", "", "", "", 0, "", 0);
const scan = new Topic({ ros, name: "/scan", messageType: "sensor_msgs/LaserScan", throttle_rate: 500 });
scan.subscribe(({ ranges }) => console.log("front", ranges[2]));
const problems = new Topic({ ros, name: "/rosout", messageType: "rcl_interfaces/Log" });
problems.subscribe(({ msg }) => console.log(msg));
ros.on("close", ({ reason }) => reason && console.log(reason));
const velocity = new Topic({ ros, name: "/cmd_vel", messageType: "geometry_msgs/Twist" });
const left = { linear: { x: 0, y: 0, z: 0 }, angular: { x: 0, y: 0, z: 1.5 } };
const timer = setInterval(() => velocity.publish(left), 100);
setTimeout(() => {
  clearInterval(timer);
  ros.close();
}, 1500);
`;
}

/** The URL for programs that cannot send a key in another way. */
export function rosbridge(robot: RobotParts): string {
  return `${rosUrlOf(robot)}/${robot.urlKey}`;
}
