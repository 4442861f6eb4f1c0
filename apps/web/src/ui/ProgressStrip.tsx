/** A strip that fills as a task proceeds. The text beside it states the numbers. */
import styles from "./progress-strip.module.css";

interface ProgressStripProps {
  label: string;
  value: number;
  max: number;
}

export function ProgressStrip({ label, value, max }: ProgressStripProps) {
  return <progress className={styles["strip"]} max={max} value={value} aria-label={label} />;
}
