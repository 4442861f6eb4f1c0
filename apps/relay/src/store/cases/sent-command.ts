/** A command as a relay stores it. */
import type { NewCommand } from "../../commands/robot-step.ts";

export function sentCommand(change: Partial<NewCommand> = {}): NewCommand {
  const acceptedAt = 5_000;
  return {
    driver: "d",
    script: null,
    key: null,
    command: { action: "left 90" },
    acceptedAt,
    ttl: 10_000,
    deadline: acceptedAt + 10_000,
    replace: false,
    lease: null,
    resetFrom: 0,
    maxWaiting: 64,
    keep: 100,
    ...change,
  };
}
