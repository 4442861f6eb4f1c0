/** The ribbon of who drove, and the axis below it. */
import type { Who } from "@corridor/recording";
import type { TFunction } from "i18next";
import { memo, useMemo } from "react";
import { useTranslation } from "react-i18next";
import { classNames } from "../../ui/class-names.ts";
import { remember } from "../../ui/remember.ts";
import type { TimelinePicture } from "./picture.ts";
import type { Segment } from "./ribbon.ts";
import styles from "./timeline.module.css";

/** Room around a segment's name, and the widths of letters and of characters as wide as they are high, in px. */
const NAME_MARGIN = 5;
const LETTER = 7;
const WIDE_CHARACTER = 12;

/** Short for "otherwise", as on the playhead. */
const DOTS = "\u2026";

interface RibbonProps {
  picture: TimelinePicture;
  /** whether the newest moment is shown, so that the newest segment is alive */
  isNow: boolean;
}

export const Ribbon = memo(function Ribbon({ picture, isNow }: RibbonProps) {
  const { t } = useTranslation();
  const names = useMemo(() => remember((who: Who) => namesOf(t, who)), [t]);
  return (
    <svg className={styles["picture"]} aria-hidden="true">
      <rect className={styles["track"]} width="100%" height="20" rx="4" />
      {picture.segments.map((segment) => (
        <RibbonSegment
          key={segment.x}
          {...segment}
          isNewest={isNow && segment.isNewest}
          names={names(segment.who)}
        />
      ))}
      <g className={styles["axis"]}>
        {picture.axis.map(({ tick, x, unit, value }, at) => (
          <g key={tick} transform={`translate(${x} 0)`}>
            <path d="M0.5 22v4" />
            <text x={at === 0 ? 0 : 0.5} y={38} textAnchor={anchorOf(at, picture.axis.length)}>
              {at === 0 ? t(`timeline.axis.${unit}`, { number: value }) : value}
            </text>
          </g>
        ))}
      </g>
    </svg>
  );
});

interface RibbonSegmentProps extends Segment {
  /** the longest first */
  names: readonly string[];
}

/** Only the newest one grows while the run goes on. */
const RibbonSegment = memo(function RibbonSegment({
  who,
  x,
  width,
  isNewest,
  names,
}: RibbonSegmentProps) {
  const name = names.find((each) => fits(each, width));
  const kind = typeof who === "number" || who === "default" || who === "remote" ? "line" : who;
  return (
    <g className={classNames(styles["segment"], styles[kind], isNewest && styles["newest"])}>
      <rect x={x} width={width} height="20" rx={Math.min(3, width / 2)} />
      {name !== undefined && (
        <text x={x + width / 2} y={name === DOTS ? 11 : 14}>
          {name}
        </text>
      )}
    </g>
  );
});

/** The first and the last name of the axis stay within its ends. */
function anchorOf(at: number, count: number): "start" | "middle" | "end" {
  if (at === 0) return "start";
  return at === count - 1 ? "end" : "middle";
}

/** What a segment is called, the longest name first; the dots are the playhead's sign, too. */
function namesOf(t: TFunction, who: Who): readonly string[] {
  switch (who) {
    case "me":
      return [t("timeline.me")];
    case "remote":
      return [t("timeline.remote")];
    case "default":
      return [t("timeline.otherwise"), DOTS];
    case "mixed":
      return [];
    default:
      return [String(who + 1)];
  }
}

function fits(name: string, width: number): boolean {
  let needed = NAME_MARGIN;
  for (const character of name) needed += character >= "\u2e80" ? WIDE_CHARACTER : LETTER;
  return needed <= width;
}
