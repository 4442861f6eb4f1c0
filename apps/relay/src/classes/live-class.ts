/** One class at this relay: its state, its place on the bus, and when it was last used. */
import {
  progressRecordSchema,
  sinceOf,
  studentProgramSchema,
  type ClassView,
  type StudentProgram,
} from "@corridor/protocol";
import { Refusal } from "../platform/errors/problems.ts";
import { limits } from "../platform/limits/limits.ts";
import type { Clock } from "../platform/time/clock.ts";
import type { ClassBus, ClassChannel, ClassCommit } from "../bus/class-bus.ts";
import type { ClassStore, LoadedClass } from "../store/class-store.ts";
import { memberOf, type Member } from "./access.ts";
import { ClassConnections } from "./class-connections.ts";
import { ClassCommits } from "./class-commits.ts";
import { activeMs, isoTime, settingsOf, stateOf, viewOf, type ClassState } from "./class-state.ts";
import type { Step } from "./step.ts";
import { removeStep, requireStudent } from "./teacher-steps.ts";

export interface LiveClassParts {
  store: ClassStore;
  bus: ClassBus;
  clock: Clock;
  /** called when the class does not exist any more */
  ended(): void;
}

export class LiveClass {
  readonly id: string;
  readonly #parts: LiveClassParts;
  readonly #commits: ClassCommits;
  readonly connections: ClassConnections;
  #channel: ClassChannel | null = null;
  #usedAt: number;
  /** last use that is stored */
  #notedAt: number;

  private constructor(id: string, loaded: LoadedClass, parts: LiveClassParts) {
    this.id = id;
    this.#parts = parts;
    this.#usedAt = parts.clock.now();
    this.#notedAt = loaded.row.createdAt;
    const { store, clock } = parts;
    const listener = {
      committed: (commit: ClassCommit) => this.#channel?.committed(commit),
      changed: (...change: Parameters<ClassConnections["changed"]>) =>
        this.connections.changed(...change),
      ended: () => parts.ended(),
    };
    this.#commits = new ClassCommits(id, stateOf(loaded), { store, clock, listener });
    this.connections = new ClassConnections({
      clock,
      state: () => this.#commits.state,
      notify: (message) => this.#channel?.notify(message),
    });
  }

  /** @returns null if there is no such class */
  static async open(id: string, parts: LiveClassParts): Promise<LiveClass | null> {
    const loaded = await parts.store.load(id);
    if (loaded === null) return null;
    const opened = new LiveClass(id, loaded, parts);
    opened.#channel = await parts.bus.join(id, {
      committed: (commit) => opened.#commits.received(commit),
      over: () => parts.ended(),
      received: (message, from) => opened.connections.received(message, from),
      missed: () => opened.#missed(),
    });
    // Another relay may have changed the class before this one joined the channel.
    opened.#missed();
    return opened;
  }

  get state(): ClassState {
    return this.#commits.state;
  }

  /** Runs a step. Its changes are stored when the promise resolves. */
  async run<T>(step: Step<T>): Promise<T> {
    return this.#commits.run(step);
  }

  /**
   * Deletes a student with all data, also from the files of the store.
   * @throws Refusal no-student
   */
  async removeStudent(student: number): Promise<void> {
    await this.run(removeStep(student));
    await this.#parts.store.erased();
  }

  /** The member with a key, who may have joined at another relay a moment ago; null: nobody. */
  async memberOf(key: string): Promise<Member | null> {
    return memberOf(this.state, key) ?? memberOf(await this.#commits.reloaded(), key);
  }

  /** ms until the class is deleted at the latest */
  get leftMs(): number {
    const { createdAt } = this.state.row;
    return Math.max(0, createdAt + limits.classLifeMs - this.#parts.clock.now());
  }

  async view(): Promise<ClassView> {
    const records = await this.#parts.store.progress(this.id);
    const { row, students } = this.state;
    const progress = Map.groupBy(records, ({ student }) => student);
    const now = this.#parts.clock.now();
    return {
      id: this.id,
      now: isoTime(now),
      activeMs: activeMs(row, now),
      endsInSeconds: Math.ceil(this.leftMs / 1_000),
      expected: row.expected,
      settings: settingsOf(row, now),
      students: [...students.values()].map((student) => ({
        ...viewOf(row, student),
        progress: (progress.get(student.student) ?? []).map(({ text }) =>
          progressRecordSchema.parse(JSON.parse(text)),
        ),
      })),
      since: sinceOf(row.stream, row.n),
    };
  }

  /** The lesson as JSON, with its version. */
  async lesson(): Promise<{ text: string; version: string } | null> {
    const { lessonVersion: version } = this.state.row;
    const text = await this.#parts.store.lesson(this.id);
    return text === null ? null : { text, version };
  }

  /** @throws Refusal no-student or no-program */
  async program(student: number): Promise<StudentProgram> {
    requireStudent(this.state, student);
    const text = await this.#parts.store.program(this.id, student);
    if (text === null) {
      throw new Refusal("no-program", "The student has not changed a program in this class yet.");
    }
    return studentProgramSchema.parse(JSON.parse(text));
  }

  // --- use ---

  used(): void {
    this.#usedAt = Math.max(this.#usedAt, this.#parts.clock.now());
  }

  /** Stores the last use, if the stored one is older than a minute. */
  async noteUse(): Promise<void> {
    this.connections.deleteOldEvents();
    const usedAt = this.#usedAt;
    if (usedAt - this.#notedAt < limits.touchMs) return;
    await this.#parts.store.touch(this.id, usedAt);
    this.#notedAt = usedAt;
  }

  /** Whether it may be loaded again later, because it was not used for a while. */
  get isQuiet(): boolean {
    const isIdle = this.#parts.clock.now() - this.#usedAt > limits.classQuietMs;
    return isIdle && this.connections.isEmpty;
  }

  /** Publishes that the class was deleted, and ends it here. */
  over(): void {
    this.#channel?.over();
    this.end();
  }

  /** Closes all connections, because the class was deleted. */
  end(): void {
    this.connections.ended();
    this.leave();
  }

  leave(): void {
    this.connections.leave();
    this.#channel?.leave();
    this.#channel = null;
  }

  /** Messages of other relays may have been missed. */
  #missed(): void {
    this.#commits.missed();
    this.connections.missed();
  }
}
