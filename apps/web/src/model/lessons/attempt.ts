/**
 * The attempt at the open task: the judgement of the run on the screen, the check of the program in
 * all mazes, and the result of both.
 */
import { startingProgram, type Judgement, type LessonTask } from "@corridor/challenge";
import type { Diagnosis } from "@corridor/coach";
import { isSameBehaviour, type ProgramDocument } from "@corridor/program";
import type { FromWorker } from "../../simulator/protocol/worker-messages.ts";
import { isJudgedByRun, mazeCount, openTask } from "../challenge/challenge-store.ts";
import type { CheckAnswer, CheckedTask } from "../check/checked-task.ts";
import { showMessage } from "../screen/screen-store.ts";
import { showUndoable } from "../workspace/show-undoable.ts";
import { newLineIds, setProgram } from "../workspace/workspace-store.ts";
import type { LessonsPorts } from "./lessons-ports.ts";
import type { LessonsProgress } from "./lessons-progress.ts";
import type { Done } from "./lessons-storage.ts";
import { bonusMissionOf } from "./missions/bonus-missions.ts";
import type { CheckEnd, ProgramCheck } from "./program-check.ts";
import { reportUnlessStored } from "./report-unless-stored.ts";
import type { StoredLessons } from "./stored-lessons.ts";

type Met = Extract<Judgement, { kind: "met" }>;

/** State without a known failure of the current program. */
const nothingKnown = {
  checked: null,
  verdict: null,
  diagnoses: [],
  unseenDiagnosis: null,
  failedRun: null,
} as const;

export class Attempt {
  readonly #ports: LessonsPorts;
  readonly #progress: Pick<LessonsProgress, "add">;
  readonly #lessons: Pick<StoredLessons, "addSolved">;
  readonly #check: ProgramCheck;
  /** rises with each task and maze to judge; judgements with another id are ignored */
  #judgeId = 0;
  #judged: Judgement = { kind: "open" };

  constructor(
    ports: LessonsPorts,
    progress: Pick<LessonsProgress, "add">,
    lessons: Pick<StoredLessons, "addSolved">,
    check: ProgramCheck,
  ) {
    this.#ports = ports;
    this.#progress = progress;
    this.#lessons = lessons;
    this.#check = check;
    ports.simulator.listen((message) => this.#follow(message));
    ports.challenge.subscribe((next, before) => {
      if (next.lesson !== null || before.lesson === null) return;
      ports.simulator.send({ type: "judge", id: ++this.#judgeId, attempt: null });
      check.pool.close();
    });
    ports.workspace.subscribe((next, before) => {
      if (next.program === before.program || ports.challenge.getState().lesson === null) return;
      ports.challenge.setState({ ...nothingKnown, result: { state: "open" } });
      this.#clearUnlessSame(openTask(ports.challenge.getState()));
    });
  }

  /** Judges the run on the screen in one given maze of a task from now on. */
  begin(task: LessonTask, maze: number, mission: string | null): void {
    this.#judged = { kind: "open" };
    // The worker for bonus missions decides whether a maze defeats its program. No run on the
    // screen decides it.
    const attempt = bonusMissionOf(mission) === "beat-right-wall" ? null : { task, maze };
    this.#ports.simulator.send({ type: "judge", id: ++this.#judgeId, attempt });
    this.#clearUnlessSame(task);
    const isChecked = task.allowed.drivers.includes("program") && !isJudgedByRun(task);
    if (isChecked && bonusMissionOf(mission) === null) this.#check.prepare(task);
  }

  /** Restores the starting program of the task. The message offers undo. */
  restart(): void {
    const { challenge: store, workspace, simulator, screen, words } = this.#ports;
    const task = openTask(store.getState());
    if (task === null) return;
    const start = startingProgram(task);
    const isMission = store.getState().mission !== null;
    const { program } = workspace.getState();
    simulator.send({ type: "reset" });
    if (isSameBehaviour(program, start)) {
      store.setState({ ...nothingKnown, result: { state: "open" } });
      const text = words.t(
        isMission ? "missions:card.restartedUnchanged" : "missions:lesson.restartedUnchanged",
      );
      showMessage(screen, { tone: "info", text });
      return;
    }
    setProgram(workspace, start, newLineIds(start.rules.length));
    const text = words.t(isMission ? "missions:card.restarted" : "missions:lesson.restarted");
    showUndoable({ screen, workspace }, words, text);
  }

  /**
   * Runs the program in all mazes of the task, also in the unseen ones, in workers.
   * @param run the run on the screen that met the goal. Its figures are displayed beside its
   *   clock; those of the check differ if the program was edited on the way, and are stored
   * @returns once the check has ended
   */
  async check(run: Met | null = null): Promise<void> {
    const { challenge: store, workspace } = this.#ports;
    const task = openTask(store.getState());
    if (task === null) return;
    const { program } = workspace.getState();
    this.#check.stop();
    store.setState({ isChecking: true });
    return new Promise((resolve) => {
      this.#check.start({ task, program }, (end) => {
        store.setState({ isChecking: false });
        this.#conclude(end, run);
        resolve();
      });
    });
  }

  #conclude(end: CheckEnd, run: Met | null): void {
    if (end.ok) {
      this.#decide(end.answer, run);
    } else if (end.reason === "failed") {
      const { screen, words } = this.#ports;
      showMessage(screen, { tone: "bad", text: words.t("lessons.notLoaded") });
    }
  }

