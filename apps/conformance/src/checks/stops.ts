/** A stop overtakes everything; other ways to end what was asked for. */
import { commandRecordSchema, hasEnded, type CommandRecord } from "@corridor/protocol";
import type { CheckGroup } from "../check.ts";
import type { Host } from "../host.ts";
import { must, shaped } from "../mismatch.ts";

/** Far more than a robot needs, far less than what it is kept busy with. */
const STOP_MS = 5_000;

export const stops: CheckGroup = {
  title: "Stop",
  checks: [
    {
      name: "a stop by POST overtakes what runs and what waits",
      run: async (host) => overtakes(host, async () => host.send({ action: "stop" })),
    },
    {
      name: "a stop by DELETE does the same, and answers with its record",
      run: async (host) =>
        overtakes(host, async () => {
          const answer = await host.ask("/commands", { method: "DELETE" });
          must(answer.status === 202, "202", `${answer.status} ${answer.text}`);
          return shaped(commandRecordSchema, answer.json, "a command record");
        }),
    },
    {
      name: "after a stop the robot stands, and takes new commands",
      run: async (host) => {
        await host.send({ action: "drive", left: 0.2, right: -0.2 });
        const stop = await host.done({ action: "stop" });
        must(stop.state === "completed", "completed", stop);
        const first = await host.snapshot();
        const later = await host.snapshot(`?after=${first.seq}&wait=2`);
        const turned = Math.abs(later.pose.heading - first.pose.heading);
        must(turned < 0.5, "a robot that stands", `${turned} degrees further`);
        const turn = await host.done({ action: "left 90" });
        must(turn.state === "completed", "completed", turn);
      },
    },
    {
      name: "one command is taken back by DELETE of its record",
      run: async (host) => {
        const long = await host.send({ action: "drive", left: 0, right: 0, milliseconds: 20_000 });
        const waits = await host.send({ action: "left 90" });
        for (const { seq } of [waits, long]) {
          const answer = await host.ask(`/commands/${seq}`, { method: "DELETE" });
          must(answer.status === 202, "202", `${answer.status} ${answer.text}`);
          const end = await host.ended(seq);
          must(["cancelled", "completed"].includes(end.state), "cancelled", end);
        }
      },
    },
    {
      name: "a command with replace takes the place of what came before it",
      run: async (host) => {
        const long = await host.send({ action: "drive", left: 0, right: 0, milliseconds: 20_000 });
        const began = performance.now();
        const turn = await host.send({ action: "left 90", replace: true });
        must((await host.ended(turn.seq)).state === "completed", "completed", turn);
        const waited = performance.now() - began;
        must(waited < 10_000, "the new one to begin at once", `${Math.round(waited)} ms`);
        const { state } = await host.record(long.seq);
        must(["superseded", "completed"].includes(state), "superseded", state);
      },
    },
  ],
};

async function overtakes(host: Host, stop: () => Promise<CommandRecord>): Promise<void> {
  const before: CommandRecord[] = [];
  before.push(await host.send({ action: "drive", left: 0, right: 0, milliseconds: 20_000 }));
  for (let n = 0; n < 3; n++) before.push(await host.send({ action: "left 90" }));
  const began = performance.now();
  const { seq, action } = await stop();
  must(action === "stop", "the action stop", action);
  must(seq > (before.at(-1)?.seq ?? 0), "a number above those before", seq);
  const end = await host.ended(seq);
  must(end.state === "completed", "the stop to end as completed", end);
  const waited = performance.now() - began;
  must(waited < STOP_MS, `a stop within ${STOP_MS} ms`, `${Math.round(waited)} ms`);
  for (const each of before) {
    const { state } = await host.record(each.seq);
    must(hasEnded(state), `command ${each.seq} to have ended with the stop`, state);
  }
}
