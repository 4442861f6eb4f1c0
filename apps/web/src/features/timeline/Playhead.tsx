/**
 * The displayed tick in the run, and who drives at it: the badge of a line, the flag at the goal,
 * or in red the line that caused a bump. The playhead moves between two renders of the timeline.
 */
import { causeLine } from "@corridor/coach";
import type { LineRef } from "@corridor/protocol";
import { CornerDownRight, Flag, RadioTower, User } from "lucide";
import { useLayoutEffect, useRef } from "react";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Badge } from "../../ui/Badge.tsx";
import { classNames } from "../../ui/class-names.ts";
import { followText } from "../../ui/follow-text.ts";
import { decidingLine, shownDiagnosis } from "../../model/run/line-state.ts";
import { BurstIcon } from "../../ui/BurstIcon.tsx";
import { xOf, type TimeScale } from "./time-scale.ts";
import styles from "./run-timeline.module.css";

interface PlayheadProps {
  scale: TimeScale;
  /** the event at the displayed tick */
  event: "goal" | "bump" | null;
}

export function Playhead({ scale, event }: PlayheadProps) {
  const { run } = useServices();
  const head = useRef<HTMLDivElement>(null);
  const isNow = useStore(run, ({ view }) => view === "now");
  const isBumping = useStore(run, ({ snapshot }) => snapshot?.bumping === true);
  useLayoutEffect(() => {
    let drawn = -1;
    const move = () => {
      const place = Math.round(xOf(scale, run.getState().snapshot?.tick ?? 0));
      // Outside of the displayed part the playhead is placed out of view.
      const isOutside = scale.isPart && (place < 0 || place > scale.width);
      const x = isOutside ? -1000 : Math.min(scale.width, place);
      if (x === drawn || head.current === null) return;
      drawn = x;
      head.current.style.transform = `translateX(${x}px)`;
    };
    move();
    return run.subscribe(move);
  }, [run, scale]);
  const tone = event === "goal" ? "good" : isBumping || event === "bump" ? "bad" : null;
  return (
    <div
      ref={head}
      // The slider announces the tick and the driver.
      aria-hidden="true"
      data-playhead=""
      className={classNames(styles["playhead"], styles[tone ?? (isNow ? "live" : "rest")])}
    >
      {tone === "good" ? (
        <span className={styles["flag"]}>
          <Icon of={Flag} size={14} />
        </span>
      ) : (
        <Badge tone={tone ?? (isNow ? "live" : "rest")}>
          <DriverMark />
        </Badge>
      )}
      <span className={styles["needle"]} />
    </div>
  );
}

/** The number of the current line, else an icon of the driver. The bent arrow means "otherwise". */
function DriverMark() {
  const { run } = useServices();
  const diagnosis = useStore(run, shownDiagnosis);
  const driver = useStore(run, ({ snapshot }) => snapshot?.driver ?? "program");
  if (driver === "me") return <Icon of={User} size={14} />;
  if (driver === "remote") return <Icon of={RadioTower} size={14} />;
  if (diagnosis === null) return <LineMark />;
  const line = causeLine(diagnosis);
  if (line === null) return <BurstIcon size={14} />;
  return line === "default" ? <Icon of={CornerDownRight} size={14} /> : line + 1;
}

/** The number of a line; empty for "otherwise", which has an arrow, and a dash for no line. */
function markOf(line: LineRef | null): string {
  if (line === null) return "–";
  return line === "default" ? "" : String(line + 1);
}

/**
 * Number and arrow share a place, and one has the colour of the background: see
 * line-notes.module.css.
 */
function LineMark() {
  const { deferred } = useServices();
  const element = useRef<HTMLSpanElement>(null);
  const number = useRef<HTMLSpanElement>(null);
  useLayoutEffect(() => {
    const node = document.createTextNode("1");
    number.current?.replaceChildren(node);
    return followText(
      deferred,
      ({ snapshot }) => markOf(decidingLine(snapshot)),
      (text) => {
        element.current?.toggleAttribute("data-otherwise", text === "");
        if (text !== "") node.data = text;
      },
    );
  }, [deferred]);
  return (
    <span ref={element} className={styles["lineMark"]}>
      <span ref={number} />
      <Icon of={CornerDownRight} size={14} />
    </span>
  );
}
