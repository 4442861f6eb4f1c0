/** One connection of VIPLE to one robot. VIPLE sends a motion once; it lasts until the next one. */
import { randomUUID } from "node:crypto";
import {
  MotionRegister,
  RefusedError,
  type CommandRecord,
  type Order,
  type RobotPort,
  type Timers,
} from "@corridor/protocol";
import { readMotion } from "./read-motion.ts";
import { SensorFeed } from "./sensor-feed.ts";
import { sensorMessage, type SensorSettings } from "./sensor-settings.ts";
import { VipleError } from "./viple-error.ts";

/** Less than the register's interval of renewals, so that a velocity is renewed in time. */
const REPEAT_MS = 100;

export interface VipleSessionOptions {
  /** The session closes it. */
  port: RobotPort;
  timers: Timers;
  settings: SensorSettings;
  /** Sends a message with readings. */
  send(text: string): void;
  /**
   * Called with a sentence for each message that is ignored, and for each command that is refused or
   * ends without having run.
   */
  onProblem(sentence: string): void;
}

export class VipleSession {
  readonly #options: VipleSessionOptions;
  readonly #register: MotionRegister;
  readonly #feed: SensorFeed;
  readonly #wheels = { left: 0, right: 0 };
  #cancelRepeat = (): void => undefined;
  /** the beginning of its idempotency keys */
  readonly #keyPrefix = `${randomUUID()}-`;
  #orders = 0;
  /** the newest of its orders that has begun */
  #startedKey: string | null = null;
  /** whether VIPLE's newest motion has been reported as one that does not begin */
  #isReported = false;

  /** @throws RefusedError if the port permits no subscription */
  constructor(options: VipleSessionOptions) {
    this.#options = options;
    const { port, timers, settings } = options;
    this.#register = new MotionRegister({
      timers,
      running: () => port.newest?.command ?? null,
      hasOther: () => false,
      send: (order) => this.#send(order),
    });
    this.#feed = new SensorFeed(timers, (text) => options.send(text));
    port.subscribe({
      snapshot: (snapshot) => this.#feed.update(sensorMessage(snapshot, settings)),
      state: (record) => {
        if (this.#isInterrupted(record)) this.#cancelRepeat();
        this.#reportUnstarted(record);
      },
      gap: () => this.#cancelRepeat(),
      maze: () => undefined,
      end: () => this.#cancelRepeat(),
    });
    const { newest } = port;
    if (newest !== null) this.#feed.update(sensorMessage(newest, settings));
  }

  /** Handles one message. */
  receive(text: string): void {
    try {
      const motion = readMotion(text);
      if (motion === null) return;
      this.#isReported = false;
      if ("degrees" in motion) this.#turn(motion.degrees);
      else {
        Object.assign(this.#wheels, motion);
        this.#drive();
      }
    } catch (error) {
      if (!(error instanceof VipleError)) throw error;
      this.#options.onProblem(error.message);
    }
  }

  close(): void {
    this.#cancelRepeat();
    this.#feed.close();
    this.#register.close();
    this.#options.port.close();
  }

  #turn(degrees: number): void {
    this.#cancelRepeat();
    Object.assign(this.#wheels, { left: 0, right: 0 });
    this.#register.set({ action: "turn", degrees }, null);
  }

  /** Drives until another motion, or until something interrupts it. */
  #drive(): void {
    this.#cancelRepeat();
    const { left, right } = this.#wheels;
    this.#register.set({ action: "drive", left, right }, null);
    if (left === 0 && right === 0) return;
    this.#cancelRepeat = this.#options.timers.after(REPEAT_MS, () => this.#drive());
  }

  /** Never rejects. */
  async #send(order: Order): Promise<number | null> {
    this.#orders += 1;
    try {
      return (await this.#options.port.send(order, this.#newestKey)).seq;
    } catch (error) {
      this.#cancelRepeat();
      this.#options.onProblem(error instanceof RefusedError ? error.message : String(error));
      return null;
    }
  }

  get #newestKey(): string {
    return `${this.#keyPrefix}${this.#orders}`;
  }

  /**
   * VIPLE receives no answer. If its motion ends without having run, for instance because Remote is not
   * driving, the reason is reported once, however often the motion is repeated.
   */
  #reportUnstarted({ key, state, reason }: CommandRecord): void {
    if (key?.startsWith(this.#keyPrefix) !== true) return;
    if (state === "started") this.#startedKey = key;
    const isUnstarted = (state === "cancelled" || state === "expired") && key !== this.#startedKey;
    if (!isUnstarted || this.#isReported || reason === null) return;
    this.#isReported = true;
    this.#options.onProblem(reason);
  }

  /**
   * Whether the owner, another script or a lost network ended the motion. It begins again only if VIPLE
   * sends another one.
   */
  #isInterrupted({ key, state, command }: CommandRecord): boolean {
    if (key?.startsWith(this.#keyPrefix) !== true || command.action !== "drive") return false;
    const { left, right } = this.#wheels;
    if (command.left !== left || command.right !== right) return false;
    return state === "cancelled" || (state === "superseded" && key === this.#newestKey);
  }
}
