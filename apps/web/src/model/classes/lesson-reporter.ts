/**
 * Reports the work on the lesson of the class: opened tasks, runs, checks, hints, solutions, and the
 * newest program. Nothing else that is open on the page is reported.
 */
import type { Attempt, LessonTask } from "@corridor/challenge";
import { causeLine, type BumpEvent, type Diagnosis } from "@corridor/coach";
import { CELL } from "@corridor/maze";
import type { Progress } from "@corridor/protocol";
import type { RunDocument } from "@corridor/recording";
import { attemptOf } from "@corridor/link";
import type { SimulatorClient } from "../../simulator/simulator-client.ts";
import type { ClassPlace } from "../../simulator/protocol/class-messages.ts";
import {
  isJudgedByRun,
  mazeCount,
  openTask,
  type ChallengeState,
  type ChallengeStore,
} from "../challenge/challenge-store.ts";
import type { CheckedTask } from "../check/checked-task.ts";
import { mazeIndex } from "../lessons/maze-index.ts";
import { saveRun } from "../run/run-requests.ts";
import type { RunStore } from "../run/run-store.ts";
import type { WorkspaceStore } from "../workspace/workspace-store.ts";
import { completionText, programText } from "./attempt-text.ts";
import type { ClassLessonMark } from "./class-lesson-mark.ts";

import type { ReportedWork } from "./reported-work.ts";
import { RunAttempts, type AttemptFailure, type FinishedRun } from "./run-attempts.ts";
import { StudentDriving } from "./student-driving.ts";

/** Time after an edit until the program is sent, in ms. */
const EDITED_MS = 2_000;

export interface LessonReporterPorts {
  challenge: ChallengeStore;
  workspace: WorkspaceStore;
  run: Pick<RunStore, "getState">;
  simulator: Pick<SimulatorClient, "send" | "listen" | "isGone" | "isResetting">;
  lesson: ClassLessonMark;
  reported: ReportedWork;
  add: (event: Progress) => void;
  setProgram: (task: number, link: string) => void;
  setPlace: (place: ClassPlace | null) => void;
  /** All tasks of the lesson are solved. */
  onAllSolved: () => void;
  /** @returns a function that cancels the call */
  later: (call: () => void, ms: number) => () => void;
}

export class LessonReporter {
  readonly #ports: LessonReporterPorts;
  readonly #attempts: RunAttempts;
  readonly #driving = new StudentDriving();
  readonly #ends: (() => void)[];
  /** index of the open task; null: the lesson of the class is not open */
  #index: number | null = null;
  #place = "";
  #cancelProgram: () => void = () => undefined;

  constructor(ports: LessonReporterPorts) {
    this.#ports = ports;
    const { challenge, workspace, simulator, run, later } = ports;
    const { nowTick, snapshot } = run.getState();
    this.#attempts = new RunAttempts(
      {
        program: () => programText(workspace.getState().program) ?? "",
        maze: () => this.#placeNow()?.maze ?? null,
        onFinished: (finished) => this.#finished(finished),
        later,
      },
      { tick: nowTick, bumps: snapshot?.bumps ?? 0 },
    );
    this.#ends = [
      simulator.listen((message) => {
        this.#attempts.receive(message);
        if (message.type !== "frame") return;
        const { nowDriver, nowTick } = message.frame;
        if (this.#driving.follow(nowDriver, nowTick)) this.#setPlace();
      }),
      challenge.subscribe((next, before) => this.#follow(next, before)),
      workspace.subscribe((next, before) => {
        if (next.maze !== before.maze) this.#setPlace();
        if (next.program === before.program) return;
        this.#attempts.edited();
        this.#driving.edited();
        this.#setPlace();
        this.#programSoon();
      }),
    ];
    this.update();
  }

  /** The class has another lesson, or the page has found out which one. */
  update(): void {
    const state = this.#ports.challenge.getState();
    this.#open(state);
    this.#setPlace();
  }

  /** Whether the lesson is open, and all of its tasks are solved. */
  get isAllSolved(): boolean {
    return this.#index !== null && isAllSolved(this.#ports.challenge.getState());
  }

