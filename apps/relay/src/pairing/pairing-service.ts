/**
 * Pairing codes: a code is created for a robot's owner, a script requests access with it, and the
 * owner accepts or declines. The script receives its key with the request. The key is valid, and
 * the script receives the robot's address, once the owner accepts.
 */
import type { Pairing, PairingAnswer, RequestedPairing, CreatedPairing } from "@corridor/protocol";
import type { Logger } from "pino";
import type { Clock } from "../platform/time/clock.ts";
import { hashKey, isSameHash, keyId, mintCode, mintKey } from "../platform/keys.ts";
import { noRobot, Refusal } from "../platform/errors/problems.ts";
import type { WaitLimit } from "../platform/time/wait-limit.ts";
import { limits } from "../platform/limits/limits.ts";
import type {
  PairingFinder,
  PairingStore,
  PairingTransition,
  StoredPairing,
} from "../store/pairing-store.ts";
import type { RobotStore } from "../store/robot-store.ts";
import { CheckQueue } from "../platform/limits/check-queue.ts";
import { Waits } from "./waits.ts";

const CLEANUP_MS = 60_000;

export interface PairingServiceParts {
  pairings: PairingStore;
  /** provides the valid keys */
  robots: Pick<RobotStore, "find">;
  clock: Clock;
  log: Logger;
}

/** A robot whose owner is authenticated. */
export interface OwnedRobot {
  id: string;
  keys: {
    /** Activates a key that a script has held since it requested access. */
    admit(hash: string): Promise<void>;
  };
}

/** A script's request for access. */
export interface AccessRequest {
  code: string;
  name: string | null;
  client: string;
  /** client address, for the limits only */
  from: string;
}

export class PairingService {
  readonly #parts: PairingServiceParts;
  readonly #checks: CheckQueue;
  readonly #waits: Waits;
  #cancelTimer: () => void;
  #isClosed = false;

  constructor(parts: PairingServiceParts) {
    this.#parts = parts;
    this.#checks = new CheckQueue(parts.clock, limits.codeChecks, limits.codeChecksForAll);
    this.#waits = new Waits(parts.clock);
    this.#cancelTimer = parts.clock.after(CLEANUP_MS, () => void this.#removeEnded());
  }

  // --- the owner ---

  /** Creates a code and invalidates the previous one of the robot. */
  async open(robot: string): Promise<CreatedPairing> {
    const { pairings, clock } = this.#parts;
    await pairings.remove(robot);
    const endsAt = clock.now() + limits.pairingMs;
    for (;;) {
      const code = mintCode();
      const outcome = await pairings.open({ robot, code: hashKey(code), endsAt });
      if (outcome === "no-robot") throw noRobot();
      if (outcome === "taken") continue;
      this.#waits.wake();
      return { code, endsInSeconds: this.#left(endsAt) };
    }
  }

  /** State of the robot's code. Waits while no script has used it. */
  async show(robot: string, waitLimit: WaitLimit): Promise<Pairing> {
    const found = await this.#waits.until(
      `robot ${robot}`,
      () => this.#find({ robot }),
      (pairing) => pairing?.state !== "open",
      waitLimit,
    );
    if (found === null) return { state: "none", question: null, endsInSeconds: 0 };
    const { state, question, endsAt } = found;
    const withId = question && { ...question, id: keyId(question.key) };
    return {
      state,
      question: withId && { id: withId.id, name: withId.name, client: withId.client },
      endsInSeconds: this.#left(endsAt),
    };
  }

