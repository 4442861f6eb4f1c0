/** `stop` bypasses the queue; other methods of cancelling commands. */
import { commandRecordSchema, type CommandRecord } from "@corridor/protocol";
import type { CheckGroup } from "../check.ts";
import { pause, type Host } from "../host.ts";
import { must, validate } from "../mismatch.ts";
import {
  areNear,
  moveToStart,
  START_READINGS,
  mustHaveReadings,
  mustStand,
  readings,
  show,
} from "../pen.ts";

/** ms, much longer than a stop takes and much shorter than the commands that occupy the robot */
const STOP_MS = 5_000;
const BUSY = { action: "drive", left: 0, right: 0, milliseconds: 20_000 } as const;

export const stops: CheckGroup = {
  title: "Stop",
  checks: [
    {
      promise: "stop-overtakes",
      name: "a stop by POST ends the running command and cancels the waiting ones",
      run: async (host) => overtakes(host, async () => host.send({ action: "stop" })),
    },
    {
      promise: "stop-delete",
      name: "a stop by DELETE does the same, and its response is the record",
      run: async (host) =>
        overtakes(host, async () => {
          const response = await host.request("/commands", { method: "DELETE" });
          must(response.status === 202, "202", `${response.status} ${response.text}`);
          return validate(commandRecordSchema, response.json, "a command record");
        }),
    },
    {
      promise: "stop-stands",
      name: "after a stop the robot stands and accepts new commands",
      run: async (host) => {
        await host.send({ ...BUSY, left: 0.1, right: 0.1 });
        await pause(300);
        const stop = await host.sendAndWait({ action: "stop" });
        must(stop.state === "completed", "completed", stop);
        await mustStand(host);
        await host.sendAndWait({ action: "left 90" });
        const turn = await host.sendAndWait({ action: "right 90" });
        must(turn.state === "completed", "completed", turn);
      },
    },
    {
      promise: "cancel-waiting",
      name: "DELETE of a record cancels a waiting command, which never runs",
      run: async (host) => {
        await moveToStart(host);
        await busy(host);
        const waits = await host.send({ action: "left 90" });
        const end = await cancel(host, waits.seq);
        must(end.state === "cancelled", "cancelled", end);
        await host.sendAndWait({ action: "stop" });
        await mustHaveReadings(host, START_READINGS, "at the position before the command");
      },
    },
    {
      promise: "cancel-running",
      name: "DELETE of a record ends the running command, and the robot stands",
      run: async (host) => {
        const { seq } = await host.send({ ...BUSY, left: 0.1, right: 0.1 });
        await pause(300);
        const end = await cancel(host, seq);
        must(end.state === "cancelled", "cancelled", end);
        await mustStand(host);
      },
    },
    {
      promise: "replace",
      name: "a command with replace ends all earlier commands as superseded, and starts at once",
      run: async (host) => {
        const long = await busy(host);
        const waits = await host.send({ action: "left 90" });
        const startedAt = performance.now();
        const turn = await host.send({ action: "right 90", replace: true });
        must((await host.waitForEnd(turn.seq)).state === "completed", "completed", turn);
        const waited = performance.now() - startedAt;
        must(waited < 10_000, "the new command to start at once", `${Math.round(waited)} ms`);
        for (const { seq } of [long, waits]) {
          const { state } = await host.record(seq);
          must(state === "superseded", "superseded", state);
        }
        await host.sendAndWait({ action: "left 90" });
      },
    },
    {
      promise: "first-ending",
      name: "the first final state is permanent: neither a stop nor a DELETE changes it",
      run: async (host) => {
        const turn = await host.sendAndWait({ action: "left 90" });
        await host.sendAndWait({ action: "right 90" });
        await host.sendAndWait({ action: "stop" });
        for (const when of ["after a stop", "after its DELETE"]) {
          const later = await host.record(turn.seq);
          must(later.state === turn.state, `${turn.state} ${when}`, later.state);
          await host.request(`/commands/${turn.seq}`, { method: "DELETE" });
        }
      },
    },
  ],
};

async function busy(host: Host): Promise<CommandRecord> {
  const record = await host.send(BUSY);
  await host.waitForStart(record.seq);
  return record;
}

async function cancel(host: Host, seq: number): Promise<CommandRecord> {
  const response = await host.request(`/commands/${seq}`, { method: "DELETE" });
  must(response.status === 202, "202", `${response.status} ${response.text}`);
  return host.waitForEnd(seq);
}

async function overtakes(host: Host, stop: () => Promise<CommandRecord>): Promise<void> {
  await moveToStart(host);
  const before: CommandRecord[] = [await busy(host)];
  for (let n = 0; n < 3; n++) before.push(await host.send({ action: "left 90" }));
  const startedAt = performance.now();
  const { seq, action } = await stop();
  must(action === "stop", "the action stop", action);
  must(seq > (before.at(-1)?.seq ?? 0), "a number above those before", seq);
  const end = await host.waitForEnd(seq);
  must(end.state === "completed", "the stop to end as completed", end);
  const waited = performance.now() - startedAt;
  must(waited < STOP_MS, `a stop within ${STOP_MS} ms`, `${Math.round(waited)} ms`);
  for (const each of before) {
    const { state } = await host.record(each.seq);
    must(state === "cancelled", `command ${each.seq} to have been cancelled by the stop`, state);
  }
  const now = await readings(host);
  must(areNear(now, START_READINGS), "a robot that has not turned", show(now));
}
