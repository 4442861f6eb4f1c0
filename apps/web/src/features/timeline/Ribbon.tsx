/** The ribbon of who drove, and the axis below it. */
import type { Who } from "@corridor/recording";
import { memo, useMemo } from "react";
import { useTranslation } from "react-i18next";
import { formatClock } from "../../text/numbers.ts";
import { classNames } from "../../ui/class-names.ts";
import { remember } from "../../ui/remember.ts";
import type { CommandMark } from "./command-marks.ts";
import type { TimelinePicture } from "./picture.ts";
import type { Segment } from "./ribbon.ts";
import { fits, nameOf } from "./segment-name.ts";
import styles from "./timeline.module.css";

/** Half of a long name of the axis, in px. */
const END_PX = 20;
const TICKS_PER_SECOND = 60;

interface RibbonProps {
  picture: TimelinePicture;
  /** whether the newest moment is shown, so that the newest segment is alive */
  isNow: boolean;
}

export const Ribbon = memo(function Ribbon({ picture, isNow }: RibbonProps) {
  const { t, i18n } = useTranslation();
  const names = useMemo(() => remember((who: Who) => nameOf(t, who)), [t]);
  return (
    <svg className={styles["picture"]} aria-hidden="true">
      <rect className={styles["track"]} width="100%" height="20" rx="4" />
      {picture.segments.map((segment) => (
        <RibbonSegment
          key={segment.x}
          {...segment}
          isNewest={isNow && segment.isNewest}
          // The numbers of its commands say more of a script.
          name={segment.who === "remote" && picture.commands.length > 0 ? null : names(segment.who)}
        />
      ))}
      {picture.commands.map((mark) => (
        <CommandSegment key={mark.tick} {...mark} />
      ))}
      <g className={styles["axis"]}>
        {picture.axis.map(({ tick, x, unit, value }, at) => (
          <g key={tick} transform={`translate(${x} 0)`}>
            <path d="M0.5 22v4" />
            <text x={x === 0 ? 0 : 0.5} y={38} textAnchor={anchorOf(x, picture.scale.width)}>
              {unit === "tick"
                ? clockText(value, picture.scale.step, i18n.language)
                : at === 0
                  ? t(`timeline.axis.${unit}`, { number: value })
                  : value}
            </text>
          </g>
        ))}
      </g>
    </svg>
  );
});

interface RibbonSegmentProps extends Segment {
  name: string | null;
}

/** Only the newest one grows while the run goes on. */
const RibbonSegment = memo(function RibbonSegment({
  who,
  x,
  width,
  isNewest,
  name,
}: RibbonSegmentProps) {
  const kind = typeof who === "number" || who === "default" ? "line" : who;
  return (
    <g className={classNames(styles["segment"], styles[kind], isNewest && styles["newest"])}>
      <rect x={x} width={width} height="20" rx={Math.min(3, width / 2)} />
      {name !== null && fits(name, width) && (
        <text x={x + width / 2} y={14}>
          {name}
        </text>
      )}
    </g>
  );
});

/** A command of a script; its number begins where it began. */
const CommandSegment = memo(function CommandSegment({ label, x, width, result }: CommandMark) {
  return (
    <g className={styles["command"]} data-command={label} data-result={result}>
      <rect x={x} y="1" width={width} height="18" rx={Math.min(3, width / 2)} />
      <text x={x + 3} y={14}>
        {label}
      </text>
    </g>
  );
});

/** Names at the ends of the axis stay within them. */
function anchorOf(x: number, width: number): "start" | "middle" | "end" {
  if (x < END_PX) return "start";
  return x > width - END_PX ? "end" : "middle";
}

/** "2:30"; with tenths where the axis names them. */
function clockText(tick: number, step: number, language: string): string {
  const text = formatClock(tick, language);
  return step % TICKS_PER_SECOND === 0 ? text.slice(0, -2) : text;
}
