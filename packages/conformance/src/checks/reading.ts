/** Reading: sensors, the maze, the log. */
import { commandRecordSchema, snapshotSchema } from "@corridor/protocol";
import type { CheckGroup } from "../check.ts";
import { must, NeverTestable, validate } from "../mismatch.ts";

/** Robots report at least once a second, also while they stand. */
const REPORT_MS = 5_000;

export const reading: CheckGroup = {
  title: "Sensors, maze and log",
  checks: [
    {
      promise: "snapshot",
      name: "a reading is a complete snapshot",
      run: async (host) => {
        const response = await host.request("/sensors?wait=10");
        must(response.status === 200, "200", `${response.status} ${response.text}`);
        const { state, driver } = validate(snapshotSchema, response.json, "a snapshot");
        must(state === "running", 'the state "running"', state);
        must(driver === "remote", 'the driver "remote"', driver);
      },
    },
    {
      promise: "snapshot-command",
      name: "a snapshot identifies the running command and its action, and neither while the robot stands",
      run: async (host) => {
        const { seq } = await host.send({
          action: "drive",
          left: 0,
          right: 0,
          milliseconds: 3_000,
        });
        let snapshot = await host.snapshot();
        const deadline = performance.now() + REPORT_MS;
        while (snapshot.command !== seq && performance.now() < deadline) {
          snapshot = await host.snapshot(`?after=${snapshot.seq}&wait=2`);
        }
        must(snapshot.command === seq, `command ${seq}`, snapshot.command);
        must(snapshot.motion === "drive", "the motion drive", snapshot.motion);
        await host.sendAndWait({ action: "stop" });
        const { command, motion } = await host.snapshot();
        must(command === null && motion === "stop", "command null, motion stop", [command, motion]);
      },
    },
    {
      promise: "reading-wait",
      name: "without a newer snapshot, a reading responds after `wait`",
      run: async (host) => {
        const startedAt = performance.now();
        await host.snapshot("?after=900000000000000&wait=0.3");
        const waited = performance.now() - startedAt;
        must(waited < 5_000, "a response after 0.3 s", `${Math.round(waited)} ms`);
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
      name: "the maze has an ETag, and If-None-Match returns 304",
      needs: ["maze"],
      run: async (host) => {
        const response = await host.request("/maze");
        must(response.status === 200, "200 for the maze", `${response.status} ${response.text}`);
        const format = (response.json as { format?: unknown } | null)?.format;
        must(format === "corridor/maze", 'the format "corridor/maze"', format);
        const tag = response.header("etag");
        must(tag !== "", "an ETag", "none");
        const again = await host.request("/maze", { headers: { "If-None-Match": tag } });
        must(again.status === 304, "304 for If-None-Match with this ETag", again.status);
      },
    },
    {
      promise: "log",
      name: "the log returns complete records in order, after a given number",
      run: async (host) => {
        const { seq } = await host.sendAndWait({ action: "left 90" });
        await host.sendAndWait({ action: "right 90" });
        const records = recordsIn(await host.log(seq - 1));
        const numbers = records.map((record) => record.seq);
        must(numbers.join() === [seq, seq + 1].join(), `${seq},${seq + 1}`, numbers);
        const last = records.at(-1);
        must(last?.state === "completed", "the current record", last);
        const none = recordsIn(await host.log(seq + 1));
        must(none.length === 0, "nothing after the last one", none.length);
      },
    },
  ],
};

function recordsIn(log: unknown) {
  const list = typeof log === "object" && log !== null && "commands" in log ? log.commands : null;
  must(Array.isArray(list) && list.length <= 200, '{"commands": [...]}, at most 200', log);
  return list.map((record) => validate(commandRecordSchema, record, "a command record"));
}
