/** A run loop in tests, with its own clock and a script. */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { DeliveredCommand, RemoteCommand, Snapshot } from "@corridor/protocol";
import { RemoteDriver, type Ending } from "../../drivers/remote-driver.ts";
import { firstMaze, firstProgram } from "../../protocol/first-project.ts";
import { RunLoop } from "../run-loop.ts";
import type { Frame } from "../../../stage/drawing/frame.ts";

/** A loop whose real time passes when the test requests it. */
export class Bench {
  time = 0;
  story: string[] = [];
  /** of commands, by seq */
  readonly endings = new Map<number, Ending>();
  readonly loop: RunLoop;
  #seq = 0;

  constructor(maze: MazeDocument = firstMaze, program: ProgramDocument = firstProgram) {
    const started = (seq: number) => void this.story.push(`started ${seq}`);
    const ended = (seq: number, ending: Ending) => {
      this.story.push(`${ending.state} ${seq}`);
      this.endings.set(seq, ending);
    };
    this.loop = new RunLoop(maze, program, () => this.time);
    this.loop.connect((robot) => new RemoteDriver({ started, ended }, robot, () => this.time));
  }

  /** @returns the last frame */
  pass(milliseconds: number, each = 8): Frame | null {
    let frame: Frame | null = null;
    for (const end = this.time + milliseconds; this.time < end;) {
      this.time += each;
      this.loop.advance();
      frame = this.loop.updates.take()?.frame ?? frame;
    }
    return frame;
  }

  frame(): Frame {
    this.loop.pause();
    const update = this.loop.updates.take();
    if (update === null) throw new Error("no update after a pause");
    return update.frame;
  }

  deliver(command: RemoteCommand): void {
    this.loop.accept(deliveryOf(++this.#seq, command));
  }
}

/** A command as the relay delivers it, with plenty of time. */
export function deliveryOf(
  seq: number,
  command: RemoteCommand,
  change: Partial<DeliveredCommand> = {},
): DeliveredCommand {
  return {
    seq,
    command,
    key: null,
    acceptedAt: "2026-01-01T00:00:00.000Z",
    driver: "Zx81qP",
    ttl: 60_000,
    remaining: 60_000,
    replace: false,
    lease: null,
    ...change,
  };
}

/** The state of a tick in a snapshot. */
export type TickState = Omit<Snapshot, "seq" | "state">;

export function momentOf(snapshot: Snapshot): TickState {
  const { seq: _seq, state: _state, ...moment } = snapshot;
  return moment;
}

/** A run of the right-wall program, paused after ten seconds. */
export function tenSeconds(): Bench {
  const bench = new Bench();
  bench.loop.run();
  bench.pass(10_000);
  bench.loop.pause();
  return bench;
}
