/** The robot from above as an icon. Nothing else has a face. */
import styles from "./robot-face.module.css";

interface RobotFaceProps {
  /** width in px */
  size: number;
  mood?: "driving" | "bumped";
  className?: string | undefined;
}

export function RobotFace({ size, mood = "driving", className }: RobotFaceProps) {
  return (
    <svg
      className={className}
      width={size}
      height={size}
      viewBox="-28 -28 56 56"
      aria-hidden="true"
    >
      <rect className={styles["wheel"]} x="-26" y="-15" width="9" height="30" rx="4.5" />
      <rect className={styles["wheel"]} x="17" y="-15" width="9" height="30" rx="4.5" />
      <path
        className={styles["body"]}
        d="M-20-8C-20-19-12-25 0-25S20-19 20-8V10C20 19 14 24 6 24H-6C-14 24-20 19-20 10z"
      />
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
