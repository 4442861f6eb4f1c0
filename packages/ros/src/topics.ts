/** The topics that Corridor publishes, and the message of each. */
import type { MessageType } from "./interface-texts.ts";
import { shortName } from "./interfaces.ts";
import { mapMessage } from "./map-message.ts";
import { metres, quaternionOf, type Quaternion, type RosPose, type Stamp } from "./conversions.ts";
import type { RobotView } from "./robot-view.ts";
import type { Snapshot } from "@corridor/protocol";

/** m; above the diagonal of the largest maze */
const MAX_RANGE = 512;
const NO_COVARIANCE: readonly number[] = Array.from({ length: 36 }, () => 0);
const INFRARED = 1;

export interface Topic {
  type: MessageType;
  /** what causes a message; latched: the last message is sent to each new subscriber */
  source: "snapshot" | "maze" | "once" | "problem";
  /** null: there is nothing to publish yet */
  message(view: RobotView): object | null;
}

/** A topic whose message shows the newest snapshot. */
function reported(
  type: MessageType,
  message: (snapshot: Snapshot, view: RobotView) => object,
): Topic {
  return {
    type,
    source: "snapshot",
    message: (view) => (view.snapshot === null ? null : message(view.snapshot, view)),
  };
}

/** yaw of each sensor in the frame of the robot, in degrees */
const sensorYaw = { front: 0, right: -90, back: 180, left: 90 } as const;
type Sensor = keyof typeof sensorYaw;

function rangeTopic(sensor: Sensor): Topic {
  return reported("sensor_msgs/Range", ({ sensors }, { stamp }) => ({
    header: { stamp, frame_id: `range_${sensor}` },
    radiation_type: INFRARED,
    field_of_view: 0,
    min_range: 0,
    max_range: MAX_RANGE,
    range: metres(sensors[sensor]),
    variance: 0,
  }));
}

export const topics = {
  "/odom": reported("nav_msgs/Odometry", ({ pose }, view) => ({
    header: { stamp: view.stamp, frame_id: "odom" },
    child_frame_id: "base_link",
    pose: { pose: poseMessage(view.poseOf(pose)), covariance: NO_COVARIANCE },
    twist: {
      twist: {
        linear: { x: view.velocity.linear, y: 0, z: 0 },
        angular: { x: 0, y: 0, z: view.velocity.angular },
      },
      covariance: NO_COVARIANCE,
    },
  })),
  "/scan": reported("sensor_msgs/LaserScan", ({ sensors }, { stamp }) => ({
    header: { stamp, frame_id: "laser" },
    angle_min: -Math.PI,
    angle_max: Math.PI / 2,
    angle_increment: Math.PI / 2,
    time_increment: 0,
    scan_time: 0,
    range_min: 0,
    range_max: MAX_RANGE,
    ranges: [sensors.back, sensors.right, sensors.front, sensors.left].map(metres),
    intensities: [],
  })),
  "/range/front": rangeTopic("front"),
  "/range/right": rangeTopic("right"),
  "/range/back": rangeTopic("back"),
  "/range/left": rangeTopic("left"),
  "/pose2d": reported("geometry_msgs/Pose2D", ({ pose }, view) => {
    const { x, y, theta } = view.poseOf(pose);
    return { x, y, theta };
  }),
  "/tf": reported("tf2_msgs/TFMessage", ({ pose }, view) => {
    const { x, y, orientation } = view.poseOf(pose);
    return { transforms: [transform(view.stamp, ["odom", "base_link"], orientation, { x, y })] };
  }),
  "/tf_static": {
    type: "tf2_msgs/TFMessage",
    source: "once",
    message: ({ stamp }) => ({
      transforms: [
        transform(stamp, ["map", "odom"], quaternionOf(0)),
        transform(stamp, ["base_link", "laser"], quaternionOf(0)),
        ...Object.entries(sensorYaw).map(([sensor, yaw]) =>
          transform(stamp, ["base_link", `range_${sensor}`], quaternionOf(yaw)),
        ),
      ],
    }),
  },
  "/bumper": reported("std_msgs/Bool", ({ bumping }) => ({ data: bumping })),
  "/map": {
    type: "nav_msgs/OccupancyGrid",
    source: "maze",
    message: ({ maze, stamp }) => (maze === null ? null : mapMessage(maze, stamp)),
  },
  "/clock": reported("rosgraph_msgs/Clock", (_snapshot, { stamp }) => ({ clock: stamp })),
  "/rosout": { type: "rcl_interfaces/Log", source: "problem", message: () => null },
  "/corridor/snapshot": reported("std_msgs/String", (snapshot) => ({
    data: JSON.stringify(snapshot),
  })),
} as const satisfies Record<string, Topic>;

/** @param name absolute */
export function topicOf(name: string): Topic | null {
  const byName: Record<string, Topic> = topics;
  return Object.hasOwn(byName, name) ? (byName[name] ?? null) : null;
}

/** The only topic that Corridor subscribes to. */
export const VELOCITY_TOPIC = "/cmd_vel";
export const velocityTypes = ["geometry_msgs/Twist", "geometry_msgs/TwistStamped"] as const;

export function isVelocityType(type: string): boolean {
  return velocityTypes.some((each) => each === shortName(type));
}

function poseMessage({ x, y, orientation }: RosPose): object {
  return { position: { x, y, z: 0 }, orientation };
}

function transform(
  stamp: Stamp,
  [parent, child]: readonly [parent: string, child: string],
  rotation: Quaternion,
  { x, y }: { x: number; y: number } = { x: 0, y: 0 },
): object {
  return {
    header: { stamp, frame_id: parent },
    child_frame_id: child,
    transform: { translation: { x, y, z: 0 }, rotation },
  };
}