  /** The student, or the teacher, has opened a hint of the open task. */
  hint(hint: number): void {
    if (this.#index !== null) this.#ports.add({ kind: "hint", task: this.#index + 1, hint });
  }

  /** The page may close. */
  flush(): void {
    this.#attempts.finish();
  }

  close(): void {
    for (const end of this.#ends) end();
    this.#attempts.discard();
    this.#cancelProgram();
  }

  #follow(next: ChallengeState, before: ChallengeState): void {
    if (next.lesson !== before.lesson || next.index !== before.index) this.#open(next);
    const task = openTask(next);
    if (this.#index === null || task === null) return this.#setPlace();
    if (next.failedRun !== before.failedRun || next.result !== before.result) this.#judged(next);
    const { checked, result } = next;
    if (checked !== null && checked !== before.checked) this.#checked(task, next, checked);
    if (result.state === "met" && before.result.state !== "met") this.#solved(result.driver);
    if (isAllSolved(next) && !isAllSolved(before)) this.#ports.onAllSolved();
    this.#setPlace();
  }

  #open(state: ChallengeState): void {
    const { lesson, reported, add, simulator } = this.#ports;
    const index = lesson.openIndex(state);
    if (index !== this.#index) {
      this.#attempts.finish();
      if (simulator.isResetting) this.#attempts.awaitReset();
    }
    this.#index = index;
    if (index === null || lesson.mark === null) return;
    reported.begin(lesson.mark);
    if (reported.open(index + 1)) add({ kind: "opened", lesson: lesson.mark, task: index + 1 });
    this.#programSoon();
  }

  /** The run on the screen failed, or reached the goal. */
  #judged(state: ChallengeState): void {
    const { result, verdict } = state;
    if (result.state === "met" || result.state === "here") return this.#attempts.met();
    // A check has failed, not the run.
    if (verdict !== null) return;
    const failure = failureOfRun(state);
    const tick = state.failedRun?.event.tick ?? (result.state === "failed" ? result.tick : 0);
    const mistakes = state.failedRun?.cause ? 1 : 0;
    if (failure !== null) this.#attempts.failed(failure, mistakes, tick);
  }

  #finished({ program, ...run }: FinishedRun): void {
    if (this.#index === null) return;
    const { reported, add } = this.#ports;
    const task = this.#index + 1;
    // Every drive without a program is another attempt.
    const changed = program === null || reported.try(task, program);
    add({ kind: "run", task, changed, ...run });
    if (program === null) this.#sendDrive(task);
  }

  #checked(task: LessonTask, state: ChallengeState, checked: CheckedTask): void {
    // The page itself checks a program that has reached the goal of the only maze.
    if (this.#index === null || isJudgedByRun(task)) return;
    const { reported, workspace, add } = this.#ports;
    const number = this.#index + 1;
    const changed = reported.try(number, programText(workspace.getState().program) ?? "");
    const passes = passesOf(task, checked);
    const result = { ...placeOfCheck(state, checked), failure: failureOfCheck(state, checked) };
    add({ kind: "check", task: number, changed, passes, mazes: mazeCount(task), ...result });
  }

