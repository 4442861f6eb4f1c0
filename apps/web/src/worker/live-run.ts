/**
 * The newest moment: the recording of the run, and the newest documents. The run has these too, except
 * while the past is shown: an edit reaches it when it is at now again or goes on.
 */
import type { MazeDocument } from "@corridor/maze";
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import type { DriverName } from "@corridor/protocol";
import { Recording, type Run } from "@corridor/recording";
import type { NewestProgram } from "./shown-line.ts";

export class LiveRun {
  #maze: MazeDocument;
  #program: NewestProgram;
  #recording: Recording;
  /** changes of the inputs of all runs before this one */
  #revisions = 0;

  constructor(maze: MazeDocument, program: ProgramDocument) {
    this.#maze = maze;
    this.#program = newest(program);
    this.#recording = new Recording(maze, program);
  }

  get recording(): Recording {
    return this.#recording;
  }

  get run(): Run {
    return this.#recording.run;
  }

  get driver(): DriverName {
    return this.run.driver;
  }

  /** The newest one, whether or not the run has it. */
  get maze(): MazeDocument {
    return this.#maze;
  }

  /** The newest one, whether or not the run has it. */
  get program(): NewestProgram {
    return this.#program;
  }

  /** Rises with each change of the inputs, over all runs. */
  get revision(): number {
    return this.#revisions + this.#recording.revision;
  }

  isOf(maze: MazeDocument, program: ProgramDocument): boolean {
    return isSame(maze, this.#maze) && isSame(program, this.#program.document);
  }

  /** Takes an edit. @returns false for a maze that says the same: the page sends back what a run brought */
  editMaze(maze: MazeDocument): boolean {
    if (isSame(maze, this.#maze)) return false;
    this.#maze = maze;
    return true;
  }

  /** Takes an edit. One that says the same is none; one that is taken back in the past leaves none behind. */
  editProgram(program: ProgramDocument): void {
    if (isSame(program, this.#program.document)) return;
    const inRun = this.run.program;
    this.#program = newest(isSame(program, inRun) ? inRun : program);
  }

  /** @returns false where the newest maze leaves the robot no place */
  bringMaze(): boolean {
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
    // The run has one that is equal, and is compared by identity from here on.
    this.#program = { document: run.program, compiled };
  }

  /** A new run of the newest documents, which the program drives. */
  begin(): void {
    this.#show(new Recording(this.#maze, this.#program.document));
  }

  /** Goes on with a run that was recorded elsewhere, with the documents that it ended with. */
  open(recording: Recording): void {
    this.#show(recording);
    this.#maze = recording.run.maze;
    this.#program = newest(recording.run.program);
  }

  #show(recording: Recording): void {
    this.#revisions = this.revision + 1;
    this.#recording = recording;
  }
}

/** Parsed documents have their fields in one order. */
function isSame<Document extends MazeDocument | ProgramDocument>(one: Document, other: Document) {
  return one === other || JSON.stringify(one) === JSON.stringify(other);
}

function newest(document: ProgramDocument): NewestProgram {
  return { document, compiled: new CompiledProgram(document) };
}
