/** The states of a command, from its acceptance to its single final state. */
import { commandRecordSchema, hasEnded } from "@corridor/protocol";
import type { CheckGroup } from "../check.ts";
import { withEvents } from "../event-stream.ts";
import { must, shaped } from "../mismatch.ts";
import { atHome } from "../setting.ts";

/** Lasts longer than a check. */
const BUSY = { action: "drive", left: 0, right: 0, milliseconds: 60_000 } as const;

export const life: CheckGroup = {
  title: "The life of a command",
  checks: [
    {
      promise: "accepted",
      name: "a command is answered by 202, its record and where that is",
      run: async (host) => {
        const options = { method: "POST", body: { action: "left 90" } };
        const answer = await host.ask("/commands", options);
        must(answer.status === 202, "202", `${answer.status} ${answer.text}`);
        const record = shaped(commandRecordSchema, answer.json, "a command record");
        must(record.action === "left 90", "the action left 90", record.action);
        must(!record.duplicate, "duplicate: false in the first answer", record);
        const location = answer.header("location");
        const path = `/commands/${record.seq}`;
        must(
          location.endsWith(path),
          `the header Location to end with ${path}`,
          location || "none",
        );
        await host.ended(record.seq);
        await host.done({ action: "right 90" });
      },
    },
    {
      promise: "numbers",
      name: "numbers rise by one",
      run: async (host) => {
        const first = await host.send({ action: "right 90" });
        const second = await host.send({ action: "left 90" });
        must(second.seq === first.seq + 1, `seq ${first.seq + 1}`, second.seq);
        await host.ended(second.seq);
      },
    },
    {
      promise: "actions",
      name: "every action is taken",
      run: async (host) => {
        await atHome(host);
        const wheels = { left: 0, right: 0, milliseconds: 50 };
        const ended = [
          await host.done({ action: "turn", degrees: 10 }),
          await host.done({ action: "turn", degrees: -10 }),
          await host.done({ action: "turn 180" }),
          await host.done({ action: "turn 180" }),
          await host.done({ action: "move", distance: 0 }),
          await host.done({ action: "drive", ...wheels }),
        ];
        for (const { action, state } of ended) {
          must(state === "completed", `${action} to end as completed`, state);
        }
      },
    },
    {
      promise: "record-command",
      name: "a record holds the whole command, and says null until it has ended",
      run: async (host) => {
        const command = { action: "drive", left: 0, right: 0, milliseconds: 300 } as const;
        const record = await host.send({ ...command, ttl: 5_000 });
        must(same(record.command, command), JSON.stringify(command), record.command);
        must(record.pose === null && record.distance === null, "pose and distance null", record);
        const end = await host.ended(record.seq);
        must(end.distance !== null, "a distance at its end", end);
      },
    },
    {
      promise: "order",
      name: "commands start in the order of their numbers",
      run: async (host) => {
        await withEvents(host, async (events) => {
          const long = await host.send(BUSY);
          await host.begun(long.seq);
          const seqs: number[] = [];
          for (let n = 0; n < 4; n++) seqs.push((await host.send({ action: "left 90" })).seq);
          await host.ask(`/commands/${long.seq}`, { method: "DELETE" });
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
      name: "a record waits for the ending as long as it is asked to, and no longer",
      run: async (host) => {
        const { seq } = await host.send({
          action: "drive",
          left: 0,
          right: 0,
          milliseconds: 4_000,
        });
        const early = await host.record(seq, 0.3);
        must(!hasEnded(early.state), "an answer after 0.3 s, before the ending", early.state);
        const [end] = await Promise.all([host.record(seq, 25), host.send({ action: "stop" })]);
        must(hasEnded(end.state), "the ending within wait=25", end.state);
      },
    },
  ],
};

function same(found: object, wanted: object): boolean {
  const sorted = (value: object) =>
    JSON.stringify(Object.entries(value).toSorted(([a], [b]) => a.localeCompare(b)));
  return sorted(found) === sorted(wanted);
}
