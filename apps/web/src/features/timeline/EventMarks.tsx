/** The pictures of what happened, above the ribbon. */
import type { TimelineEvent, TurnName } from "@corridor/recording";
import type { PlainAction } from "@corridor/protocol";
import { Flag, Pencil } from "lucide-react";
import { ActionIcon } from "../program/ProgramIcons.tsx";
import { BurstIcon } from "./BurstIcon.tsx";
import type { EventMark } from "./event-marks.ts";
import styles from "./timeline.module.css";

/** A mark this small shows which way the robot turned, not how it came to. */
const turnIcons: Readonly<Record<TurnName, PlainAction>> = {
  "left 90": "left 90",
  "delayed left 90": "left 90",
  "turn left": "left 90",
  "right 90": "right 90",
  "delayed right 90": "right 90",
  "turn right": "right 90",
  "turn 180": "turn 180",
};

export function EventMarks({ marks }: { marks: readonly EventMark[] }) {
  return marks.map(({ event, x }) => (
    <span
      key={event.tick}
      className={styles["mark"]}
      data-kind={event.kind}
      style={{ transform: `translateX(${x}px)` }}
    >
      <EventIcon event={event} />
    </span>
  ));
}

function EventIcon({ event }: { event: TimelineEvent }) {
  switch (event.kind) {
    case "turn":
      return <ActionIcon action={turnIcons[event.turn]} />;
    case "bump":
      return <BurstIcon size={14} />;
    case "goal":
      return <Flag size={14} aria-hidden="true" />;
    case "edit":
      return <Pencil size={12} aria-hidden="true" />;
  }
}
