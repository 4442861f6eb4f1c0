/**
 * Takes in the commands of scripts: checks their rate, stores them, acknowledges them, and delivers
 * each in its turn. A command that is not stored has no effect, and its sender receives the reason.
 */
import { hasEnded, PAUSED_REASON, type CommandRecord, type CommandTerms } from "@corridor/protocol";
import { addStep } from "../../commands/state-machine.ts";
import type { Clock } from "../../platform/time/clock.ts";
import type { CommandChanges } from "../../bus/bus.ts";
import { noRobot, Refusal, restarting, retryAfter } from "../../platform/errors/problems.ts";
import type { AddResult } from "../../commands/robot-step.ts";
import type { RobotStore } from "../../store/robot-store.ts";
import type { TermedRecord } from "../../commands/robot-commands.ts";
import { KeyedRateLimiter } from "../../platform/limits/keyed-rate-limiter.ts";
import { limits } from "../../platform/limits/limits.ts";
import type { SerialQueue } from "../../platform/serial-queue.ts";
import { scriptIsBlocked, type Caller } from "../access/callers.ts";
import { keyRevoked } from "../access/key-ring.ts";
import type { CommandDelivery } from "./command-delivery.ts";
import type { CommandObserver } from "./command-observer.ts";

export interface CommandIntakeParts {
  robot: string;
  store: RobotStore;
  clock: Clock;
  observer: CommandObserver;
  /** the queue of all changes to commands */
  work: SerialQueue;
  delivery: CommandDelivery;
  /** why the robot takes no more commands; null: it takes them */
  end(): "over" | "restart" | null;
  /** called with the time at which a waiting command may expire */
  expiresAt(time: number): void;
  /** called if the store failed to respond, but may have stored a command */
  doubted(): void;
  /** publishes changes, and shows the page what has ended */
  commandsChanged(changes: CommandChanges): void;
}

export class CommandIntake {
  readonly #parts: CommandIntakeParts;
  readonly #rateLimiter: DriverRateLimiter;
  /** seq of the newest command if that is a stop; otherwise null */
  #newestStop: number | null = null;
  /** time of the newest reset, here or at another relay */
  #resetAt = Number.NEGATIVE_INFINITY;

  constructor(parts: CommandIntakeParts) {
    this.#parts = parts;
    this.#rateLimiter = new DriverRateLimiter(parts.clock);
  }

  /**
   * Stores a command and delivers it in its turn. A stop overtakes all other commands. If a stop
   * exceeds the rate limit, the relay responds with the stop that is still open, if there is one.
   * This requires a request without an idempotency key, or with the key of that stop.
   * @param acknowledge called with the stored record, before anything else is published about it;
   * `duplicate` is true if the record was stored before
   * @throws Refusal too-fast, restarting, no-robot or a reason of `notStored`
   */
  async submit(
    caller: Caller,
    request: { key: string | null } & CommandTerms,
    acknowledge: (record: CommandRecord) => void,
  ): Promise<void> {
    const { robot, store, clock, observer, work, delivery } = this.#parts;
    const arrivedAt = clock.now();
    const isStop = request.command.action === "stop";
    const tooFast = this.#rateLimiter.take(caller.hash, isStop);
    if (tooFast !== null && !isStop) throw tooFast;
    await work.run(async () => {
      const end = this.#parts.end();
      if (end !== null) throw end === "restart" ? restarting() : noRobot();
      if (tooFast !== null) {
        const stop = await this.#openStop();
        // A sender with another key expects a record of its own, and retries.
        const mayShare = request.key === null || request.key === stop?.key;
        if (stop === null || !mayShare) throw tooFast;
        return acknowledge({ ...stop, duplicate: true });
      }
      const { key, command, ttl, age, replace, lease } = request;
      const terms = {
        driver: caller.hash,
        script: caller.script?.id ?? null,
        ttl,
        deadline: arrivedAt + ttl - age,
        replace,
        lease,
      };
      const added = store.commit(
        robot,
        addStep({
          key,
          command,
          ...terms,
          acceptedAt: arrivedAt,
          resetFrom: this.#resetFrom(arrivedAt),
          maxWaiting: limits.waitingCommands,
          keep: limits.storedCommands,
        }),
      );
      // In the same turn, so that one commit stores the command and its delivery.
      const due = delivery.take();
      const result = await added.catch(async (error: unknown) => {
        this.#parts.doubted();
        delivery.send(await due);
        throw error;
      });
      if (result.outcome === "duplicate") {
        acknowledge({ ...result.record, duplicate: true });
        // The first attempt may have failed before it did anything else.
        if (result.record.state === "accepted") this.#parts.expiresAt(arrivedAt);
        return delivery.send(await due);
      }
      if (result.outcome !== "stored") {
        delivery.send(await due);
        throw notStored(result, request, this.#resetFrom(arrivedAt) - arrivedAt);
      }
      const { record, ended } = result;
      this.#newestStop = isStop ? record.seq : null;
      if (record.action === "reset") this.#resetAt = arrivedAt;
      observer.stored(Math.max(0, clock.now() - arrivedAt) / 1000);
      acknowledge(record);
      const delivered = await due;
      const stored = { record, ...terms };
      this.#parts.expiresAt(terms.deadline);
      this.#parts.commandsChanged({
        added: stored,
        ended,
        changed: ended.map((each) => each.record),
      });
      delivery.sendOrShow(stored, delivered);
    });
  }

  /** Records a command that another relay has stored. */
  storedElsewhere({ record }: TermedRecord): void {
    this.#newestStop = record.action === "stop" ? record.seq : null;
    if (record.action === "reset") this.#resetAt = Date.parse(record.acceptedAt);
  }

  /** When the robot accepts the next reset. A clock that was set back does not delay it. */
  #resetFrom(now: number): number {
    return this.#resetAt > now ? now : this.#resetAt + limits.resetIntervalMs;
  }

  /** The newest command, if it is a stop that has not ended. Another stop would change nothing. */
  async #openStop(): Promise<CommandRecord | null> {
    if (this.#newestStop === null) return null;
    const record = await this.#parts.store.command(this.#parts.robot, this.#newestStop);
    return record === null || hasEnded(record.state) ? null : record;
  }
}

