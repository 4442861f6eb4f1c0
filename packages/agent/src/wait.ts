/** Tool `wait`: waits until a condition is true, or for some seconds. It sends no command. */
import { CompiledConditions } from "@corridor/program";
import { sensorNames, type Snapshot, type UntilCondition } from "@corridor/protocol";
import { MAX_WAIT_SECONDS, waitArguments, waitResult } from "./arguments.ts";
import { describeSnapshot } from "./snapshot-words.ts";
import { newestOf, readArguments, textResult, type AgentContext, type Tool } from "./tool.ts";

export const waitTool: Tool = {
  name: "wait",
  description: `Waits until one of the conditions is true, or for the seconds, at most ${MAX_WAIT_SECONDS}; then reads the sensors. It does not move or stop the robot.`,
  input: waitArguments,
  output: waitResult,
  drives: false,
  async run(context, args) {
    const { seconds = MAX_WAIT_SECONDS, until = [] } = readArguments(waitArguments, args);
    const condition = await firstTrue(context, until, seconds * 1000);
    const snapshot = newestOf(context.port);
    const text = `${outcome(condition, until, seconds)}\n${describeSnapshot(snapshot)}`;
    return textResult(text, { condition, snapshot });
  },
};

/**
 * @returns the index of the first true condition, or null after the time
 * @throws RefusedError if the port may no longer read
 */
async function firstTrue(
  { port, clock, endWaits }: AgentContext,
  until: readonly UntilCondition[],
  milliseconds: number,
): Promise<number | null> {
  const conditions = new CompiledConditions(until);
  const readings = new Float64Array(sensorNames.length);
  const trueIn = (snapshot: Snapshot | null): number => {
    if (snapshot === null) return -1;
    for (const [at, name] of sensorNames.entries()) readings[at] = snapshot.sensors[name];
    return conditions.firstTrue(readings, snapshot.goalReached);
  };
  const already = trueIn(port.newest);
  if (already >= 0) return already;
  const cleanups: (() => void)[] = [];
  try {
    return await new Promise<number | null>((resolve, reject) => {
      const over = (): void => resolve(null);
      const snapshot = (each: Snapshot): void => {
        const index = trueIn(each);
        if (index >= 0) resolve(index);
      };
      const ignored = (): void => undefined;
      const others = { state: ignored, gap: ignored, maze: ignored };
      cleanups.push(port.subscribe({ snapshot, end: reject, ...others }));
      cleanups.push(clock.after(milliseconds, over));
      cleanups.push(() => void endWaits.delete(over));
      endWaits.add(over);
    });
  } finally {
    for (const cleanUp of cleanups) cleanUp();
  }
}

function outcome(
  condition: number | null,
  until: readonly UntilCondition[],
  seconds: number,
): string {
  const found = condition === null ? undefined : until[condition];
  if (found !== undefined) return `Condition ${condition} is true: ${describeCondition(found)}.`;
  const waited = `Waited ${seconds} s.`;
  return until.length === 0
    ? waited
    : `${waited} None of the conditions is true. Call wait again to wait longer.`;
}

function describeCondition(condition: UntilCondition): string {
  if ("goal" in condition) return "a goal is reached";
  const { sensor, is, than } = condition;
  return `${sensor} ${is} ${than === "right" ? `right + ${condition.plus}` : than}`;
}
