/**
 * Opens missions, lessons, their tasks and mazes, and returns to the maze from before. Each task has
 * its own project, so that other projects stay unchanged.
 */
import {
  lessonOf,
  rightsOf,
  startingProgram,
  type LessonDocument,
  type LessonTask,
} from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import { LessonAddress, type AddressBar } from "../address/lesson-address.ts";
import { noChallenge, openTask, type TaskPlace } from "../challenge/challenge-store.ts";
import { firstProject } from "../projects/first-visit.ts";
import { dismiss, showMessage } from "../screen/screen-store.ts";
import { replaceMaze } from "../workspace/replace-maze.ts";
import { setMaze } from "../workspace/workspace-store.ts";
import type { Attempt } from "./attempt.ts";
import { readLessonText, writeLessonText } from "./lesson-text.ts";
import type { LessonsPorts } from "./lessons-ports.ts";
import { mazeIndex } from "./maze-index.ts";
import { missionDocument } from "./mission-document.ts";
import { bonusMissions } from "./missions/bonus-missions.ts";
import { missions } from "./missions/missions.ts";
import { reportUnlessStored } from "./report-unless-stored.ts";
import { resetHiddenTools } from "./reset-hidden-tools.ts";
import { readReference, writeReference, type StoredLessons } from "./stored-lessons.ts";
import { isTaskOpen, nextTask } from "./task-order.ts";

/** Everything that an address can name. */
const addressed = [...missions, ...bonusMissions];

/** A task to display. Both ids are null for a shared lesson of one task. */
interface ShownTask {
  lesson: LessonDocument;
  index: number;
  /** id of the mission */
  mission: string | null;
  /** id of the stored lesson */
  lessonId: string | null;
}

export class LessonsNavigation {
  readonly #ports: LessonsPorts;
  readonly #attempt: Pick<Attempt, "begin">;
  readonly #lessons: StoredLessons;
  readonly #address: LessonAddress;
  /** `ProjectService.opened` of the project with the open task */
  #opened: number | null = null;
  /** reopens what was open before the first mission, even if it was never stored */
  #backAction: (() => void) | null = null;

