/** The icons of run events, above the ribbon. */
import type { TimelineEvent, TurnName } from "@corridor/recording";
import type { PlainAction } from "@corridor/protocol";
import { Flag, Pencil } from "lucide";
import { memo } from "react";
import { ActionIcon } from "../../ui/ProgramIcons.tsx";
import { BurstIcon } from "../../ui/BurstIcon.tsx";
import type { EventMark } from "./event-marks.ts";
import { Icon } from "../../ui/Icon.tsx";
import styles from "./run-timeline.module.css";

/** A small mark shows the direction of a turn, not its kind. */
const turnIcons: Readonly<Record<TurnName, PlainAction>> = {
  "left 90": "left 90",
  "delayed left 90": "left 90",
  "turn left": "left 90",
  "right 90": "right 90",
  "delayed right 90": "right 90",
  "turn right": "right 90",
  "turn 180": "turn 180",
};

export const EventMarks = memo(function EventMarks({ marks }: { marks: readonly EventMark[] }) {
  return marks.map(({ event, x, more }) => (
    <Mark
      key={event.tick}
      kind={event.kind}
      turn={event.kind === "turn" ? event.turn : null}
      x={x}
      isGroup={more > 0}
    />
  ));
});

interface MarkProps {
  kind: TimelineEvent["kind"];
  turn: TurnName | null;
  x: number;
  /** whether the mark also represents events that would overlap it */
  isGroup: boolean;
}

/** Memoized: events keep their position while the run continues, so that only new ones render. */
const Mark = memo(function Mark({ kind, turn, x, isGroup }: MarkProps) {
  return (
    <span
      className={styles["mark"]}
      data-kind={kind}
      data-group={isGroup || undefined}
      style={{ insetInlineStart: x }}
    >
      <EventIcon kind={kind} turn={turn} />
    </span>
  );
});

function EventIcon({ kind, turn }: Pick<MarkProps, "kind" | "turn">) {
  switch (kind) {
    case "turn":
      return turn === null ? null : <ActionIcon action={turnIcons[turn]} />;
    case "bump":
      return <BurstIcon size={14} />;
    case "goal":
      return <Icon of={Flag} size={14} />;
    case "edit":
      return <Icon of={Pencil} size={12} />;
  }
}
