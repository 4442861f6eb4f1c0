/** The path of a program, as the command line simulates it. */
import type { MazeDocument } from "@corridor/maze";
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import type { LineRef, Pose } from "@corridor/protocol";
import { ProgramRun, Simulation } from "@corridor/simulation";

interface Decision {
  pose: Pose;
  line: LineRef;
}

/** Longer than any run of the tests, so that a robot at rest stays there. */
const MAX_TICKS = 10_000;

export class ProgramPath {
  /** the pose at each tick, and the line that decides there; null in a manoeuvre */
  readonly #ticks: { pose: string; line: LineRef | null }[] = [];

  constructor(maze: MazeDocument, program: ProgramDocument) {
    const simulation = new Simulation(maze);
    const run = new ProgramRun(simulation, new CompiledProgram(program));
    while (simulation.tick < MAX_TICKS) {
      const isDecision = run.decide() !== null;
      this.#ticks.push({ pose: textOf(simulation.pose), line: isDecision ? run.line : null });
      run.step();
    }
  }

  /**
   * Compares the decisions of a script in their order.
   * @returns the first decision that the program does not make at that pose, bit for bit; or null
   */
  firstDifference(decisions: readonly Decision[]): Decision | null {
    let at = 0;
    for (const decision of decisions) {
      const pose = textOf(decision.pose);
      const found = this.#ticks.findIndex(
        (tick, index) => index >= at && tick.line !== null && tick.pose === pose,
      );
      if (found < 0 || this.#ticks[found]?.line !== decision.line) return decision;
      at = found;
    }
    return null;
  }

  /** Whether the robot ends here, because its program moves it no more. */
  endsAt(pose: Pose): boolean {
    return this.#ticks.at(-1)?.pose === textOf(pose);
  }
}

/** @param label of a script's decision, such as "line 1" */
export function lineOf(label: string): LineRef {
  return label === "otherwise" ? "default" : Number(label.slice("line ".length)) - 1;
}

/** JSON writes numbers so that they are read as the same bits. */
function textOf({ x, y, heading }: Pose): string {
  return JSON.stringify([x, y, heading]);
}
