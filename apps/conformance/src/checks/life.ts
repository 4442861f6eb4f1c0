/** A command from its acceptance to its one ending. */
import { commandRecordSchema, hasEnded } from "@corridor/protocol";
import type { CheckGroup } from "../check.ts";
import { must, shaped } from "../mismatch.ts";

export const life: CheckGroup = {
  title: "The life of a command",
  checks: [
    {
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
      },
    },
    {
      name: "numbers rise by one",
      run: async (host) => {
        const first = await host.send({ action: "right 90" });
        const second = await host.send({ action: "left 90" });
        must(second.seq === first.seq + 1, `seq ${first.seq + 1}`, second.seq);
        await host.ended(second.seq);
      },
    },
    {
      name: "a turn ends as completed, with where the robot is then",
      run: async (host) => {
        const before = await host.snapshot();
        const turn = await host.done({ action: "right 90" });
        must(turn.state === "completed", "completed", turn);
        must(turn.pose !== null && turn.distance !== null, "a pose and a distance", turn);
        const turned = (turn.pose.heading - before.pose.heading + 360) % 360;
        must(Math.abs(turned - 90) < 2, "a heading 90 degrees further right", turned);
      },
    },
    {
      name: "a move ends as completed or, at a wall, as collided, with its distance",
      run: async (host) => {
        const move = await host.done({ action: "move", distance: 5 });
        must(["completed", "collided"].includes(move.state), "completed or collided", move);
        must(move.distance !== null && move.distance >= 0, "a distance", move.distance);
      },
    },
    {
      name: "every action of the contract is taken",
      run: async (host) => {
        const wheels = { left: 0, right: 0, milliseconds: 50 };
        const ended = [
          await host.done({ action: "turn", degrees: 10 }),
          await host.done({ action: "turn", degrees: -10 }),
          await host.done({ action: "turn 180" }),
          await host.done({ action: "drive", ...wheels }),
        ];
        for (const { action, state } of ended) {
          must(state === "completed", `${action} to end as completed`, state);
        }
        for (const action of [
          "forward",
          "reverse",
          "delayed left 90",
          "delayed right 90",
        ] as const) {
          await host.send({ action });
          await host.done({ action: "stop" });
        }
      },
    },
    {
      name: "commands are done in the order of their numbers",
      run: async (host) => {
        const records = [];
        for (let n = 0; n < 4; n++) records.push(await host.send({ action: "left 90" }));
        const last = records.at(-1)?.seq ?? 0;
        await host.ended(last);
        for (const { seq } of records) {
          const { state } = await host.record(seq);
          must(hasEnded(state), `command ${seq} to have ended before ${last} did`, state);
        }
      },
    },
    {
      name: "an ending is for ever",
      run: async (host) => {
        const turn = await host.done({ action: "left 90" });
        await host.done({ action: "stop" });
        const later = await host.record(turn.seq);
        must(later.state === turn.state, turn.state, later.state);
      },
    },
    {
      name: "a record waits for the ending as long as it is asked to, and no longer",
      run: async (host) => {
        const record = await host.send({ action: "drive", left: 0, right: 0, milliseconds: 6_000 });
        const began = performance.now();
        await host.record(record.seq, 0.3);
        const waited = performance.now() - began;
        must(waited < 4_000, "an answer after at most 0.3 s", `${Math.round(waited)} ms`);
        const end = await host.record(record.seq, 25);
        must(hasEnded(end.state), "an ending within wait=25", end.state);
      },
    },
  ],
};