  constructor(
    ports: LessonsPorts,
    attempt: Pick<Attempt, "begin">,
    lessons: StoredLessons,
    bar: AddressBar,
  ) {
    this.#ports = ports;
    this.#attempt = attempt;
    this.#lessons = lessons;
    this.#address = new LessonAddress(ports.challenge, bar, {
      goHome: () => this.goHome(),
      openTaskAt: (place) => this.#openAt(place, null),
    });
    ports.workspace.subscribe((next, before) => {
      if (next.maze !== before.maze) this.#followMaze(next.maze);
    });
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
    const mission = addressed.find((each) => each.id === id);
    if (mission === undefined) return false;
    this.#address.opening();
    const { storage, projects, words } = this.#ports;
    const lesson = lessonOf(missionDocument(mission, words));
    const attempt = projects.list().find((project) => project.id === storage.record.works[id]);
    this.#leaveHome();
    if (attempt !== undefined) projects.open(attempt);
    else {
      this.#beginTask(lesson.tasks[0], null);
      reportUnlessStored(this.#ports, storage.add({ works: { [id]: projects.currentId() } }));
    }
    this.#start({ lesson, index: 0, mission: id, lessonId: null });
    return true;
  }

  /**
   * Opens a lesson beside the student's projects: one of several tasks where the student left it,
   * one of a single task from its start.
   * @param program of the student, for the first task; null for the starting program
   */
  openShared(lesson: LessonDocument, program: ProgramDocument | null): void {
    if (lesson.tasks.length > 1) {
      const { id, isStored } = this.#lessons.add(lesson);
      const solved = this.#lessons.solved(id, lesson);
      const { openTo } = this.#ports.challenge.getState();
      // The task after the last one is the first one again.
      const next = nextTask(lesson, solved, lesson.tasks.length, openTo) ?? 0;
      this.#address.opening();
      this.#openAt({ lesson: id, index: program === null ? next : 0 }, program);
      reportUnlessStored(this.#ports, isStored);
      return;
    }
    this.#leaveHome();
    this.#beginTask(lesson.tasks[0], program);
    this.#storeReference(writeLessonText(lesson));
    this.#start({ lesson, index: 0, mission: null, lessonId: null });
  }

  /** Opens a lesson where the student left it, or from its start. */
  resume(lesson: LessonDocument): void {
    const { projects, storage } = this.#ports;
    const text = writeLessonText(lesson);
    const project =
      lesson.tasks.length > 1
        ? undefined
        : projects.list().find(({ id }) => storage.challengeOf(id) === text);
    if (project === undefined) {
      this.openShared(lesson, null);
      return;
    }
    this.#leaveHome();
    projects.open(project);
    this.#start({ lesson, index: 0, mission: null, lessonId: null });
  }

  /** Opens another task of the open lesson where the student left it, unless it is still locked. */
  openTask(index: number): void {
    const { lesson, lessonId, index: open, solved, openTo } = this.#ports.challenge.getState();
    if (lesson === null || lessonId === null || index === open) return;
    if (!isTaskOpen(lesson, solved, index, openTo)) return;
    this.#address.opening();
    this.#openAt({ lesson: lessonId, index }, null);
  }

  /**
   * Opens a task of a stored lesson in its newest project, or in a new one.
   * @param program for a new project; null for the newest project or the starting program
   * @returns whether the device stores the lesson with this task
   */
  #openAt(place: TaskPlace, program: ProgramDocument | null): boolean {
    const { projects, storage } = this.#ports;
    const lesson = this.#lessons.lesson(place.lesson);
    const task = lesson?.tasks[place.index];
    if (lesson === null || task === undefined) return false;
    const reference = writeReference(place);
    const stored = projects.list().find(({ id }) => storage.challengeOf(id) === reference);
    this.#leaveHome();
    if (stored !== undefined && program === null) projects.open(stored);
    else {
      this.#beginTask(task, program);
      this.#storeReference(reference);
    }
    this.#start({ lesson, index: place.index, mission: null, lessonId: place.lesson });
    return true;
  }

  #beginTask(task: LessonTask | undefined, program: ProgramDocument | null): void {
    const maze = task?.mazes[0];
    if (task === undefined || maze === undefined) return;
    this.#ports.projects.beginNew(maze, program ?? startingProgram(task));
  }

  /** Stores with the open project what it belongs to. */
  #storeReference(text: string): void {
    const { projects, storage } = this.#ports;
    reportUnlessStored(this.#ports, storage.storeChallenge(projects.currentId(), text));
  }

  /** Loads the task of the open project, if it has one. The robot stays where it is. */
  sync(): void {
    const { projects, storage, words } = this.#ports;
    const id = storage.missionOf(projects.currentId());
    const mission = addressed.find((each) => each.id === id);
    if (mission !== undefined) {
      const lesson = lessonOf(missionDocument(mission, words));
      this.#show({ lesson, index: 0, mission: mission.id, lessonId: null });
      return;
    }
    const text = storage.challengeOf(projects.currentId());
    if (text === null) return;
    const place = readReference(text);
    const lesson = place === null ? readLessonText(text) : this.#lessons.lesson(place.lesson);
    if (lesson === null) return;
    const { index = 0, lesson: lessonId = null } = place ?? {};
    this.#show({ lesson, index, mission: null, lessonId });
  }

  /** Offers control to the driver of the open task, unless a run has already started. */
  handOver(): void {
    const { challenge, simulator } = this.#ports;
    const driver = challenge.getState().rights?.drivers[0];
    if (driver !== undefined) simulator.send({ type: "offer-driver", driver });
  }

  /** Shows another given maze of the task. The program stays. */
  showMaze(index: number): void {
    const { challenge, workspace, simulator } = this.#ports;
    const state = challenge.getState();
    const task = openTask(state);
    const given = task?.mazes[index];
    if (task === null || given === undefined) return;
    // `#followMaze` resets the robot for another maze.
    if (index === state.maze) simulator.send({ type: "reset" });
    const maze = { ...given, name: workspace.getState().maze.name };
    // Where the student edits mazes, Undo restores the edited one.
    if (task.allowed.maze) setMaze(workspace, maze);
    else replaceMaze(workspace, maze);
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

  /** Records the student's own project before the first mission opens. */
  #leaveHome(): void {
    const { projects, challenge, storage } = this.#ports;
    if (challenge.getState().lesson !== null) return;
    this.#backAction = projects.backAction();
    reportUnlessStored(this.#ports, storage.add({ home: projects.currentId() }));
  }

  #start(shown: ShownTask): void {
    const task = shown.lesson.tasks[shown.index];
    const [driver = "program"] = task === undefined ? [] : rightsOf(task).drivers;
    this.#ports.simulator.send({ type: "driver", driver });
    this.#show(shown);
  }

  #show({ lesson, index, mission, lessonId }: ShownTask): void {
    const { challenge: store, workspace, projects } = this.#ports;
    const task = lesson.tasks[index];
    if (task === undefined) return;
    const displayed = mazeIndex(task, workspace.getState().maze);
    // If the maze is editable, it may match none of the task's mazes.
    const maze = displayed ?? (task.allowed.maze ? 0 : null);
    if (maze === null) {
      this.#detach();
      return;
    }
    this.#opened = projects.opened();
    this.#attempt.begin(task, maze, mission);
    const solved = lessonId === null ? [] : this.#lessons.solved(lessonId, lesson);
    const rights = rightsOf(task);
    resetHiddenTools(this.#ports, rights);
    const shown = { lesson, index, mission, lessonId, solved, maze, rights };
    store.setState({ ...noChallenge, ...shown, isInvited: false });
  }

  /**
   * Handles a maze change: another maze of the task, or an edit that makes the project something
   * else.
   */
  #followMaze(maze: MazeDocument): void {
    const { challenge: store, projects, simulator } = this.#ports;
    const { lesson, index, mission, lessonId, maze: shown } = store.getState();
    const task = lesson?.tasks[index];
    if (lesson === null || task === undefined) return;
    if (projects.opened() !== this.#opened) return;
    const displayed = mazeIndex(task, maze);
    if (displayed === null) {
      if (task.allowed.maze) return;
      this.#detach();
      this.#reportReplaced({ lesson, index, mission, lessonId });
    } else if (displayed !== shown) {
      // The run of the other maze ends first: this maze must not be judged by it.
      simulator.send({ type: "reset" });
      this.#attempt.begin(task, displayed, mission);
      store.setState({ maze: displayed, failedRun: null, result: { state: "open" } });
    }
  }

  /** Reports that another maze closed the task. Only the message leads back to a shared lesson. */
  #reportReplaced({ lesson, index, mission, lessonId }: ShownTask): void {
    const { screen, words } = this.#ports;
    if (mission !== null) {
      showMessage(screen, { tone: "info", text: words.t("missions:card.replaced") });
      return;
    }
    const message = showMessage(screen, {
      tone: "info",
      text: words.t("missions:lesson.replaced"),
      action: {
        label: words.t("missions:lesson.back"),
        run: () => {
          dismiss(screen, message);
          if (lessonId === null) this.openShared(lesson, null);
          else this.#openAt({ lesson: lessonId, index }, null);
        },
      },
    });
  }

  /** Removes the task from the open project. */
  #detach(): void {
    const { projects, storage, challenge } = this.#ports;
    const id = projects.currentId();
    reportUnlessStored(this.#ports, storage.removeAttempt(id));
    storage.deleteChallenge(id);
    challenge.setState(noChallenge);
  }
}
