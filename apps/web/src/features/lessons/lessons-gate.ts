/**
 * The lessons as the first screen knows them: whether to invite, and when to fetch the rest. All that
 * a mission needs comes in a file of its own when one is opened, or when the open work belongs to one.
 */
import type { ChallengeDocument } from "@corridor/challenge";
import type { ProgramDocument } from "@corridor/program";
import { noChallenge } from "../../stores/challenge-store.ts";
import { showMessage } from "../../stores/screen-store.ts";
import type { LessonsPorts } from "./lessons-ports.ts";
import type { LessonsService } from "./lessons-service.ts";

export class LessonsGate {
  readonly #ports: LessonsPorts;
  #service: Promise<LessonsService> | null = null;
  #work: string;

  constructor(ports: LessonsPorts) {
    this.#ports = ports;
    const { works, workspace, challenge, storage } = ports;
    this.#work = works.currentId();
    if (!storage.isKnown && works.list().length === 0) challenge.setState({ isInvited: true });
    if (this.#belongsToChallenge()) void this.#sync();
    workspace.subscribe(() => {
      if (works.currentId() === this.#work) return;
      this.#work = works.currentId();
      challenge.setState({ isInvited: false });
      if (this.#belongsToChallenge()) void this.#sync().then(() => this.handOver());
      else if (challenge.getState().challenge !== null) challenge.setState(noChallenge);
    });
  }

  /** The lessons themselves; one that did not come can be asked for again. */
  async load(): Promise<LessonsService> {
    this.#service ??= this.#fetch();
    try {
      return await this.#service;
    } catch (error) {
      this.#service = null;
      throw error;
    }
  }

  /** Opens a mission in a work of its own; says so when its file does not come. */
  async openMission(id: string): Promise<void> {
    await this.#withService((lessons) => lessons.openMission(id));
  }

  /**
   * Opens a challenge that somebody shared in a work of its own.
   * @param program what the link brought along; null: what the challenge begins with
   * @returns false where the lessons did not come, which is told
   */
  async openShared(
    challenge: ChallengeDocument,
    program: ProgramDocument | null,
  ): Promise<boolean> {
    return this.#withService((lessons) => lessons.openShared(challenge, program));
  }

  /** The open work's driver drives, where it has one. Not before the page knows whether a run comes back. */
  async handOver(): Promise<void> {
    if (this.#belongsToChallenge()) await this.#withService((lessons) => lessons.handOver());
  }

  /** The reader does not want to be invited again. */
  dismissInvitation(): void {
    this.#ports.challenge.setState({ isInvited: false });
    this.#ports.storage.add({});
  }

  #belongsToChallenge(): boolean {
    const { storage } = this.#ports;
    return storage.missionOf(this.#work) !== null || storage.challengeOf(this.#work) !== null;
  }

  async #sync(): Promise<void> {
    await this.#withService((lessons) => lessons.sync());
  }

  /** @returns whether the lessons came */
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
