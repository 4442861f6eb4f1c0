/** An agent that solves a maze by the tools of a robot. */
import type { callTool } from "../../../apps/relay/src/testing/mcp-client.ts";

type Call = (name: string, args?: Record<string, unknown>) => ReturnType<typeof callTool>;

interface Seen {
  goalReached: boolean;
  bumps: number;
  sensors: { front: number; right: number; back: number; left: number };
}

/** Calls a tool. If it is refused because of a limit, waits, and repeats the same call. */
async function seenAfter(call: Call, name: string, args?: Record<string, unknown>): Promise<Seen> {
  for (;;) {
    const { isError, text, structured } = await call(name, args);
    if (!isError) return structured["snapshot"] as Seen;
    const seconds = structured["retryAfter"];
    if (typeof seconds !== "number") throw new Error(text);
    await call("wait", { seconds });
  }
}

/** Follows the right wall with the sensors of `sense` and of each answer of `act` alone. */
export async function solve(call: Call): Promise<Seen> {
  let seen = await seenAfter(call, "sense");
  for (let step = 1; step <= 500 && !seen.goalReached; step++) {
    const { front, right } = seen.sensors;
    const turn = right > 100 ? "right 90" : front > 100 ? null : "left 90";
    const act = async (command: object, part: string): Promise<Seen> =>
      seenAfter(call, "act", { ...command, key: `step-${step}-${part}`.padEnd(8, "_") });
    if (turn !== null) seen = await act({ action: turn }, "turn");
    if (seen.sensors.front > 100) seen = await act({ action: "move", distance: 100 }, "go");
  }
  return seen;
}
