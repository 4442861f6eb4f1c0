/**
 * Actions of the lessons: open a mission, check it, continue to the next, return to the maze from
 * before. Each mission has its own project, so that other projects stay unchanged.
 */
import {
  rightsOf,
  startingProgram,
  type ChallengeDocument,
  type Judgement,
  type Verdict,
} from "@corridor/challenge";
import type { Diagnosis } from "@corridor/coach";
import { CELL, type MazeDocument } from "@corridor/maze";
import { isSameBehaviour, type ProgramDocument } from "@corridor/program";
import { createStore } from "zustand/vanilla";
import { firstProject } from "../projects/first-visit.ts";
import { noChallenge } from "../challenge/challenge-store.ts";
import { dismiss, showMessage } from "../screen/screen-store.ts";
import { newLineIds, setMaze, setProgram } from "../workspace/workspace-store.ts";
import type { CheckAnswer } from "../../simulator/protocol/check-request.ts";
import type { SolvedTrail } from "../../simulator/protocol/bonus-request.ts";
import { showUndoable } from "../workspace/show-undoable.ts";
import { readChallengeText, writeChallengeText } from "./challenge-text.ts";
import { startChecker, type ChallengeChecker } from "./challenge-checker.ts";
import type { LessonsPorts } from "./lessons-ports.ts";
import type { Done, LessonsRecord } from "./lessons-storage.ts";
import { mazeIndex } from "./maze-index.ts";
import { MissionAddress, pageAddressBar, type AddressBar } from "../address/mission-address.ts";
import { missionDocument } from "./mission-document.ts";
import { nextMission, type MissionId } from "./missions/mission.ts";
import { missions } from "./missions/missions.ts";
import { bonusMissionOf, bonusMissions } from "./missions/bonus-missions.ts";
import { BonusChecker } from "./bonus-checker.ts";

/** Everything that an address can name. */
const tasks = [...missions, ...bonusMissions];

type Met = Extract<Judgement, { kind: "met" }>;

/** State without a known failure of the current program. */
const nothingSaid = { checked: null, verdict: null, diagnoses: [], failedRun: null } as const;

export class LessonsService {
  readonly #ports: LessonsPorts;
  readonly #checker: ChallengeChecker;
  /** progress for the path; changes with every mission */
  readonly progress = createStore<Pick<LessonsRecord, "done" | "best">>(() => ({
    done: {},
    best: {},
  }));
  /** the open bonus mission, checked whenever it changes */
  readonly bonus: BonusChecker;
  /** rises with each challenge and maze to judge; judgements with another id are ignored */
  #judgeId = 0;
  /** id of the project with the open challenge */
  #projectId: string | null = null;
  #judged: Judgement = { kind: "open" };
  /** reopens what was open before the first mission, even if it was never stored */
  #backAction: (() => void) | null = null;

  readonly #address: MissionAddress;

