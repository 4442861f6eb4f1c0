/**
 * The newest state: the recording of the run, and the newest documents. While the past is
 * displayed, the run may still have older documents: edits are applied to it when it continues.
 */
import { isSameMaze, type MazeDocument } from "@corridor/maze";
import { isSameProgram, CompiledProgram, type ProgramDocument } from "@corridor/program";
import type { DriverName } from "@corridor/protocol";
import { Recording, type Run } from "@corridor/recording";
import type { NewestProgram } from "./displayed-line.ts";

export class LiveRun {
  #maze: MazeDocument;
  #program: NewestProgram;
  #recording: Recording;
  /** whether simulated time passes in it */
  isRunning = false;
  /** changes of the inputs of all previous runs */
  #revisions = 0;
  readonly #now: () => number;
  #startedAt: number;

  /** @param now monotonic milliseconds since 1970 */
  constructor(maze: MazeDocument, program: ProgramDocument, now: () => number) {
    this.#now = now;
    this.#startedAt = now();
    this.#maze = maze;
    this.#program = newest(program);
    this.#recording = new Recording(maze, program);
  }

  get recording(): Recording {
    return this.#recording;
  }

  /** when this run began or was opened, in ms since 1970 */
  get startedAt(): number {
    return this.#startedAt;
  }

  get run(): Run {
    return this.#recording.run;
  }

  get driver(): DriverName {
    return this.run.driver;
  }

  /** The newest maze, even if the run does not have it yet. */
  get maze(): MazeDocument {
    return this.#maze;
  }

  /** The newest program, even if the run does not have it yet. */
  get program(): NewestProgram {
    return this.#program;
  }

  /** Increases with each change of the inputs, over all runs. */
  get revision(): number {
    return this.#revisions + this.#recording.revision;
  }

  isOf(maze: MazeDocument, program: ProgramDocument): boolean {
    return isSameMaze(maze, this.#maze) && isSameProgram(program, this.#program.document);
  }

  /**
   * Stores an edit.
   * @returns false for an equal maze: the page sends back the documents of an opened run
   */
  editMaze(maze: MazeDocument): boolean {
    if (isSameMaze(maze, this.#maze)) return false;
    this.#maze = maze;
    return true;
  }

  /**
   * Stores an edit. An equal program is none; an edit that is reverted in the past leaves none
   * behind.
   */
  editProgram(program: ProgramDocument): void {
    if (isSameProgram(program, this.#program.document)) return;
    const inRun = this.run.program;
    this.#program = newest(isSameProgram(program, inRun) ? inRun : program);
  }

  /** @returns false if the newest maze has no room for the robot */
  applyMaze(): boolean {
    const { run } = this;
    if (run.maze === this.#maze) return true;
    if (!this.#recording.addInput({ do: "maze", maze: this.#maze })) return false;
    this.#maze = run.maze;
    return true;
  }

  bringProgram(): void {
    const { run } = this;
    const { document, compiled } = this.#program;
    if (run.program === document) return;
    this.#recording.addInput({ do: "program", program: document });
    // The run's program is equal; its object replaces the newest, which is compared by identity.
    this.#program = { document: run.program, compiled };
  }

  /** Starts a run of the newest documents, driven by the program. */
  begin(): void {
    this.#show(new Recording(this.#maze, this.#program.document));
  }

  /** Continues a run that was recorded elsewhere, with its last documents. */
  open(recording: Recording): void {
    this.#show(recording);
    this.#maze = recording.run.maze;
    this.#program = newest(recording.run.program);
  }

  #show(recording: Recording): void {
    this.#revisions = this.revision + 1;
    this.#startedAt = this.#now();
    this.#recording = recording;
  }
}

function newest(document: ProgramDocument): NewestProgram {
  return { document, compiled: new CompiledProgram(document) };
}
