/** The gateway for ROS clients: rosbridge v2 with the units of REP 103. */
import type { Snapshot } from "@corridor/protocol";
import type { CheckGroup } from "../../check.ts";
import { connectSocket } from "../../connection.ts";
import { pause, type Host } from "../../host.ts";
import { must, numberAt, valueAt } from "../../mismatch.ts";
import { isNear, moveToStart, mustHaveReadings, mustStand, readings } from "../../pen.ts";
import { RosConnection } from "../../ros-connection.ts";
import { distance, drive, publish } from "../../ros-velocity.ts";

const TOLERANCE_RADIANS = 0.07;
const TOLERANCE_METRES = 0.06;
/** of the speed of a turn, in rad/s */
const TOLERANCE_TURN = 0.3;
/** ms in which a robot stops after a velocity of zero. The lease of a velocity is longer. */
const STOP_MS = 200;
/** ms until the lease of the last velocity has ended */
const LEASE_MS = 1_000;
/** ms in which a message that nobody requested would arrive */
const QUIET_MS = 500;

/** What is in every list of topics. */
const topics = {
  "/cmd_vel": "geometry_msgs/Twist",
  "/odom": "nav_msgs/Odometry",
  "/scan": "sensor_msgs/LaserScan",
  "/range/front": "sensor_msgs/Range",
  "/range/right": "sensor_msgs/Range",
  "/range/back": "sensor_msgs/Range",
  "/range/left": "sensor_msgs/Range",
  "/pose2d": "geometry_msgs/Pose2D",
  "/tf": "tf2_msgs/TFMessage",
  "/tf_static": "tf2_msgs/TFMessage",
  "/bumper": "std_msgs/Bool",
  "/map": "nav_msgs/OccupancyGrid",
  "/clock": "rosgraph_msgs/Clock",
  "/rosout": "rcl_interfaces/Log",
  "/corridor/snapshot": "std_msgs/String",
};

