/** The robot from above as an icon. Nothing else has a face. */
import { ROBOT_BODY, ROBOT_HALF } from "./robot-outline.ts";
import styles from "./robot-face.module.css";

const VIEW_BOX = `${-ROBOT_HALF} ${-ROBOT_HALF} ${2 * ROBOT_HALF} ${2 * ROBOT_HALF}`;

interface RobotFaceProps {
  /** width in px */
  size: number;
  mood?: "driving" | "bumped";
  className?: string | undefined;
}

export function RobotFace({ size, mood = "driving", className }: RobotFaceProps) {
  return (
    <svg className={className} width={size} height={size} viewBox={VIEW_BOX} aria-hidden="true">
      <rect className={styles["wheel"]} x="-26" y="-15" width="9" height="30" rx="4.5" />
      <rect className={styles["wheel"]} x="17" y="-15" width="9" height="30" rx="4.5" />
      <path className={styles["body"]} d={ROBOT_BODY} />
      <rect className={styles["visor"]} x="-15" y="-17" width="30" height="15" rx="7.5" />
      {mood === "driving" ? (
        <>
          <circle className={styles["eye"]} cx="-7.5" cy="-9.5" r="3.5" />
          <circle className={styles["eye"]} cx="7.5" cy="-9.5" r="3.5" />
          <path className={styles["mouth"]} d="M-5 9q5 4.5 10 0" />
        </>
      ) : (
        <>
          <path className={styles["cross"]} d="m-10-12 5 5m0-5-5 5M5-12l5 5m0-5-5 5" />
          <circle className={styles["open"]} cx="0" cy="10" r="3" />
        </>
      )}
    </svg>
  );
}
