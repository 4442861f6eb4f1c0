/** The timeline's track and the axis below it. */
import { TICKS_PER_SECOND } from "@corridor/protocol";
import { useTranslation } from "react-i18next";
import { formatClock } from "../../text/numbers.ts";
import type { AxisMark, TimeScale } from "./time-scale.ts";
import styles from "./timeline.module.css";

/** Half the width of a long label of the axis, in px. */
const END_PX = 20;

interface TimelineAxisProps {
  scale: TimeScale;
  /** the ticks that have a label */
  marks: readonly AxisMark[];
}

export function TimelineAxis({ scale, marks }: TimelineAxisProps) {
  const { t, i18n } = useTranslation();
  return (
    <>
      <rect className={styles["track"]} width="100%" height="20" rx="4" />
      <g className={styles["axis"]}>
        {marks.map(({ tick, x, unit, value }, at) => (
          <g key={tick} transform={`translate(${x} 0)`}>
            <path d="M0.5 22v4" />
            <text x={x === 0 ? 0 : 0.5} y={38} textAnchor={anchorOf(x, scale.width)}>
              {unit === "tick"
                ? clockText(value, scale.step, i18n.language)
                : at === 0
                  ? t(`timeline.axis.${unit}`, { number: value })
                  : value}
            </text>
          </g>
        ))}
      </g>
    </>
  );
}

/** Labels at the ends of the axis do not extend beyond them. */
function anchorOf(x: number, width: number): "start" | "middle" | "end" {
  if (x < END_PX) return "start";
  return x > width - END_PX ? "end" : "middle";
}

/** "2:30", with tenths if the labels need them. */
function clockText(tick: number, step: number, language: string): string {
  const text = formatClock(tick, language);
  return step % TICKS_PER_SECOND === 0 ? text.slice(0, -2) : text;
}