  constructor(
    ports: LessonsPorts,
    checker: ChallengeChecker = startChecker(),
    bar: AddressBar = pageAddressBar(),
  ) {
    this.#ports = ports;
    this.#checker = checker;
    this.#address = new MissionAddress(ports.challenge, bar, () => this.goHome());
    this.showProgress();
    this.bonus = new BonusChecker(ports, (isStored) => {
      this.#reportUnlessStored(isStored);
      this.showProgress();
    });
    ports.simulator.listen((message) => {
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
    });
    ports.challenge.subscribe((next, before) => {
      if (next.challenge !== null || before.challenge === null) return;
      ports.simulator.send({ type: "judge", id: ++this.#judgeId, attempt: null });
    });
    ports.workspace.subscribe((next, before) => {
      if (ports.challenge.getState().challenge === null) return;
      if (next.maze !== before.maze) this.#followMaze(next.maze);
      if (next.program !== before.program) {
        ports.challenge.setState({ ...nothingSaid, result: { state: "open" } });
      }
    });
  }

  /** Updates the progress, which another tab may have changed. */
  showProgress(): void {
    const { done, best } = this.#ports.storage.record;
    this.progress.setState({ done, best });
  }

  /**
   * Opens the mission that an address names. A mission that is already open stays as it is, with
   * its run.
   * @returns whether the mission exists
   */
  follow(id: string): boolean {
    const { storage, projects } = this.#ports;
    if (storage.missionOf(projects.currentId()) !== id) return this.openMission(id);
    this.sync();
    return true;
  }

  /**
   * Opens a mission where the student left it, or from its start.
   * @returns whether the mission exists
   */
  openMission(id: string): boolean {
    const mission = tasks.find((each) => each.id === id);
    if (mission === undefined) return false;
    this.#address.opening();
    const { storage, projects } = this.#ports;
    const challenge = missionDocument(mission, this.#ports.words);
    const attempt = projects.list().find((project) => project.id === storage.record.works[id]);
    this.#leaveHome();
    const [maze] = challenge.mazes;
    if (attempt !== undefined) projects.open(attempt);
    else if (maze !== undefined) {
      projects.beginNew(maze, startingProgram(challenge));
      this.#reportUnlessStored(storage.add({ works: { [id]: projects.currentId() } }));
    }
    this.#start(challenge, id);
    return true;
  }

  /** Opens a shared challenge in its own project. */
  openShared(challenge: ChallengeDocument, program: ProgramDocument | null): void {
    const { projects, storage } = this.#ports;
    const [maze] = challenge.mazes;
    if (maze === undefined) return;
    this.#leaveHome();
    projects.beginNew(maze, program ?? startingProgram(challenge));
    const text = writeChallengeText(challenge);
    this.#reportUnlessStored(text !== null && storage.storeChallenge(projects.currentId(), text));
    this.#start(challenge, null);
  }

  /** Loads the challenge of the open project, if it has one. The robot stays where it is. */
  sync(): void {
    const { projects, storage } = this.#ports;
    const id = storage.missionOf(projects.currentId());
    const mission = tasks.find((each) => each.id === id);
    if (mission !== undefined) {
      this.#show(missionDocument(mission, this.#ports.words), mission.id);
      return;
    }
    const text = storage.challengeOf(projects.currentId());
    const challenge = text === null ? null : readChallengeText(text);
    if (challenge !== null) this.#show(challenge, null);
  }

  /** Offers control to the driver of the open challenge, unless a run has already started. */
  handOver(): void {
    const { challenge, simulator } = this.#ports;
    const driver = challenge.getState().challenge?.allowed.drivers[0];
    if (driver !== undefined) simulator.send({ type: "offer-driver", driver });
  }

  /** Shows another maze of the challenge. The program stays. */
  showMaze(index: number): void {
    const { challenge, workspace, simulator } = this.#ports;
    const maze = challenge.getState().challenge?.mazes[index];
    if (maze === undefined) return;
    // The run of the other maze ends first: this maze must not be judged by it.
    simulator.send({ type: "reset" });
    setMaze(workspace, { ...maze, name: workspace.getState().maze.name });
  }

  /** Restores the starting program of the mission. The message offers undo. */
  beginAgain(): void {
    const { challenge: store, workspace, simulator, screen, words } = this.#ports;
    const { challenge } = store.getState();
    if (challenge === null) return;
    const start = startingProgram(challenge);
    const { program } = workspace.getState();
    simulator.send({ type: "reset" });
    if (isSameBehaviour(program, start)) {
      store.setState({ ...nothingSaid, result: { state: "open" } });
      showMessage(screen, { tone: "info", text: words.t("missions:card.restartedUnchanged") });
      return;
    }
    setProgram(workspace, start, newLineIds(start.rules.length));
    showUndoable({ screen, workspace }, words, words.t("missions:card.restarted"));
  }

  /**
   * Runs the program in all mazes of the challenge, in a worker.
   * @param run the run on the screen that met the challenge. Its figures are displayed beside its
   *   clock; those of the check differ if the program was edited on the way, and are stored
   */
  async check(run: Met | null = null): Promise<void> {
    const { challenge: store, screen, words } = this.#ports;
    store.setState({ isChecking: true });
    let answer: CheckAnswer | null;
    try {
      answer = await this.#ask();
    } catch {
      showMessage(screen, { tone: "bad", text: words.t("lessons.notLoaded") });
      return;
    } finally {
      store.setState({ isChecking: false });
    }
    if (answer === null) return;
    const { verdict } = answer;
    store.setState({ ...answer, checked: verdict, failedRun: null });
    if (verdict.passed) this.#passed(verdict, run);
    else {
      const isMet = this.#judged.kind === "met" && verdict.mazes.length === 1;
      const code = isMet ? "edited" : (verdict.failure?.code ?? "edited");
      const tick = this.#judged.kind === "open" ? 0 : this.#judged.tick;
      store.setState({ result: { state: "failed", code, tick } });
    }
  }

  /** The program works in all mazes. */
  #passed({ mazes }: Verdict, run: Met | null): void {
    const { challenge: store, workspace } = this.#ports;
    const ticks = Math.max(...mazes.map((each) => each.ticks));
    const bumps = Math.max(...mazes.map((each) => each.bumps));
    const lines = workspace.getState().program.rules.length;
    const shown = run === null ? { ticks, bumps } : { ticks: run.tick, bumps: run.bumps };
    store.setState({ result: { state: "met", driver: "program", ...shown, lines } });
    this.#setDone({ lines, ticks });
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

  /**
   * Stores a failed run on the screen. Its diagnosis replaces the verdict of the last check, whose
   * marks on the mazes stay: the program is the same.
   */
  #failed(diagnosis: Diagnosis, program: ProgramDocument | null): void {
    const { challenge: store, workspace } = this.#ports;
    const { challenge } = store.getState();
    if (challenge === null || !challenge.allowed.drivers.includes("program")) return;
    // The program was edited in the meantime, so the diagnosis belongs to another program.
    if (program !== null && !isSameBehaviour(program, workspace.getState().program)) return;
    store.setState({ failedRun: diagnosis, verdict: null, diagnoses: [] });
  }

  /** @returns null if the program or the challenge changed in the meantime */
  async #ask(): Promise<CheckAnswer | null> {
    const { challenge: store, workspace } = this.#ports;
    const { challenge } = store.getState();
    const { program } = workspace.getState();
    if (challenge === null) return null;
    const answer = await this.#checker.check({ challenge, program });
    const isSame =
      store.getState().challenge === challenge && workspace.getState().program === program;
    return isSame ? answer : null;
  }

  /** The mission after the open one; null after the last one, and if no mission is open. */
  nextMission(): MissionId | null {
    return nextMission(this.#ports.challenge.getState().mission);
  }

  /**
   * The trail of the last mission whose stored program reaches the goal. If none does, the result
   * has no points.
   * @throws if the worker fails to load
   */
  async solvedTrail(): Promise<SolvedTrail> {
    const { projects, storage, words } = this.#ports;
    const stored = projects.list();
    const attempts = missions.toReversed().flatMap((mission) => {
      const project = stored.find(({ id }) => id === storage.record.works[mission.id]);
      const [maze] = missionDocument(mission, words).mazes;
      const isReach = mission.challenge.goal.kind === "reach";
      return project === undefined || maze === undefined || !isReach
        ? []
        : [{ maze, program: project.program }];
    });
    const trail = await this.bonus.trailOf(attempts);
    if (trail !== null) return trail;
    const [last] = missions.slice(-1).flatMap((mission) => missionDocument(mission, words).mazes);
    if (last === undefined) throw new Error("There is no mission.");
    const { column, row } = last.start;
    const pose = { x: (column + 0.5) * CELL, y: (row + 0.5) * CELL, heading: 90 };
    return { maze: last, pose, points: [] };
  }

  /** Reopens what was open before the first mission. The missions stay on the device. */
  goHome(): void {
    const { projects, storage, words } = this.#ports;
    const home = projects.list().find((project) => project.id === storage.record.home);
    const goBack = this.#backAction;
    this.#backAction = null;
    // `#backAction` also restores edits that were never stored.
    if (goBack !== null) goBack();
    else if (home !== undefined) projects.open(home);
    else {
      const { maze, program } = firstProject(words);
      projects.begin(maze, program);
    }
    this.#ports.simulator.send({ type: "driver", driver: "program" });
  }

  /** Deletes the progress. The message offers undo, and attempts stay on the device. */
  deleteProgress(): void {
    const { storage, screen, words } = this.#ports;
    const { done, best } = storage.record;
    this.#reportUnlessStored(storage.deleteProgress());
    this.showProgress();
    const id = showMessage(screen, {
      tone: "info",
      text: words.t("missions:path.resetDone"),
      action: {
        label: words.t("missions:path.undo"),
        run: () => {
          dismiss(screen, id);
          this.#reportUnlessStored(storage.add({ done, best }));
          this.showProgress();
        },
      },
    });
  }

  /** Records the student's own project before the first mission opens. */
  #leaveHome(): void {
    const { projects, challenge, storage } = this.#ports;
    if (challenge.getState().challenge !== null) return;
    this.#backAction = projects.backAction();
    this.#reportUnlessStored(storage.add({ home: projects.currentId() }));
  }

  #start(challenge: ChallengeDocument, mission: string | null): void {
    const { simulator } = this.#ports;
    const [driver = "program"] = challenge.allowed.drivers;
    simulator.send({ type: "driver", driver });
    this.#show(challenge, mission);
  }

