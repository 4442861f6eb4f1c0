/** Messages as the relay sends them, for tests. */
import type { CommandRecord, RemoteCommand } from "@corridor/protocol";

export const ADDRESS = "http://localhost:8080/r/AAAAAAAAAAAAAAAAAAAAAA#drv_BBBBBBBBBBBBBBBBBBBBBB";

export function record(
  seq: number,
  key: string,
  command: RemoteCommand,
  change: Partial<CommandRecord> = {},
): CommandRecord {
  return {
    seq,
    key,
    action: command.action,
    command,
    state: "accepted",
    reason: null,
    acceptedAt: "2026-01-01T00:00:00.000Z",
    pose: null,
    distance: null,
    duplicate: false,
    ...change,
  };
}
