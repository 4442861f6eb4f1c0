/** Random runs for property tests: mazes, programs and inputs. */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import { plainActions, type Command, type PlainAction } from "@corridor/protocol";
import fc from "fast-check";
import type { Recording } from "../recording.ts";

/** Generates mazes of up to 6 x 6 cells, about a third of them blocks. */
export const anySmallMaze: fc.Arbitrary<MazeDocument> = fc
  .record({
    columns: fc.integer({ min: 1, max: 6 }),
    rows: fc.integer({ min: 1, max: 6 }),
    fill: fc.array(fc.integer({ min: 0, max: 2 }), { minLength: 36, maxLength: 36 }),
    at: fc.nat(),
    heading: fc.constantFrom("north", "east", "south", "west"),
    isGoal: fc.boolean(),
  })
  .map(({ columns, rows, fill, at, heading, isGoal }) => {
    const column = at % columns;
    const row = Math.floor(at / columns) % rows;
    const isOpen = (c: number, r: number) => fill[r * 6 + c] !== 0 || (c === column && r === row);
    const cells = Array.from({ length: rows }, (_, r) =>
      Array.from({ length: columns }, (_unused, c) => isOpen(c, r)),
    );
    const goal = { column: columns - 1, row: rows - 1 };
    return {
      format: "corridor/maze",
      version: 1,
      name: "any",
      blocks: cells.map((line) => line.map((open) => (open ? "." : "#")).join("")),
      start: { column, row, heading },
      goals: isGoal && isOpen(goal.column, goal.row) ? [goal] : [],
    };
  });

/** Generates programs of up to four lines, with distances that occur in small mazes. */
export const anyLivelyProgram: fc.Arbitrary<ProgramDocument> = fc.record({
  format: fc.constant("corridor/program" as const),
  version: fc.constant(1 as const),
  name: fc.constant("any"),
  default: fc.constantFrom<PlainAction>("forward", "forward", "reverse", "left 90", "stop"),
  rules: fc.array(
    fc.record({
      when: fc.record({
        sensor: fc.constantFrom("front", "right", "back", "left"),
        is: fc.constantFrom("<", ">"),
        than: fc.integer({ min: 20, max: 260 }),
      }),
      do: fc.constantFrom<PlainAction>(...plainActions),
    }),
    { maxLength: 4 },
  ),
});

const power = fc.double({ min: -1, max: 1, noNaN: true });

/** Generates commands of a manual driver or of a script. */
export const anyDriveCommand: fc.Arbitrary<Command> = fc.oneof(
  fc.constantFrom<Command>(...plainActions.map((action) => ({ action }))),
  fc.record({
    action: fc.constant("move" as const),
    distance: fc.double({ min: -200, max: 200, noNaN: true }),
  }),
  fc.record({
    action: fc.constant("turn" as const),
    degrees: fc.double({ min: -200, max: 200, noNaN: true }),
  }),
  fc.record({ action: fc.constant("drive" as const), left: power, right: power }),
);

/** An operation on a recording. */
export type Operation =
  | { kind: "ticks"; count: number }
  | { kind: "driver"; driver: "me" | "program" | "remote" }
  | { kind: "command"; command: Command; seq: number | undefined }
  | { kind: "cancel" }
  | { kind: "program"; program: ProgramDocument }
  | { kind: "block"; column: number; row: number };

export const anyOperations: fc.Arbitrary<Operation[]> = fc.array(
  fc.oneof(
    {
      weight: 5,
      arbitrary: fc.record({
        kind: fc.constant("ticks" as const),
        count: fc.integer({ min: 1, max: 400 }),
      }),
    },
    {
      weight: 2,
      arbitrary: fc.record({
        kind: fc.constant("driver" as const),
        driver: fc.constantFrom("me", "program", "remote"),
      }),
    },
    {
      weight: 3,
      arbitrary: fc.record({
        kind: fc.constant("command" as const),
        command: anyDriveCommand,
        seq: fc.option(fc.integer({ min: 1, max: 99 }), { nil: undefined }),
      }),
    },
    { weight: 1, arbitrary: fc.record({ kind: fc.constant("cancel" as const) }) },
    {
      weight: 2,
      arbitrary: fc.record({ kind: fc.constant("program" as const), program: anyLivelyProgram }),
    },
    {
      weight: 2,
      arbitrary: fc.record({
        kind: fc.constant("block" as const),
        column: fc.nat({ max: 5 }),
        row: fc.nat({ max: 5 }),
      }),
    },
  ),
  { minLength: 1, maxLength: 20 },
);

/** Performs an operation, or ignores it if it is not possible. Calls `onTick` after each tick. */
export function perform(recording: Recording, operation: Operation, onTick: () => void): void {
  switch (operation.kind) {
    case "ticks":
      for (let tick = 0; tick < operation.count; tick++) {
        recording.step();
        onTick();
      }
      return;
    case "driver":
      recording.addInput({ do: "driver", driver: operation.driver });
      return;
    case "command":
      recording.addInput({ do: "command", command: operation.command, seq: operation.seq });
      return;
    case "cancel":
      recording.addInput({ do: "cancel" });
      return;
    case "program":
      recording.addInput({ do: "program", program: operation.program });
      return;
    case "block":
      recording.addInput({ do: "maze", maze: toggled(recording.run.maze, operation) });
      return;
  }
}

/** Toggles one block of a maze if the result is valid. */
function toggled(
  maze: MazeDocument,
  { column, row }: { column: number; row: number },
): MazeDocument {
  const isOccupied = [maze.start, ...maze.goals].some(
    (cell) => cell.column === column && cell.row === row,
  );
  const line = maze.blocks[row];
  if (isOccupied || line?.[column] === undefined) return maze;
  const other = line[column] === "#" ? "." : "#";
  const changed = line.slice(0, column) + other + line.slice(column + 1);
  return { ...maze, blocks: maze.blocks.map((each, index) => (index === row ? changed : each)) };
}