  #solved(driver: string): void {
    const index = this.#index;
    if (index === null) return;
    const { workspace, challenge } = this.#ports;
    const { program } = workspace.getState();
    if (driver === "program") this.#sendSolution(index, program.rules.length, program);
    // A code holds one drive.
    else if (mazeCount(openTask(challenge.getState())) > 1) this.#sendSolution(index, null, null);
    else this.#withDrive((drive) => this.#sendSolution(index, null, drive));
  }

  #sendSolution(index: number, lines: number | null, attempt: Attempt | null): void {
    const { lesson, reported, add } = this.#ports;
    if (lesson.mark === null) return;
    const code = attempt && completionText(lesson.mark, index, attempt);
    if (!reported.solve(index + 1, code)) return;
    add({ kind: "solved", task: index + 1, lines, code });
  }

  #programSoon(): void {
    this.#cancelProgram();
    if (this.#index === null) return;
    const task = this.#index + 1;
    this.#cancelProgram = this.#ports.later(() => {
      const { workspace, setProgram } = this.#ports;
      if (this.#index !== task - 1) return;
      const text = programText(workspace.getState().program);
      if (text !== null) setProgram(task, text);
    }, EDITED_MS);
  }

  /** The newest drive in place of the program. */
  #sendDrive(task: number): void {
    this.#withDrive((drive) => {
      const { lesson, setProgram } = this.#ports;
      const text = lesson.mark && drive && completionText(lesson.mark, task - 1, drive);
      if (text !== null) setProgram(task, text);
    });
  }

  /** @param use receives null if a program drove in part, or if the run is too long to be saved */
  #withDrive(use: (drive: Attempt | null) => void): void {
    saveRun(this.#ports.simulator, (saved) =>
      use(saved.ok ? attemptOf(JSON.parse(saved.text) as RunDocument) : null),
    );
  }

  #setPlace(): void {
    const place = this.#placeNow();
    const text = JSON.stringify(place);
    if (text === this.#place) return;
    this.#place = text;
    this.#ports.setPlace(place);
  }

  #placeNow(): ClassPlace | null {
    const { challenge, workspace } = this.#ports;
    const state = challenge.getState();
    const task = openTask(state);
    // The dashboard shows the mazes of the newest lesson.
    if (this.#index === null || task === null || this.#ports.lesson.isReplaced) return null;
    const maze = mazeIndex(task, workspace.getState().maze);
    return {
      task: this.#index + 1,
      maze: maze === null ? null : `g${maze + 1}`,
      passes: state.checked && passesOf(task, state.checked),
      isSolved: state.result.state === "met",
      isDriven: this.#driving.isOn || !task.allowed.drivers.includes("program"),
    };
  }
}

function isAllSolved({ lesson, solved, result }: ChallengeState): boolean {
  if (lesson === null) return false;
  return solved.length === 0 ? result.state === "met" : !solved.includes(false);
}

/** Number of given and unseen mazes in which the program passes. */
function passesOf({ unseen }: LessonTask, { mazes, unseenFailures }: CheckedTask): number {
  if (mazes.length === 0) return 0;
  const given = mazes.filter(({ failure }) => failure === null).length;
  return given + (unseen?.count ?? 0) - unseenFailures.length;
}

function failureOfRun({ result, failedRun }: ChallengeState): AttemptFailure {
  if (failedRun === null) {
    return result.state === "failed" ? { code: result.code, line: null } : null;
  }
  const { event } = failedRun;
  const code = result.state === "failed" ? result.code : event.kind;
  return { code, line: causeLine(failedRun) ?? (event.kind === "bump" ? event.line : null) };
}

/** Where the robot bumped in the maze of the failure. */
function placeOfCheck(
  state: ChallengeState,
  checked: CheckedTask,
): Pick<Extract<Progress, { kind: "check" }>, "bumpPlaces"> {
  const { failure, failedUnseen } = checked;
  const event = diagnosisOfCheck(state, checked)?.event;
  if (failure === null || event?.kind !== "bump") return {};
  const maze = failedUnseen === null ? `g${(failure.maze ?? 0) + 1}` : `u${failedUnseen}`;
  return { bumpPlaces: [{ maze, ...cellBeside(event.contact) }] };
}

/** The cell from which a robot touched a block. */
function cellBeside({ x, y, cell }: BumpEvent["contact"]): { column: number; row: number } {
  const [dx, dy] = [x / CELL - cell.column - 0.5, y / CELL - cell.row - 0.5];
  const isBeside = Math.abs(dx) >= Math.abs(dy);
  return {
    column: cell.column + (isBeside ? Math.sign(dx) : 0),
    row: cell.row + (isBeside ? 0 : Math.sign(dy)),
  };
}

function diagnosisOfCheck(
  { diagnoses, unseenDiagnosis }: ChallengeState,
  { failure, failedUnseen }: CheckedTask,
): Diagnosis | null {
  return failedUnseen === null ? (diagnoses[failure?.maze ?? -1] ?? null) : unseenDiagnosis;
}

function failureOfCheck(state: ChallengeState, checked: CheckedTask): AttemptFailure {
  const { passed, failure } = checked;
  if (passed || failure === null) return null;
  const found = diagnosisOfCheck(state, checked);
  return { code: failure.code, line: (found && causeLine(found)) ?? failure.line };
}
