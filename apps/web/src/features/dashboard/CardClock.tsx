/** The time of a student, in hours, minutes and seconds. */
import { useCallback, useLayoutEffect, useRef, useSyncExternalStore } from "react";
import { classTimeText } from "./class-time-text.ts";
import { atFullSecond, fullSecond } from "./full-seconds.ts";
import type { CardTime } from "./use-card.ts";
import styles from "./card-clock.module.css";

const SECOND_MS = 1_000;
const MINUTE_MS = 60_000;
const HOUR_MS = 3_600_000;
/** Before that, the minutes have one digit. */
const TWO_DIGITS_MS = 10 * MINUTE_MS;
/** A strip is set to the clock of the device if it is this far from it: the device has slept. */
const DRIFT_MS = 250;

/** Lines of strips: minutes with one digit; minutes with two, and seconds. */
const ten = Array.from({ length: 10 }, (_, n) => String(n));
const sixty = Array.from({ length: 60 }, (_, n) => String(n).padStart(2, "0"));

/**
 * While the time runs, animations move strips of numbers: a new text on each card would cost the
 * page more than all its pictures, for the seconds always, and for the minutes once a minute. All
 * clocks change at full seconds of the device, so that forty clocks need one frame a second.
 */
export function CardClock({ time }: { time: CardTime }) {
  const { minutes, seconds, startedAt } = time;
  return (
    <span className={styles["clock"]} dir="ltr">
      {startedAt === null ? (
        classTimeText(minutes * MINUTE_MS + seconds * SECOND_MS)
      ) : (
        <RunningClock from={fullSecond(startedAt)} />
      )}
    </span>
  );
}

/** @param from when it was 0:00, at a full second, in ms since 1970 */
function RunningClock({ from }: { from: number }) {
  const hours = useTime(from, shownHours);
  return (
    <>
      {hours > 0 && `${hours}:`}
      <Strip lines={hours < 0 ? ten : sixty} lineMs={MINUTE_MS} from={from} />
      {":"}
      <Strip lines={sixty} lineMs={SECOND_MS} from={from} />
    </>
  );
}

/** A part of a running time that seldom changes. */
interface TimePart {
  of: (ms: number) => number;
  /** when a value ends, in ms */
  end: (value: number) => number;
}

const wholeMinutes: TimePart = {
  of: (ms) => Math.floor(ms / MINUTE_MS),
  end: (minutes) => (minutes + 1) * MINUTE_MS,
};

/** -1 while the minutes have one digit. */
const shownHours: TimePart = {
  of: (ms) => (ms < TWO_DIGITS_MS ? -1 : Math.floor(ms / HOUR_MS)),
  end: (hours) => (hours < 0 ? TWO_DIGITS_MS : (hours + 1) * HOUR_MS),
};

/** The whole minutes of a time. While it runs, renders again at the start of each minute. */
export function useMinutes({ minutes, startedAt }: CardTime): number {
  const running = useTime(startedAt === null ? null : fullSecond(startedAt), wholeMinutes);
  return startedAt === null ? minutes : running;
}

/**
 * A part of the time since a full second; 0 without one. Renders again when the part changes,
 * together with all others that change at the same second: a class joins within seconds.
 */
function useTime(from: number | null, part: TimePart): number {
  const value = useCallback(
    () => (from === null ? 0 : part.of(Math.max(0, Date.now() - from))),
    [from, part],
  );
  const follow = useCallback(
    (notify: () => void) => {
      if (from === null) return () => undefined;
      let cancel: () => void;
      const wait = (): void => {
        cancel = atFullSecond(from + part.end(value()), () => {
          notify();
          wait();
        });
      };
      wait();
      return () => cancel();
    },
    [from, part, value],
  );
  return useSyncExternalStore(follow, value);
}

interface StripProps {
  lines: readonly string[];
  /** how long a line is shown */
  lineMs: number;
  /** when the first line is shown first, in ms since 1970 */
  from: number;
}

function Strip({ lines, lineMs, from }: StripProps) {
  const element = useRef<HTMLSpanElement>(null);
  useLayoutEffect(() => {
    const motion = element.current?.animate(
      [{ transform: "none" }, { transform: "translateY(-100%)" }],
      {
        duration: lines.length * lineMs,
        easing: `steps(${lines.length})`,
        fill: "both",
        iterations: Number.POSITIVE_INFINITY,
      },
    );
    if (motion === undefined) return;
    let cancel: () => void;
    const follow = (): void => {
      const now = Date.now();
      const drift = Number(motion.currentTime) - (now - from);
      if (Math.abs(drift) > DRIFT_MS) motion.currentTime = now - from;
      cancel = atFullSecond(now + MINUTE_MS, follow);
    };
    follow();
    return () => {
      cancel();
      motion.cancel();
    };
  }, [lines, lineMs, from]);
  return (
    <span className={styles["window"]}>
      <span ref={element} className={styles["strip"]}>
        {lines.join("\n")}
      </span>
    </span>
  );
}
