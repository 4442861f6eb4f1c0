/** The time of a student, in minutes and seconds. */
import { useCallback, useLayoutEffect, useRef, useSyncExternalStore } from "react";
import { classTimeText } from "./class-time-text.ts";
import type { CardTime } from "./use-card.ts";
import styles from "./card-clock.module.css";

const SECOND_MS = 1_000;
const MINUTE_MS = 60_000;

/** A line for each second of a minute. */
const strip = Array.from({ length: 60 }, (_, n) => String(n).padStart(2, "0")).join("\n");

/** When the last second of a minute begins. */
const LAST_MS = MINUTE_MS - SECOND_MS;
const last = "translateY(calc(-100% * 59 / 60))";
/** The last second stays until the page starts the next minute. */
const keyframes: Keyframe[] = [
  { transform: "none", easing: "steps(59)" },
  { transform: last, offset: 0.5 },
  { transform: last },
];

/**
 * While the time runs, an animation moves a strip of the seconds: a text that changes every second
 * on every card would cost the page more than all its pictures. Each minute starts the animation
 * again, so that it follows the clock of the device. All clocks change at its full seconds, so that
 * forty clocks need one frame a second.
 */
export function CardClock({ minutes, startedAt, seconds }: CardTime) {
  return (
    <span className={styles["clock"]} dir="ltr">
      {startedAt === null ? (
        classTimeText(minutes * MINUTE_MS + seconds * SECOND_MS)
      ) : (
        <>
          {classTimeText(minutes * MINUTE_MS).slice(0, -2)}
          <Seconds from={startedAt + minutes * MINUTE_MS} />
        </>
      )}
    </span>
  );
}

/**
 * The whole minutes of a time. While it runs, renders again at the first full second of each
 * minute, together with all other times whose minute starts then: a class joins within seconds, and
 * a render for each card would make every frame of these seconds longer.
 */
export function useMinutes({ minutes, startedAt }: CardTime): number {
  const follow = useCallback(
    (notify: () => void) => {
      if (startedAt === null) return () => undefined;
      let timer: ReturnType<typeof setTimeout>;
      const wait = (): void => {
        const dueAt = fullSecond(startedAt + (minutesSince(startedAt) + 1) * MINUTE_MS);
        timer = setTimeout(() => {
          notify();
          wait();
        }, dueAt - Date.now());
      };
      wait();
      return () => clearTimeout(timer);
    },
    [startedAt],
  );
  return useSyncExternalStore(follow, () =>
    startedAt === null ? minutes : minutesSince(startedAt),
  );
}

function minutesSince(startedAt: number): number {
  return Math.max(0, Math.floor((Date.now() - startedAt) / MINUTE_MS));
}

/** The next full second of the device's clock, in ms since 1970. */
function fullSecond(at: number): number {
  return Math.ceil(at / SECOND_MS) * SECOND_MS;
}

/** The seconds of one minute. @param from its start, in ms since 1970 */
function Seconds({ from }: { from: number }) {
  const element = useRef<HTMLSpanElement>(null);
  useLayoutEffect(() => {
    const motion = element.current?.animate(keyframes, { duration: 2 * LAST_MS, fill: "both" });
    if (motion === undefined) return;
    motion.currentTime = Date.now() - fullSecond(from);
    return () => motion.cancel();
  }, [from]);
  return (
    <span className={styles["seconds"]}>
      <span ref={element} className={styles["strip"]}>
        {strip}
      </span>
    </span>
  );
}
