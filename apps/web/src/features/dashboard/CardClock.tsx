/** The time of a student, in minutes and seconds. */
import { useState } from "react";
import { clockText } from "./clock-text.ts";
import type { CardTime } from "./use-card.ts";
import styles from "./card-clock.module.css";

const SECOND_MS = 1_000;
const MINUTE_MS = 60_000;

/**
 * While the time runs, CSS moves a strip of the times of one minute: a text that changes every
 * second on every card would cost the page more than all its pictures. Each minute has a new strip,
 * so that the time follows the clock of the device.
 */
export function CardClock({ minutes, startedAt, seconds }: CardTime) {
  const from = (startedAt ?? 0) + minutes * MINUTE_MS;
  return (
    <span className={styles["clock"]} dir="ltr">
      {startedAt === null ? (
        clockText(minutes * MINUTE_MS + seconds * SECOND_MS)
      ) : (
        <Strip key={from} minutes={minutes} from={from} />
      )}
    </span>
  );
}

/** The times of one minute. @param from its start, in ms since 1970 */
function Strip({ minutes, from }: { minutes: number; from: number }) {
  const [delay] = useState(() => from - Date.now());
  const times = Array.from({ length: MINUTE_MS / SECOND_MS }, (_, second) =>
    clockText(minutes * MINUTE_MS + second * SECOND_MS),
  );
  return (
    <span className={styles["strip"]} style={{ animationDelay: `${delay}ms` }}>
      {times.join("\n")}
    </span>
  );
}
