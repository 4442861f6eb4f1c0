/** `stop` bypasses the queue; other methods of cancelling commands. */
import { commandRecordSchema, type CommandRecord } from "@corridor/protocol";
import type { CheckGroup } from "../check.ts";
import { pause, type Host } from "../host.ts";
import { must, shaped } from "../mismatch.ts";
import { areNear, atHome, HOME, mustRead, mustStand, readings, show } from "../setting.ts";

/** ms, much longer than a stop takes and much shorter than the commands that occupy the robot */
const STOP_MS = 5_000;
const BUSY = { action: "drive", left: 0, right: 0, milliseconds: 20_000 } as const;

export const stops: CheckGroup = {
  title: "Stop",
  checks: [
    {
      promise: "stop-overtakes",
      name: "a stop by POST overtakes what runs and what waits",
      run: async (host) => overtakes(host, async () => host.send({ action: "stop" })),
    },
    {
      promise: "stop-delete",
      name: "a stop by DELETE does the same, and answers with its record",
      run: async (host) =>
        overtakes(host, async () => {
          const answer = await host.ask("/commands", { method: "DELETE" });
          must(answer.status === 202, "202", `${answer.status} ${answer.text}`);
          return shaped(commandRecordSchema, answer.json, "a command record");
        }),
    },
    {
      promise: "stop-stands",
      name: "after a stop the robot stands, and takes new commands",
      run: async (host) => {
        await host.send({ ...BUSY, left: 0.1, right: 0.1 });
        await pause(300);
        const stop = await host.done({ action: "stop" });
        must(stop.state === "completed", "completed", stop);
        await mustStand(host);
        await host.done({ action: "left 90" });
        const turn = await host.done({ action: "right 90" });
        must(turn.state === "completed", "completed", turn);
      },
    },
    {
      promise: "take-back-waiting",
      name: "DELETE of a record takes back a command that waits: it ends as cancelled, undone",
      run: async (host) => {
        await atHome(host);
        await busy(host);
        const waits = await host.send({ action: "left 90" });
        const end = await takenBack(host, waits.seq);
        must(end.state === "cancelled", "cancelled", end);
        await host.done({ action: "stop" });
        await mustRead(host, HOME, "where it stood before");
      },
    },
    {
      promise: "take-back-running",
      name: "DELETE of a record ends the command that runs, and the robot stands",
      run: async (host) => {
        const { seq } = await host.send({ ...BUSY, left: 0.1, right: 0.1 });
        await pause(300);
        const end = await takenBack(host, seq);
        must(end.state === "cancelled", "cancelled", end);
        await mustStand(host);
      },
    },
    {
      promise: "replace",
      name: "a command with replace ends what came before it as superseded, and starts at once",
      run: async (host) => {
        const long = await busy(host);
        const waits = await host.send({ action: "left 90" });
        const began = performance.now();
        const turn = await host.send({ action: "right 90", replace: true });
        must((await host.ended(turn.seq)).state === "completed", "completed", turn);
        const waited = performance.now() - began;
        must(waited < 10_000, "the new one to start at once", `${Math.round(waited)} ms`);
        for (const { seq } of [long, waits]) {
          const { state } = await host.record(seq);
          must(state === "superseded", "superseded", state);
        }
        await host.done({ action: "left 90" });
      },
    },
    {
      promise: "first-ending",
      name: "the first ending stands: neither a stop nor a DELETE changes it",
      run: async (host) => {
        const turn = await host.done({ action: "left 90" });
        await host.done({ action: "right 90" });
        await host.done({ action: "stop" });
        for (const when of ["after a stop", "after its DELETE"]) {
          const later = await host.record(turn.seq);
          must(later.state === turn.state, `${turn.state} ${when}`, later.state);
          await host.ask(`/commands/${turn.seq}`, { method: "DELETE" });
        }
      },
    },
  ],
};

async function busy(host: Host): Promise<CommandRecord> {
  const record = await host.send(BUSY);
  await host.begun(record.seq);
  return record;
}

async function takenBack(host: Host, seq: number): Promise<CommandRecord> {
  const answer = await host.ask(`/commands/${seq}`, { method: "DELETE" });
  must(answer.status === 202, "202", `${answer.status} ${answer.text}`);
  return host.ended(seq);
}

async function overtakes(host: Host, stop: () => Promise<CommandRecord>): Promise<void> {
  await atHome(host);
  const before: CommandRecord[] = [await busy(host)];
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
    must(state === "cancelled", `command ${each.seq} to have been cancelled by the stop`, state);
  }
  const now = await readings(host);
  must(areNear(now, HOME), "a robot that has not turned", show(now));
}