  /**
   * Stores the owner's answer to one request. The same answer again changes nothing, because pages
   * and browsers repeat a request whose response was lost.
   * @throws Refusal no-question if the request is no longer open, or the errors of `keys.admit`
   */
  async reply({ id, keys }: OwnedRobot, question: string, accept: boolean): Promise<void> {
    const found = await this.#find({ robot: id });
    const key = found?.question?.key ?? "";
    if (keyId(key) !== question) throw requestClosed();
    const to = accept ? "accepted" : "refused";
    if (found?.state === to) return;
    if (!(await this.#transition({ key }, { from: "asked", to }))) throw requestClosed();
    if (accept) {
      try {
        await keys.admit(key);
      } catch (error) {
        // Reopens the request, so that the owner can revoke a key and accept again.
        await this.#transition({ key }, { from: "accepted", to: "asked" }).catch(() => false);
        throw error;
      }
    }
    this.#waits.wake();
  }

  /** Revokes the code, used or unused. */
  async remove(robot: string): Promise<void> {
    await this.#parts.pairings.remove(robot);
    this.#waits.wake();
  }

  // --- the script ---

  /**
   * Requests access from the owner whose page displays the code.
   * @throws Refusal no-pairing, code-used or too-fast
   */
  async ask({ code, name, client, from }: AccessRequest): Promise<RequestedPairing> {
    const hash = hashKey(code);
    const found = await this.#checks.run(from, hash, async () => {
      const pairing = await this.#find({ code: hash });
      // The lookup uses a hash that a guesser cannot control. The comparison takes constant time.
      return pairing !== null && isSameHash(pairing.code, hash) ? pairing : null;
    });
    if (found === null) throw wrongCode();
    if (found.state !== "open") throw codeUsed();
    const key = mintKey("drive");
    const question = { key: hashKey(key), name, client };
    const asked = { from: "open", to: "asked", question } as const;
    if (!(await this.#transition({ code: hash }, asked))) throw codeUsed();
    this.#waits.wake();
    return { key, endsInSeconds: this.#left(found.endsAt) };
  }

  /**
   * State of a script's request. Waits while the owner has not answered.
   * @param key from the response to the request
   * @param origin of the service as its users see it, such as https://host
   * @throws Refusal pairing-refused or no-pairing
   */
  async answerFor(key: string, origin: string, waitLimit: WaitLimit): Promise<PairingAnswer> {
    const hash = hashKey(key);
    const pairing = await this.#waits.until(
      `key ${hash}`,
      () => this.#answered(hash),
      (found) => found?.state !== "asked",
      waitLimit,
    );
    if (pairing === null) throw pairingEnded();
    if (pairing.state === "refused") throw ownerDeclined();
    const isAccepted = pairing.state === "accepted";
    return {
      state: isAccepted ? "accepted" : "asked",
      address: isAccepted ? `${origin}/r/${pairing.robot}#${key}` : null,
      endsInSeconds: this.#left(pairing.endsAt),
    };
  }

  /** Ends all waiting requests. */
  close(): void {
    this.#isClosed = true;
    this.#cancelTimer();
    this.#checks.close();
    this.#waits.close();
  }

  /** The request of a key, if any. Its state is accepted only once the key is valid. */
  async #answered(hash: string): Promise<StoredPairing | null> {
    const found = await this.#find({ key: hash });
    if (found === null || !isSameHash(found.question?.key ?? "", hash)) return null;
    if (found.state !== "accepted") return found;
    const robot = await this.#parts.robots.find(found.robot);
    const isValid = robot?.keys.some((key) => key.hash === hash) === true;
    return isValid ? found : { ...found, state: "asked" };
  }

  async #find(by: PairingFinder): Promise<StoredPairing | null> {
    return this.#parts.pairings.find(by, this.#parts.clock.now());
  }

  async #transition(by: PairingFinder, transition: PairingTransition): Promise<boolean> {
    return this.#parts.pairings.transition(by, transition, this.#parts.clock.now());
  }

  #left(endsAt: number): number {
    return Math.max(0, Math.ceil((endsAt - this.#parts.clock.now()) / 1000));
  }

  async #removeEnded(): Promise<void> {
    const { pairings, clock, log } = this.#parts;
    try {
      await pairings.removeEnded(clock.now());
    } catch (error) {
      log.error({ err: error }, "deleting expired pairing codes failed");
    }
    if (this.#isClosed) return;
    this.#cancelTimer = clock.after(CLEANUP_MS, () => void this.#removeEnded());
  }
}

function wrongCode(): Refusal {
  return new Refusal(
    "no-pairing",
    "No page displays this code. Check each letter. A code expires after 10 minutes, so you may need a new one.",
  );
}

function codeUsed(): Refusal {
  return new Refusal(
    "code-used",
    "Each code is for one script. Create a new one on the robot's page.",
  );
}

function pairingEnded(): Refusal {
  return new Refusal(
    "no-pairing",
    "The code has expired or was revoked. Create a new code on the robot's page, and pair again.",
  );
}

function ownerDeclined(): Refusal {
  return new Refusal(
    "pairing-refused",
    "The robot's owner declined this script. Ask the owner for a new code, then pair again.",
  );
}

function requestClosed(): Refusal {
  return new Refusal(
    "no-question",
    "No pairing request has this id: it was answered or has expired. Create a new code, then pair the script again.",
  );
}
