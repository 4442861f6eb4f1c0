/** A drive by hand or by a script, run again from its commands as a teacher's page does. */
import { attemptOf } from "@corridor/link";
import { mazePresets } from "@corridor/maze";
import { emptyProgram } from "@corridor/program";
import type { Command } from "@corridor/protocol";
import { openRun, readRun, Recording, type RunDocument, type RunInput } from "@corridor/recording";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { recordAttempt } from "./run-unit.ts";

const [preset] = mazePresets;
if (preset === undefined) throw new Error("no preset");
const { maze } = preset;

const power = fc.double({ min: -1, max: 1, noNaN: true });
const command: fc.Arbitrary<Command> = fc.oneof(
  fc.constantFrom<Command>(
    { action: "forward" },
    { action: "reverse" },
    { action: "left 90" },
    { action: "delayed right 90" },
    { action: "stop" },
  ),
  fc.record({
    action: fc.constant("move"),
    distance: fc.double({ min: -300, max: 300, noNaN: true }),
  }),
  fc.record({
    action: fc.constant("turn"),
    degrees: fc.double({ min: -360, max: 360, noNaN: true }),
  }),
  fc.record({ action: fc.constant("drive"), left: power, right: power }),
);
const input: fc.Arbitrary<RunInput> = fc.oneof(
  { weight: 6, arbitrary: command.map((each): RunInput => ({ do: "command", command: each })) },
  { weight: 2, arbitrary: fc.constant<RunInput>({ do: "cancel" }) },
  {
    weight: 1,
    arbitrary: fc.constantFrom<RunInput>(
      { do: "driver", driver: "me" },
      { do: "driver", driver: "remote" },
    ),
  },
);

describe("the commands of a drive", () => {
  it("lead to the same pose as the drive, whether hands or scripts sent them", () => {
    fc.assert(
      fc.property(fc.array(fc.tuple(input, fc.nat({ max: 60 })), { maxLength: 12 }), (inputs) => {
        const recording = new Recording(maze, emptyProgram());
        recording.addInput({ do: "driver", driver: "remote" });
        for (const [each, ticks] of inputs) {
          recording.addInput(each);
          for (let tick = 0; tick < ticks; tick++) recording.step();
        }
        const { tick: ticks, pose } = recording.run;
        const attempt = attemptOf(documentOf(recording.toDocument("Drive")));
        if (attempt === null) throw new Error("the drive is no attempt");
        const again = openRun(documentOf(recordAttempt({ maze, attempt, ticks })));
        expect(again.ok && again.value.run.pose).toEqual(pose);
      }),
      { numRuns: 40 },
    );
  });
});

function documentOf(written: ReturnType<Recording["toDocument"]>): RunDocument {
  const read = readRun(written.ok ? written.text : "");
  if (!read.ok) throw new Error("the run is not readable");
  return read.value;
}
