/** Commands, each with the tick before which the robot receives it. A replay is bit-identical. */
import { z } from "zod";
import { commandSchema, type Command } from "./command.ts";
import { MAX_RUN_INPUTS, MAX_RUN_TICKS } from "./run-bounds.ts";

const tickError = "a tick: a whole number from 0, none smaller than the one before";

/** Sorted by tick. Of several commands with the same tick, the last one takes effect. */
export const timedCommandsSchema = z
  .array(
    z.strictObject({
      tick: z
        .int({ error: tickError })
        .min(0, { error: tickError })
        .max(MAX_RUN_TICKS, { error: tickError }),
      command: commandSchema,
    }),
    { error: 'a list of {"tick": ..., "command": {"action": ...}}' },
  )
  .max(MAX_RUN_INPUTS, { error: `at most ${MAX_RUN_INPUTS} commands` })
  .check((context) => {
    let before = 0;
    for (const [index, { tick }] of context.value.entries()) {
      if (tick < before) {
        context.issues.push({
          code: "custom",
          path: [index, "tick"],
          message: tickError,
          input: context.value,
        });
      }
      before = tick;
    }
  });

export interface TimedCommand {
  tick: number;
  command: Command;
}
