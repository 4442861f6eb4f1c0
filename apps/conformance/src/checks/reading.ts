/** Reading: sensors, the maze, the log. */
import { commandRecordSchema, snapshotSchema } from "@corridor/protocol";
import type { CheckGroup } from "../check.ts";
import { must, NeverTestable, shaped } from "../mismatch.ts";

/** Robots report at least once a second, also while they stand. */
const REPORT_MS = 5_000;

export const reading: CheckGroup = {
  title: "Sensors, maze and log",
  checks: [
    {
      promise: "snapshot",
      name: "a reading is a whole snapshot",
      run: async (host) => {
        const answer = await host.ask("/sensors?wait=10");
        must(answer.status === 200, "200", `${answer.status} ${answer.text}`);
        const { state, driver } = shaped(snapshotSchema, answer.json, "a snapshot");
        must(state === "running", 'the state "running"', state);
        must(driver === "remote", 'the driver "remote"', driver);
      },
    },
    {
      promise: "snapshot-command",
      name: "a snapshot names the command that runs and its action, and neither while it stands",
      run: async (host) => {
        const { seq } = await host.send({
          action: "drive",
          left: 0,
          right: 0,
          milliseconds: 3_000,
        });
        let snapshot = await host.snapshot();
        const giveUp = performance.now() + REPORT_MS;
        while (snapshot.command !== seq && performance.now() < giveUp) {
          snapshot = await host.snapshot(`?after=${snapshot.seq}&wait=2`);
        }
        must(snapshot.command === seq, `command ${seq}`, snapshot.command);
        must(snapshot.motion === "drive", "the motion drive", snapshot.motion);
        await host.done({ action: "stop" });
        const { command, motion } = await host.snapshot();
        must(command === null && motion === "stop", "command null, motion stop", [command, motion]);
      },
    },
    {
      promise: "reading-wait",
      name: "a reading that has nothing newer answers when its time is over",
      run: async (host) => {
        const began = performance.now();
        await host.snapshot("?after=900000000000000&wait=0.3");
        const waited = performance.now() - began;
        must(waited < 5_000, "an answer after 0.3 s", `${Math.round(waited)} ms`);
      },
    },
    {
      promise: "state-change",
      name: "readers are notified within 5 s that the robot is paused or gone",
      run: async () => {
        throw new NeverTestable("a script cannot pause a robot or disconnect its host");
      },
    },
    {
      promise: "maze",
      name: "the maze has a version, and is not sent again to a reader that has it",
      needs: ["maze"],
      run: async (host) => {
        const answer = await host.ask("/maze");
        must(answer.status === 200, "200 for the maze", `${answer.status} ${answer.text}`);
        const format = (answer.json as { format?: unknown } | null)?.format;
        must(format === "corridor/maze", 'the format "corridor/maze"', format);
        const tag = answer.header("etag");
        must(tag !== "", "an ETag", "none");
        const again = await host.ask("/maze", { headers: { "If-None-Match": tag } });
        must(again.status === 304, "304 for a maze that is known", again.status);
      },
    },
    {
      promise: "log",
      name: "the log gives whole records in order, from where it is asked",
      run: async (host) => {
        const { seq } = await host.done({ action: "left 90" });
        await host.done({ action: "right 90" });
        const records = recordsIn(await host.log(seq - 1));
        const numbers = records.map((record) => record.seq);
        must(numbers.join() === [seq, seq + 1].join(), `${seq},${seq + 1}`, numbers);
        const last = records.at(-1);
        must(last?.state === "completed", "a record as it is now", last);
        const none = recordsIn(await host.log(seq + 1));
        must(none.length === 0, "nothing after the last one", none.length);
      },
    },
  ],
};

function recordsIn(log: unknown) {
  const list = typeof log === "object" && log !== null && "commands" in log ? log.commands : null;
  must(Array.isArray(list) && list.length <= 200, '{"commands": [...]}, at most 200', log);
  return list.map((record) => shaped(commandRecordSchema, record, "a command record"));
}