  #decide(answer: CheckAnswer, run: Met | null): void {
    const { challenge: store } = this.#ports;
    const { verdict } = answer;
    store.setState({ ...answer, checked: verdict, failedRun: null });
    if (verdict.passed) this.#passed(verdict, run);
    else {
      const isMet = this.#judged.kind === "met" && this.#isOnlyMaze();
      const code = isMet ? "edited" : (verdict.failure?.code ?? "edited");
      const tick = this.#judged.kind === "open" ? 0 : this.#judged.tick;
      store.setState({ result: { state: "failed", code, tick } });
    }
  }

  /** Whether the displayed maze decides alone. */
  #isOnlyMaze(): boolean {
    return mazeCount(openTask(this.#ports.challenge.getState())) === 1;
  }

  /** Ends and deletes a check of another program or task. */
  #clearUnlessSame(task: LessonTask | null): void {
    const { program } = this.#ports.workspace.getState();
    if (task === null || !this.#check.isOf(task, program)) this.#check.clear();
  }

  #follow(message: FromWorker): void {
    if (message.type === "diagnosed") this.#failed(message.diagnosis, message.program);
    if (message.type === "event" && message.event.diagnosis !== null) {
      this.#failed(message.event.diagnosis, message.event.program);
    }
    if (message.type === "truncated") this.#truncated(message.after);
    // An edit of the program restarts the judgement but not the run. At the goal, the store
    // receives again why the run does not count.
    const isGoal = message.type === "event" && message.event.kind === "goal";
    if (isGoal && this.#judged.kind === "failed") this.#receive(this.#judged);
    if (message.type !== "judgement" || message.id !== this.#judgeId) return;
    this.#judged = message.judgement;
    this.#receive(message.judgement);
  }

  /**
   * Stores a failed run on the screen. Its diagnosis replaces the verdict of the last check, whose
   * marks on the mazes stay: the program is the same.
   */
  #failed(diagnosis: Diagnosis, program: ProgramDocument | null): void {
    const { challenge: store, workspace } = this.#ports;
    if (openTask(store.getState())?.allowed.drivers.includes("program") !== true) return;
    // The program was edited in the meantime, so the diagnosis belongs to another program.
    if (program !== null && !isSameBehaviour(program, workspace.getState().program)) return;
    store.setState({ failedRun: diagnosis, verdict: null, diagnoses: [], unseenDiagnosis: null });
  }

  /**
   * The run lost the ticks after this one. What they decided is withdrawn with its reason, before
   * the worker judges the rest: one without the other would be another verdict.
   */
  #truncated(after: number): void {
    const { challenge: store } = this.#ports;
    const { failedRun: said, result: decided } = store.getState();
    const failedRun = said !== null && said.event.tick > after ? null : said;
    const isUndecided = this.#judged.kind !== "open" && this.#judged.tick > after;
    if (isUndecided) this.#judged = { kind: "open" };
    store.setState({ failedRun, result: isUndecided ? { state: "open" } : decided });
  }

  /** Stores a new judgement of the attempt on the screen. */
  #receive(judged: Judgement): void {
    const { challenge: store } = this.#ports;
    if (store.getState().lesson === null) return;
    if (judged.kind === "open") store.setState({ result: { state: "open" } });
    else if (judged.kind === "failed") {
      store.setState({ result: { state: "failed", code: judged.code, tick: judged.tick } });
    } else this.#meet(judged);
  }

  /**
   * A drive by hand or by a script counts as it is, in its maze. So a task of several mazes needs one
   * in each, and unseen mazes need a program. A program must also pass a check from the start in every
   * maze.
   */
  #meet(met: Met): void {
    const { challenge: store, workspace } = this.#ports;
    const { driver, tick: ticks, bumps } = met;
    const { checked, maze } = store.getState();
    const task = openTask(store.getState());
    const lines = driver === "program" ? workspace.getState().program.rules.length : 0;
    if (driver !== "program") {
      const drivenMazes = [...new Set([...store.getState().drivenMazes, maze])];
      const isMet = drivenMazes.length === mazeCount(task);
      const state = isMet ? "met" : "here";
      store.setState({ drivenMazes, result: { state, driver, ticks, bumps, lines } });
      if (isMet) this.#setDone({ lines, ticks });
      return;
    }
    // The same program has already passed in every maze.
    if (checked?.passed === true && !this.#isOnlyMaze()) {
      this.#passed(checked, null);
      return;
    }
    store.setState({ result: { state: "here", driver, ticks, bumps, lines } });
    if (this.#isOnlyMaze()) void this.check(met);
  }

  /** The program works in all mazes. */
  #passed({ mazes }: CheckedTask, run: Met | null): void {
    const { challenge: store, workspace } = this.#ports;
    const ticks = Math.max(...mazes.map((each) => each.ticks));
    const bumps = Math.max(...mazes.map((each) => each.bumps));
    const lines = workspace.getState().program.rules.length;
    const shown = run === null ? { ticks, bumps } : { ticks: run.tick, bumps: run.bumps };
    store.setState({ result: { state: "met", driver: "program", ...shown, lines } });
    this.#setDone({ lines, ticks });
  }

  #setDone(done: Done): void {
    const { challenge: store } = this.#ports;
    const { mission, lessonId, index, solved } = store.getState();
    if (lessonId !== null) {
      store.setState({ solved: solved.with(index, true) });
      reportUnlessStored(this.#ports, this.#lessons.addSolved({ lesson: lessonId, index }));
    }
    if (mission === null || bonusMissionOf(mission) !== null) return;
    this.#progress.add({ done: { [mission]: done } });
  }
}
