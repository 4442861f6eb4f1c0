/** The ribbon of drivers, on its track with the axis below it. */
import type { TimelineDriver } from "@corridor/recording";
import { memo, useMemo } from "react";
import { useTranslation } from "react-i18next";
import { classNames } from "../../ui/class-names.ts";
import { memoize } from "../../ui/memoize.ts";
import type { CommandMark } from "./command-marks.ts";
import type { TimelinePicture } from "./picture.ts";
import type { Segment } from "./ribbon.ts";
import { fits, nameOf } from "./segment-name.ts";
import runStyles from "./run-timeline.module.css";
import styles from "./timeline.module.css";
import { TimelineAxis } from "./TimelineAxis.tsx";

interface RibbonProps {
  picture: TimelinePicture;
  /** whether the newest tick is displayed, so that the newest segment is marked as live */
  isNow: boolean;
}

export const Ribbon = memo(function Ribbon({ picture, isNow }: RibbonProps) {
  const { t } = useTranslation();
  const names = useMemo(() => memoize((who: TimelineDriver) => nameOf(t, who)), [t]);
  return (
    <svg className={styles["picture"]} aria-hidden="true">
      <TimelineAxis scale={picture.scale} marks={picture.axis} />
      {picture.segments.map((segment) => (
        <RibbonSegment
          key={segment.x}
          {...segment}
          isNewest={isNow && segment.isNewest}
          // The numbers of a script's commands replace its name.
          name={segment.who === "remote" && picture.commands.length > 0 ? null : names(segment.who)}
        />
      ))}
      {picture.commands.map((mark) => (
        <CommandSegment key={mark.tick} {...mark} />
      ))}
    </svg>
  );
});

interface RibbonSegmentProps extends Segment {
  name: string | null;
}

/** Memoized: only the newest segment grows while the run continues. */
const RibbonSegment = memo(function RibbonSegment({
  who,
  x,
  width,
  isNewest,
  name,
}: RibbonSegmentProps) {
  const kind = typeof who === "number" || who === "default" ? "line" : who;
  return (
    <g
      className={classNames(runStyles["segment"], runStyles[kind], isNewest && runStyles["newest"])}
    >
      <rect x={x} width={width} height="20" rx={Math.min(3, width / 2)} />
      {name !== null && fits(name, width) && (
        <text x={x + width / 2} y={14}>
          {name}
        </text>
      )}
    </g>
  );
});

/** A command of a script on the ribbon. Its number is at its start. */
const CommandSegment = memo(function CommandSegment({ label, x, width, result }: CommandMark) {
  return (
    <g className={runStyles["command"]} data-command={label} data-result={result}>
      <rect x={x} y="1" width={width} height="18" rx={Math.min(3, width / 2)} />
      <text x={x + 3} y={14}>
        {label}
      </text>
    </g>
  );
});