export const ros: CheckGroup = {
  title: "ROS gateway",
  gateway: "ros",
  checks: [
    {
      promise: "ros-key",
      name: "a client connects with the key in the header Authorization",
      run: async (host) => {
        const values = await RosConnection.use(host, (ros) => ros.call("/rosapi/get_ros_version"));
        const version = numberAt(values, "version");
        must(version === 2, "ROS version 2", version);
      },
    },
    {
      promise: "ros-key-wrong",
      name: "a wrong key in the header is refused at the upgrade",
      run: async (host) => {
        const headers = host.authorization(host.wrongKey);
        const { socket, opened, closed } = connectSocket(host.gatewayUrl("ros"), headers);
        const code = await Promise.race([opened, closed]);
        socket.close();
        must(code !== null, "a refused upgrade for a wrong key", "an open WebSocket");
      },
    },
    {
      promise: "ros-quiet",
      name: "a client receives answers only, even if the robot moves and a message is refused",
      run: async (host) => {
        await RosConnection.use(host, async (ros) => {
          for (const action of ["left 90", "right 90"] as const) await host.sendAndWait({ action });
          ros.send({ op: "publish", topic: "/unknown_topic", msg: {} });
          await ros.call("/rosapi/get_time");
          await pause(QUIET_MS);
          must(ros.received.length === 1, "one answer and no other message", ros.received);
        });
      },
    },
    {
      promise: "ros-topics",
      name: "rosapi lists the topics with their types",
      run: async (host) => {
        const values = await RosConnection.use(host, (ros) => ros.call("/rosapi/topics"));
        const names = valueAt(values, "topics");
        must(Array.isArray(names), "a list of topics", values);
        for (const [topic, type] of Object.entries(topics)) {
          const found = valueAt(values, `types.${names.indexOf(topic)}`);
          const isRight = typeof found === "string" && found.replace("/msg/", "/") === type;
          must(isRight, `${topic} of the type ${type}`, found ?? names);
        }
      },
    },
    {
      promise: "ros-scan",
      name: "/scan has the distances in metres: back, right, front, left",
      run: async (host) => {
        const { sensors } = await moveToStart(host);
        const scan = await latest(host, "/scan");
        for (const [index, side] of (["back", "right", "front", "left"] as const).entries()) {
          const found = numberAt(scan, `ranges.${index}`);
          const expected = sensors[side] / 100;
          must(isNear(found * 100, sensors[side]), `about ${expected} m in the ${side}`, found);
        }
      },
    },
    {
      promise: "ros-odom",
      name: "/odom is in metres and radians, with x forward and yaw counter-clockwise",
      needs: ["pose"],
      run: async (host) => {
        await moveToStart(host);
        const start = await pose(host);
        await host.sendAndWait({ action: "left 90" });
        const turned = angle((await pose(host)).yaw - start.yaw);
        must(isAbout(turned, Math.PI / 2), "a yaw that grows by pi / 2 in left 90", turned);
        await host.sendAndWait({ action: "right 90" });
        await host.sendAndWait({ action: "move", distance: 60 });
        const end = await pose(host);
        const x = start.x + Math.cos(start.yaw) * 0.6;
        const y = start.y + Math.sin(start.yaw) * 0.6;
        const isThere = Math.hypot(end.x - x, end.y - y) < TOLERANCE_METRES;
        must(isThere, `x ${x} and y ${y} after 0.6 m`, end);
      },
    },
    {
      promise: "ros-velocity",
      name: "/cmd_vel drives by `linear.x` in m/s, and its lease ends the motion",
      run: async (host) => {
        await moveToStart(host);
        await RosConnection.use(host, async (ros) => {
          const velocity = { linear: { x: 0.5 } };
          const { speed } = await drive(host, ros, { velocity, amount: 150, travel: distance });
          must(isNear(speed, 50), "about 50 cm in a second of 0.5 m/s", speed);
          await pause(LEASE_MS);
          await mustStand(host);
        });
      },
    },
    {
      promise: "ros-velocity-zero",
      name: "a velocity of zero stops the robot at once",
      run: async (host) => {
        await moveToStart(host);
        await RosConnection.use(host, async (ros) => {
          const velocity = { linear: { x: 1 } };
          const { travelled } = await drive(host, ros, { velocity, amount: 20, travel: distance });
          publish(ros, {});
          await pause(STOP_MS);
          must(travelled >= 20, "a robot that has moved", `${travelled} cm`);
          await mustStand(host);
        });
      },
    },
    {
      promise: "ros-velocity-turn",
      name: "`angular.z` in rad/s is positive to the left",
      needs: ["pose"],
      run: async (host) => {
        const start = await moveToStart(host);
        const { speed } = await RosConnection.use(host, async (ros) => {
          const velocity = { angular: { z: 1 } };
          const motion = await drive(host, ros, { velocity, amount: 1, travel: turnToTheLeft });
          publish(ros, {});
          return motion;
        });
        await pause(LEASE_MS);
        const radians = turnToTheLeft(start, await host.snapshot());
        await host.sendAndWait({ action: "turn", degrees: (radians * 180) / Math.PI });
        const isRight = Math.abs(speed - 1) < TOLERANCE_TURN;
        must(isRight, "about 1 rad to the left in a second of 1 rad/s", speed);
      },
    },
    {
      promise: "ros-reset",
      name: "/reset puts the robot at its start, and answers afterwards",
      needs: ["reset"],
      run: async (host) => {
        await moveToStart(host);
        await RosConnection.use(host, async (ros) => {
          const success = async (): Promise<void> => {
            const values = await ros.call("/reset");
            must(valueAt(values, "success") === true, "success true", values);
          };
          await success();
          const start = await readings(host);
          await host.sendAndWait({ action: "move", distance: 60 });
          // A host accepts at most one reset a second.
          await pause(1_000);
          await success();
          await mustHaveReadings(host, start, "after /reset");
        });
      },
    },
  ],
};

/** The newest message of a topic, on a connection of its own. */
async function latest(host: Host, topic: string): Promise<unknown> {
  return RosConnection.use(host, (ros) => ros.firstOf(topic));
}

async function pose(host: Host): Promise<{ x: number; y: number; yaw: number }> {
  const odometry = await latest(host, "/odom");
  const frames = [valueAt(odometry, "header.frame_id"), valueAt(odometry, "child_frame_id")];
  must(frames.join(" ") === "odom base_link", "the frames odom and base_link", frames);
  const at = (path: string): number => numberAt(odometry, `pose.pose.${path}`);
  const yaw = 2 * Math.atan2(at("orientation.z"), at("orientation.w"));
  return { x: at("position.x"), y: at("position.y"), yaw };
}

/** The angle between two snapshots, in radians, positive to the left. */
function turnToTheLeft(from: Snapshot, to: Snapshot): number {
  return angle(((from.pose.heading - to.pose.heading) * Math.PI) / 180);
}

/** An angle from -pi to pi. */
function angle(radians: number): number {
  return Math.atan2(Math.sin(radians), Math.cos(radians));
}

function isAbout(found: number, expected: number): boolean {
  return Math.abs(found - expected) < TOLERANCE_RADIANS;
}
