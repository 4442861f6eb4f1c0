/** Small icons for the menus: the direction of a sensor, and an action. */
import type { ConditionKind } from "@corridor/program";
import type { PlainAction, SensorName } from "@corridor/protocol";
import styles from "./program-icons.module.css";

/**
 * Rotation of the icon for each sensor, in degrees. The icon shows the robot's body with its beam
 * to a wall, facing ahead.
 */
const turns: Readonly<Record<SensorName, number>> = { front: 0, right: 90, back: 180, left: 270 };

export function SensorIcon({ kind }: { kind: ConditionKind | null }) {
  if (kind === null) {
    return (
      <svg viewBox="0 0 18 18" aria-hidden="true">
        <path className={styles["stroke"]} d="M5 9h8" />
      </svg>
    );
  }
  const sensors: readonly SensorName[] = kind.than === "right" ? ["left", "right"] : [kind.sensor];
  return (
    <svg viewBox="0 0 18 18" aria-hidden="true">
      <rect className={styles["body"]} x="6" y="6" width="6" height="6" rx="1.2" />
      {sensors.map((sensor) => (
        <path
          key={sensor}
          className={styles["beam"]}
          d="M9 5.5V2M6.2 1.5h5.6"
          transform={`rotate(${turns[sensor]} 9 9)`}
        />
      ))}
    </svg>
  );
}

/** One path for each action. A delayed turn has a longer approach before it turns. */
const paths: Readonly<Record<PlainAction, string>> = {
  forward: "M9 15V3.5M4.5 8 9 3.5 13.5 8",
  reverse: "M9 3v11.5M4.5 10 9 14.5 13.5 10",
  stop: "M4.5 4.5h9v9h-9z",
  "left 90": "M13.5 14.5V10a3 3 0 0 0-3-3H3.5M7 3.5 3.5 7 7 10.5",
  "right 90": "M4.5 14.5V10a3 3 0 0 1 3-3h7M11 3.5 14.5 7 11 10.5",
  "turn 180": "M5 15V7.5a4 4 0 0 1 8 0V14M9.8 11 13 14.2 16.2 11",
  "delayed left 90": "M13.5 16.5v-1.5m0-2.5V7.5a2.5 2.5 0 0 0-2.5-2.5H3.5M7 1.5 3.5 5 7 8.5",
  "delayed right 90": "M4.5 16.5v-1.5m0-2.5V7.5a2.5 2.5 0 0 1 2.5-2.5h7.5M11 1.5 14.5 5 11 8.5",
};

export function ActionIcon({ action }: { action: PlainAction }) {
  return (
    <svg viewBox="0 0 18 18" aria-hidden="true">
      <path className={styles["stroke"]} d={paths[action]} />
    </svg>
  );
}
