/** Records in the event log, as texts without field names, which would be half of the text. */
import type { CommandRecord } from "@corridor/protocol";
import type { Packing } from "../../platform/events/event-log.ts";

type Packed = [
  seq: CommandRecord["seq"],
  key: CommandRecord["key"],
  command: CommandRecord["command"],
  state: CommandRecord["state"],
  reason: CommandRecord["reason"],
  acceptedAt: CommandRecord["acceptedAt"],
  pose: CommandRecord["pose"],
  distance: CommandRecord["distance"],
  duplicate: CommandRecord["duplicate"],
];

function packed(record: CommandRecord): string {
  const { seq, key, command, state, reason, acceptedAt, pose, distance, duplicate } = record;
  const all: Packed = [seq, key, command, state, reason, acceptedAt, pose, distance, duplicate];
  return JSON.stringify(all);
}

function unpacked(text: string): CommandRecord {
  const all = JSON.parse(text) as Packed;
  const [seq, key, command, state, reason, acceptedAt, pose, distance, duplicate] = all;
  const { action } = command;
  return { seq, key, action, command, state, reason, acceptedAt, pose, distance, duplicate };
}

export const recordPacking: Packing<CommandRecord> = { pack: packed, unpack: unpacked };
