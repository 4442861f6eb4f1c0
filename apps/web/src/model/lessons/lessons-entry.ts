/**
 * Entry point to the lessons on the first screen: decides whether to invite, and when to load the
 * rest. The service and its data are in a separate file. It loads when a mission opens, or when the
 * open project belongs to one.
 */
import type { LessonDocument } from "@corridor/challenge";
import type { ProgramDocument } from "@corridor/program";
import { noChallenge } from "../challenge/challenge-store.ts";
import { showMessage } from "../screen/screen-store.ts";
import type { LessonsPorts } from "./lessons-ports.ts";
import type { LessonsService } from "./lessons-service.ts";

export class LessonsEntry {
  readonly #ports: LessonsPorts;
  #service: Promise<LessonsService> | null = null;
  #opened: number;

  constructor(ports: LessonsPorts) {
    this.#ports = ports;
    const { projects, workspace, challenge, storage } = ports;
    this.#opened = projects.opened();
    if (!storage.isKnown && projects.list().length === 0) challenge.setState({ isInvited: true });
    if (this.#belongsToChallenge()) void this.#sync();
    workspace.subscribe(() => {
      if (projects.opened() === this.#opened) return;
      this.#opened = projects.opened();
      challenge.setState({ isInvited: false });
      if (this.#belongsToChallenge()) void this.#sync().then(() => this.handOver());
      else if (challenge.getState().lesson !== null) challenge.setState(noChallenge);
    });
  }

  /** Loads the lessons. A failed load can be retried. */
  async load(): Promise<LessonsService> {
    this.#service ??= this.#fetch();
    try {
      return await this.#service;
    } catch (error) {
      this.#service = null;
      throw error;
    }
  }

  /** Opens a mission in its own project. Shows a message if the lessons fail to load. */
  async openMission(id: string): Promise<void> {
    await this.#withService(({ navigation }) => navigation.openMission(id));
  }

  /**
   * Opens a lesson from a link or a file beside the student's projects.
   * @param program from the link; null for the starting program of the task
   * @returns false if the lessons failed to load; a message reports it
   */
  async openShared(lesson: LessonDocument, program: ProgramDocument | null): Promise<boolean> {
    return this.#withService(({ navigation }) => navigation.openShared(lesson, program));
  }

  /**
   * Selects the driver of the open project's task, if it has one. Call it only once the page
   * knows whether it restores a run.
   */
  async handOver(): Promise<void> {
    if (this.#belongsToChallenge())
      await this.#withService(({ navigation }) => navigation.handOver());
  }

  /** Hides the invitation for good. */
  dismissInvitation(): void {
    this.#ports.challenge.setState({ isInvited: false });
    this.#ports.storage.add({});
  }

  #belongsToChallenge(): boolean {
    const { storage, projects } = this.#ports;
    return storage.hasTask(projects.currentId());
  }

  async #sync(): Promise<void> {
    await this.#withService(({ navigation }) => navigation.sync());
  }

  /** @returns whether the lessons loaded */
  async #withService(use: (lessons: LessonsService) => void): Promise<boolean> {
    const { screen, words } = this.#ports;
    let lessons: LessonsService;
    try {
      lessons = await this.load();
    } catch {
      showMessage(screen, { tone: "bad", text: words.t("lessons.notLoaded") });
      return false;
    }
    use(lessons);
    return true;
  }

  async #fetch(): Promise<LessonsService> {
    const { words } = this.#ports;
    const [{ LessonsService }] = await Promise.all([
      import("./lessons-service.ts"),
      words.loadNamespaces("missions"),
    ]);
    return new LessonsService(this.#ports);
  }
}
