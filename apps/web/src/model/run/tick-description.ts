/** A tick of the timeline in words: its time, the driver and the event. */
import type {
  CommandLog,
  Timeline,
  TimelineCommand,
  TimelineEvent,
  TimelineDriver,
} from "@corridor/recording";
import type { Snapshot } from "@corridor/protocol";
import type { TFunction } from "i18next";
import { commandText } from "../../text/command-text.ts";
import { joinList } from "../../text/joined.ts";
import { decidingLine } from "./line-state.ts";
import { timeText } from "./time-text.ts";

/** Ticks before and after an event during which it is displayed. */
const BEFORE = 1;
const AFTER = 5;

export interface TickDescription {
  tick: number;
  /** ticks up to it in which the robot waited for a script, which the clock counts separately */
  waited: number;
  /** null before anyone has driven */
  who: TimelineDriver | null;
  /** the command of a script at this tick; null while the script waits or another driver drives */
  command: TimelineCommand | null;
  /** null if there is no event */
  event: TimelineEvent | null;
}

/**
 * Describes the end of a tick.
 * @param displayed the displayed tick, whose driver and line every part of the page names; null for
 *   another tick, whose driver only the timeline knows
 */
export function describeTick(
  timeline: Pick<Timeline, "segmentAt" | "driverOf" | "eventsUpTo" | "eventAt"> & {
    commands: Pick<CommandLog, "countUpTo" | "at" | "waitedUpTo">;
  },
  tick: number,
  displayed: Snapshot | null = null,
): TickDescription {
  const stretch = timeline.segmentAt(tick);
  const newest = timeline.eventsUpTo(tick + BEFORE) - 1;
  const event = newest < 0 ? null : timeline.eventAt(newest);
  return {
    tick,
    waited: timeline.commands.waitedUpTo(tick),
    who:
      stretch < 0
        ? null
        : displayed?.tick === tick
          ? driverOf(displayed)
          : timeline.driverOf(stretch),
    command: commandAt(timeline.commands, tick),
    event: event !== null && tick - event.tick <= AFTER ? event : null,
  };
}

/** The driver of the displayed tick, or its line; null while no line of the program drives. */
function driverOf(displayed: Snapshot): TimelineDriver | null {
  return displayed.driver === "program" ? decidingLine(displayed) : displayed.driver;
}

/** The command that runs at the end of a tick, or that ends there. */
function commandAt(
  log: Pick<CommandLog, "countUpTo" | "at">,
  tick: number,
): TimelineCommand | null {
  const command = log.at(log.countUpTo(tick) - 1);
  return command === undefined || (command.to !== null && command.to < tick) ? null : command;
}

/**
 * "12.4 s, line 2 drives, right 90"; for a script "8.1 s driving, 4.3 s waiting, command 7: move
 * 50, completed"
 */
export function tickText(
  t: TFunction,
  { tick, waited, who, command, event }: TickDescription,
  language = "en",
): string {
  const driven = timeText(t, tick - waited, language);
  const parts =
    waited === 0
      ? [driven]
      : [
          t("shell.run.driving", { time: driven }),
          t("shell.run.waiting", { time: timeText(t, waited, language) }),
        ];
  if (command !== null) parts.push(commandResultText(t, command));
  else if (who === "remote") parts.push(t("timeline.waits"));
  else if (who !== null) parts.push(driverText(t, who));
  if (event !== null) parts.push(eventText(t, event));
  return joinList(t, parts);
}

/** "command 7: move 50, completed" */
function commandResultText(t: TFunction, { seq, command, ending }: TimelineCommand): string {
  return t("timeline.command", {
    number: seq,
    command: commandText(command),
    result: t(`remote.${ending ?? "started"}`),
  });
}

function driverText(t: TFunction, who: TimelineDriver): string {
  return typeof who === "number"
    ? t("timeline.drives.line", { line: who + 1 })
    : t(`timeline.drives.${who}`);
}

/** The name of an event: "right 90", "bump", "goal reached". */
function eventText(t: TFunction, event: TimelineEvent): string {
  switch (event.kind) {
    case "turn":
      return t(`timeline.turn.${event.turn}`);
    case "edit":
      return t(`timeline.edit.${event.what}`);
    case "bump":
    case "goal":
      return t(`timeline.event.${event.kind}`);
  }
}
