/**
 * The steps of one robot, in order. Each is applied to the robot in memory and committed under its
 * version, so that a step costs one round trip while no other relay changes the robot. Steps are
 * sent without waiting for the commits before them: each expects the version of the one before. If
 * a commit is refused because another relay came first, it and all later ones are repeated on the
 * robot that the refusal returned.
 */
import { z } from "zod";
import { StoreUnavailableError } from "../../platform/errors/store-unavailable.ts";
import { LoadedRobot, robotAnswer } from "./loaded-robot.ts";
import { commitKeys } from "./redis-keys.ts";
import type { Script } from "./script.ts";
import { counted } from "./words.ts";

/** Attempts per step. Each time, another relay has changed the robot. */
const MOST_TRIES = 32;

export interface Step<T, Read> {
  /** result if there is no such robot */
  none: T;
  /**
   * Reads what the step needs and memory lacks.
   * @param isPresent the index contained `absent` in the previous attempt
   * @returns null if it needs nothing
   */
  read?: (robot: LoadedRobot, isPresent: boolean) => Promise<Read | null> | null;
  /** Changes the robot. @param read what `read` found, or null */
  work(robot: LoadedRobot, read: Read | null): T;
  /** Key that must not be in the index by idempotency key, as a member; null: none. */
  absent?: (robot: LoadedRobot, read: Read | null) => string | null;
}

interface Task {
  /** position in the order of the steps */
  number: number;
  /** Reads; null: there is nothing to read, or it was read for this robot. */
  read(robot: LoadedRobot): Promise<void> | null;
  /** Applies the step. @returns the member that must be absent; null: none */
  apply(robot: LoadedRobot): string | null;
  /** Called when the index contains the member. */
  found(): void;
  resolve(): void;
  resolveNone(): void;
  reject(error: unknown): void;
  tries: number;
}

export interface RobotQueueParts {
  script: Pick<Script, "call">;
  relay: string;
  /** a version that no commit has used */
  newVersion(): string;
}

const answerSchema = z.union([
  z.tuple([z.literal("done")]),
  z
    .tuple([z.enum(["stale", "present"]), z.array(z.unknown()), z.array(z.unknown())])
    .transform(([outcome, ...robot]) => ({ outcome, robot })),
]);

type Answer = z.output<typeof answerSchema>;

/** Loads the robot and changes nothing. */
const LOAD = ["*", "", ""];

export class RobotQueue {
  readonly #id: string;
  readonly #parts: RobotQueueParts;
  /** null: there is none; undefined: it must be loaded */
  #robot: LoadedRobot | null | undefined;
  #steps = 0;
  #waiting: Task[] = [];
  /** sent and not answered yet */
  #sent = 0;
  #refused: Task[] = [];
  #isReading = false;

  constructor(id: string, parts: RobotQueueParts) {
    this.#id = id;
    this.#parts = parts;
  }

  get isIdle(): boolean {
    return this.#waiting.length + this.#sent + this.#refused.length === 0;
  }

  /**
   * Runs a step after all earlier ones.
   * @throws StoreUnavailableError if the robot changes too often, or if it is unknown whether the step took
   *   effect
   */
  async run<T, Read>(step: Step<T, Read>): Promise<T> {
    const { promise, resolve, reject } = Promise.withResolvers<T>();
    let read: { robot: LoadedRobot; value: Read | null } | null = null;
    let isPresent = false;
    let result = step.none;
    this.#waiting.push({
      number: (this.#steps += 1),
      read: (robot) => {
        if (read?.robot === robot) return null;
        read = null;
        const reading = step.read?.(robot, isPresent);
        return reading?.then((value) => void (read = { robot, value })) ?? null;
      },
      apply: (robot) => {
        const value = read?.value ?? null;
        const absent = step.absent?.(robot, value) ?? null;
        result = step.work(robot, value);
        return absent;
      },
      found: () => (isPresent = true),
      resolve: () => resolve(result),
      resolveNone: () => resolve(step.none),
      reject,
      tries: 0,
    });
    this.#advance();
    return promise;
  }

  /** Sends the waiting steps as far as possible. */
  #advance(): void {
    while (!this.#isReading) {
      const [task] = this.#waiting;
      if (task === undefined) return;
      if (this.#robot === undefined) {
        // The commits under way are refused, and come first.
        if (this.#sent > 0) return;
        return this.#wait(task, this.#load());
      }
      if (this.#robot === null) {
        this.#waiting.shift();
        this.#robot = undefined;
        task.resolveNone();
        continue;
      }
      try {
        const reading = task.read(this.#robot);
        if (reading !== null) return this.#wait(task, reading);
        this.#waiting.shift();
        this.#send(task, this.#robot, task.apply(this.#robot));
      } catch (error) {
        this.#fail(task, error);
      }
    }
  }

  /** Continues when this has been read. Steps behind the task wait with it. */
  #wait(task: Task, reading: Promise<void>): void {
    this.#isReading = true;
    reading
      .catch((error: unknown) => this.#fail(task, error))
      .finally(() => {
        this.#isReading = false;
        this.#advance();
      })
      .catch(() => undefined);
  }

  async #load(): Promise<void> {
    this.#robot = this.#robotIn(await this.#call(LOAD));
  }

  #send(task: Task, robot: LoadedRobot, absent: string | null): void {
    const expected = robot.version;
    const changes = robot.take();
    if (changes.length > 0) robot.version = this.#parts.newVersion();
    this.#sent += 1;
    const words = [expected, robot.version, absent ?? "", ...counted(changes)];
    this.#call(words).then(
      (answer) => this.#settle(() => this.#answered(task, answer)),
      (error: unknown) => this.#settle(() => this.#fail(task, error)),
    );
  }

  /** Handles the end of a commit. Once all have ended, continues with those that were refused. */
  #settle(work: () => void): void {
    this.#sent -= 1;
    try {
      work();
    } catch {
      // The robot cannot be read. Loading it again reports why.
      this.#robot = undefined;
    }
    if (this.#sent > 0) return;
    if (this.#refused.length > 0) {
      const refused = this.#refused.toSorted((a, b) => a.number - b.number);
      this.#waiting = [...refused, ...this.#waiting];
      this.#refused = [];
    }
    this.#advance();
  }

  #answered(task: Task, answer: Answer): void {
    if (!("robot" in answer)) return task.resolve();
    task.tries += 1;
    if (answer.outcome === "present") task.found();
    if (task.tries < MOST_TRIES) this.#refused.push(task);
    else
      task.reject(
        new StoreUnavailableError(new Error("other relays changed the robot at each attempt")),
      );
    // All later commits are refused, too. The last refusal has the newest robot.
    this.#robot = this.#sent > 0 ? undefined : this.#robotIn(answer);
  }

  #fail(task: Task, error: unknown): void {
    this.#waiting = this.#waiting.filter((each) => each !== task);
    this.#robot = undefined;
    task.reject(error);
  }

  async #call(words: string[]): Promise<Answer> {
    return answerSchema.parse(await this.#parts.script.call(commitKeys(this.#id), words));
  }

  /** @returns null if there is no such robot */
  #robotIn(answer: Answer): LoadedRobot | null {
    if (!("robot" in answer) || answer.robot[0][0] === null) return null;
    return new LoadedRobot(this.#id, this.#parts.relay, robotAnswer.parse(answer.robot));
  }
}
