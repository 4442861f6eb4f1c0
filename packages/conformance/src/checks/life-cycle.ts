/** The states of a command, from its acceptance to its single final state. */
import { commandRecordSchema, hasEnded } from "@corridor/protocol";
import type { CheckGroup } from "../check.ts";
import { withEvents } from "../event-stream.ts";
import { must, validate } from "../mismatch.ts";
import { moveToStart } from "../pen.ts";

/** Lasts longer than a check. */
const BUSY = { action: "drive", left: 0, right: 0, milliseconds: 60_000 } as const;

export const life: CheckGroup = {
  title: "Life cycle of a command",
  checks: [
    {
      promise: "accepted",
      name: "the response to a command is 202 with its record and Location",
      run: async (host) => {
        const options = { method: "POST", body: { action: "left 90" } };
        const response = await host.request("/commands", options);
        must(response.status === 202, "202", `${response.status} ${response.text}`);
        const record = validate(commandRecordSchema, response.json, "a command record");
        must(record.action === "left 90", "the action left 90", record.action);
        must(!record.duplicate, "duplicate: false in the first response", record);
        const location = response.header("location");
        const path = `/commands/${record.seq}`;
        must(
          location.endsWith(path),
          `the header Location to end with ${path}`,
          location || "none",
        );
        await host.waitForEnd(record.seq);
        await host.sendAndWait({ action: "right 90" });
      },
    },
    {
      promise: "numbers",
      name: "`seq` increases by one with each command",
      run: async (host) => {
        const first = await host.send({ action: "right 90" });
        const second = await host.send({ action: "left 90" });
        must(second.seq === first.seq + 1, `seq ${first.seq + 1}`, second.seq);
        await host.waitForEnd(second.seq);
      },
    },
    {
      promise: "actions",
      name: "every action is accepted",
      run: async (host) => {
        await moveToStart(host);
        const wheels = { left: 0, right: 0, milliseconds: 50 };
        const ended = [
          await host.sendAndWait({ action: "turn", degrees: 10 }),
          await host.sendAndWait({ action: "turn", degrees: -10 }),
          await host.sendAndWait({ action: "turn 180" }),
          await host.sendAndWait({ action: "turn 180" }),
          await host.sendAndWait({ action: "move", distance: 0 }),
          await host.sendAndWait({ action: "drive", ...wheels }),
        ];
        for (const { action, state } of ended) {
          must(state === "completed", `${action} to end as completed`, state);
        }
      },
    },
    {
      promise: "record-command",
      name: "a record contains the complete command; pose and distance are null until it has ended",
      run: async (host) => {
        const command = { action: "drive", left: 0, right: 0, milliseconds: 300 } as const;
        const record = await host.send({ ...command, ttl: 5_000 });
        must(areEqual(record.command, command), JSON.stringify(command), record.command);
        must(record.pose === null && record.distance === null, "pose and distance null", record);
        const end = await host.waitForEnd(record.seq);
        must(end.distance !== null, "a distance at its end", end);
      },
    },
    {
      promise: "order",
      name: "commands start in the order of their numbers",
      run: async (host) => {
        await withEvents(host, async (events) => {
          const long = await host.send(BUSY);
          await host.waitForStart(long.seq);
          const seqs: number[] = [];
          for (let n = 0; n < 4; n++) seqs.push((await host.send({ action: "left 90" })).seq);
          await host.request(`/commands/${long.seq}`, { method: "DELETE" });
          for (const seq of seqs) await events.ended(seq, 30_000);
          const starts = events.states
            .filter(({ record }) => record.state === "started" && seqs.includes(record.seq))
            .map(({ record }) => record.seq);
          must(starts.join() === seqs.join(), seqs.join(), starts.join());
        });
      },
    },
    {
      promise: "record-wait",
      name: "with `wait`, a record responds when the command has ended, or after that time",
      run: async (host) => {
        const { seq } = await host.send({
          action: "drive",
          left: 0,
          right: 0,
          milliseconds: 4_000,
        });
        const early = await host.record(seq, 0.3);
        must(!hasEnded(early.state), "a response after 0.3 s, before the ending", early.state);
        const [end] = await Promise.all([host.record(seq, 25), host.send({ action: "stop" })]);
        must(hasEnded(end.state), "the ending within wait=25", end.state);
      },
    },
  ],
};

function areEqual(found: object, wanted: object): boolean {
  const sorted = (value: object) =>
    JSON.stringify(Object.entries(value).toSorted(([a], [b]) => a.localeCompare(b)));
  return sorted(found) === sorted(wanted);
}