/** Rate limiter by driver key. Stops have a separate bucket, so they never wait behind commands. */
class DriverRateLimiter {
  readonly #commands: KeyedRateLimiter;
  readonly #stops: KeyedRateLimiter;

  constructor(clock: Clock) {
    this.#commands = new KeyedRateLimiter(clock, limits.commandRate);
    this.#stops = new KeyedRateLimiter(clock, limits.stopRate);
  }

  /**
   * Takes one token.
   * @param driver hash of the key
   * @returns the error response if the key exceeds its rate; otherwise null
   */
  take(driver: string, isStop: boolean): Refusal | null {
    const waitMs = (isStop ? this.#stops : this.#commands).take(driver);
    if (waitMs === 0) return null;
    const { perSecond, burst } = isStop ? limits.stopRate : limits.commandRate;
    return new Refusal(
      "too-fast",
      `Too many ${isStop ? "stops" : "commands"}: a key can send ${perSecond} a second, with bursts of ${burst}. Wait a second, then send this command again.`,
      { headers: retryAfter(waitMs) },
    );
  }
}

/** Results of the store for a command that is neither stored nor a duplicate. */
type NotStored = Exclude<AddResult, { outcome: "stored" | "duplicate" }>;

/** @param resetMs ms until the robot accepts a reset */
function notStored(result: NotStored, { ttl, age }: CommandTerms, resetMs: number): Refusal {
  switch (result.outcome) {
    case "no-robot":
      return noRobot();
    case "revoked":
      return keyRevoked();
    case "blocked":
      return scriptIsBlocked();
    case "paused":
      return new Refusal("driving-paused", PAUSED_REASON);
    case "reset-disabled":
      return new Refusal(
        "reset-disabled",
        "The robot's owner does not let scripts reset the robot. Ask the owner to switch on 'Scripts may reset the robot', or continue without a reset.",
      );
    case "too-soon":
      return new Refusal(
        "too-fast",
        "Too many resets: a robot accepts one a second. Wait a second, then send this command again.",
        { headers: retryAfter(resetMs) },
      );
    case "full":
      return new Refusal(
        "queue-full",
        `${limits.waitingCommands} commands wait at this robot, the maximum. Wait until one ends, then send this command again.`,
        { headers: retryAfter(1000) },
      );
    case "late":
      return new Refusal(
        "too-late",
        `The command is ${Math.round(age)} ms old, and its time to live (ttl) is ${ttl} ms. Check where the robot is now, then send a new command, with a longer ttl if possible.`,
      );
    case "conflict":
      return new Refusal(
        "key-conflict",
        `Command ${result.record.seq} (${result.record.action}) already uses this idempotency key. Use a new key for each command.`,
      );
  }
}