  #show(challenge: ChallengeDocument, mission: string | null): void {
    const { challenge: store, workspace } = this.#ports;
    const index = mazeIndex(challenge, workspace.getState().maze);
    // If the maze is editable, it may match none of the challenge's mazes.
    const maze = index ?? (challenge.allowed.maze ? 0 : null);
    if (maze === null) {
      this.#detach();
      return;
    }
    this.#projectId = this.#ports.projects.currentId();
    this.#begin(challenge, maze, mission);
    const rights = rightsOf(challenge);
    store.setState({ ...noChallenge, challenge, mission, maze, rights, isInvited: false });
  }

  /**
   * Handles a maze change: another maze of the challenge, or an edit that makes the project
   * something else.
   */
  #followMaze(maze: MazeDocument): void {
    const { challenge: store, projects, screen, words } = this.#ports;
    const { challenge, maze: shown } = store.getState();
    if (challenge === null || projects.currentId() !== this.#projectId) return;
    const index = mazeIndex(challenge, maze);
    if (index === null && challenge.allowed.maze) return;
    if (index === null) {
      this.#detach();
      showMessage(screen, { tone: "info", text: words.t("missions:card.replaced") });
    } else if (index !== shown) {
      this.#begin(challenge, index, store.getState().mission);
      store.setState({ maze: index, failedRun: null, result: { state: "open" } });
    }
  }

  /** Removes the challenge from the open project. */
  #detach(): void {
    const { projects, storage, challenge } = this.#ports;
    const id = projects.currentId();
    this.#reportUnlessStored(storage.removeAttempt(id));
    storage.deleteChallenge(id);
    challenge.setState(noChallenge);
  }

  #begin(challenge: ChallengeDocument, maze: number, mission: string | null): void {
    this.#judged = { kind: "open" };
    // The worker for bonus missions decides whether a maze defeats its program. No run on the
    // screen decides it.
    const attempt = bonusMissionOf(mission) === "beat-right-wall" ? null : { challenge, maze };
    this.#ports.simulator.send({ type: "judge", id: ++this.#judgeId, attempt });
  }

  /** Stores a new judgement of the attempt on the screen. */
  #receive(judged: Judgement): void {
    const { challenge: store } = this.#ports;
    const { challenge } = store.getState();
    if (challenge === null) return;
    if (judged.kind === "open") store.setState({ result: { state: "open" } });
    else if (judged.kind === "failed") {
      store.setState({ result: { state: "failed", code: judged.code, tick: judged.tick } });
    } else this.#meet(challenge, judged);
  }

  /**
   * A drive by hand counts as it is. A program must also pass a check from the start in every maze.
   */
  #meet(challenge: ChallengeDocument, met: Met): void {
    const { challenge: store, workspace } = this.#ports;
    const { driver, tick: ticks, bumps } = met;
    const { checked } = store.getState();
    const lines = driver === "program" ? workspace.getState().program.rules.length : 0;
    if (driver !== "program") {
      store.setState({ result: { state: "met", driver, ticks, bumps, lines } });
      this.#setDone({ lines, ticks });
      return;
    }
    // The same program has already passed in every maze.
    if (checked?.passed === true && challenge.mazes.length > 1) {
      this.#passed(checked, null);
      return;
    }
    store.setState({ result: { state: "here", ticks, bumps, lines } });
    if (challenge.mazes.length === 1) void this.check(met);
  }

  #setDone(done: Done): void {
    const { storage, challenge } = this.#ports;
    const { mission } = challenge.getState();
    if (mission === null || bonusMissionOf(mission) !== null) return;
    this.#reportUnlessStored(storage.add({ done: { [mission]: done } }));
    this.showProgress();
  }

  #reportUnlessStored(isStored: boolean): void {
    const { screen, words } = this.#ports;
    if (!isStored) showMessage(screen, { tone: "bad", text: words.t("missions:card.blocked") });
  }
}
