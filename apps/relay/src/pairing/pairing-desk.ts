/**
 * Pairing codes: made for a robot's owner, asked with by a script, answered by the owner. The script holds the
 * key for its robot from when it asked; the key counts, and the script learns where its robot is, by the yes.
 */
import type { Pairing, PairingAnswer, PairingAsked, PairingMade } from "@corridor/protocol";
import type { Logger } from "pino";
import type { Clock } from "../clock.ts";
import { hashKey, isSameHash, keyId, mintCode, mintKey } from "../keys.ts";
import { noRobot, Refusal } from "../problems.ts";
import type { Patience } from "../sessions/audience.ts";
import type { KeyRing } from "../sessions/key-ring.ts";
import { limits } from "../sessions/limits.ts";
import type { PairingStore, StoredPairing } from "../store/pairing-store.ts";
import type { SessionStore } from "../store/session-store.ts";
import { CheckQueue } from "./check-queue.ts";
import { Waits } from "./waits.ts";

const SWEEP_MS = 60_000;

export interface PairingDeskParts {
  pairings: PairingStore;
  /** says which keys count */
  sessions: Pick<SessionStore, "find">;
  clock: Clock;
  log: Logger;
}

/** A robot whose owner was let in. */
export interface OwnedRobot {
  id: string;
  keys: Pick<KeyRing, "admit">;
}

/** What a script asks with, and where from. */
export interface Asking {
  code: string;
  name: string | null;
  client: string;
  /** address, for the limits only */
  from: string;
}

export class PairingDesk {
  readonly #parts: PairingDeskParts;
  readonly #checks: CheckQueue;
  readonly #waits: Waits;
  #cancelTimer: () => void;

  constructor(parts: PairingDeskParts) {
    this.#parts = parts;
    this.#checks = new CheckQueue(parts.clock, limits.codeChecks, limits.codeChecksForAll);
    this.#waits = new Waits(parts.clock);
    this.#cancelTimer = parts.clock.after(SWEEP_MS, () => void this.#sweep());
  }

  // --- the owner ---

  /** Makes a code; an earlier one of the robot counts no more. */
  async open(robot: string): Promise<PairingMade> {
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

  /** How it stands with the robot's code; waits while nobody has used it. */
  async show(robot: string, patience: Patience): Promise<Pairing> {
    const found = await this.#waits.until(
      `robot ${robot}`,
      () => this.#find({ robot }),
      (pairing) => pairing?.state !== "open",
      patience,
    );
    if (found === null) return { state: "none", question: null, endsInSeconds: 0 };
    const { state, question, endsAt } = found;
    const shown = question && { ...question, id: keyId(question.key) };
    return {
      state,
      question: shown && { id: shown.id, name: shown.name, client: shown.client },
      endsInSeconds: this.#left(endsAt),
    };
  }

  /**
   * The owner's yes or no to one question.
   * @throws Refusal no-question when nobody asks this any more, or as `KeyRing.admit`
   */
  async reply({ id, keys }: OwnedRobot, question: string, accept: boolean): Promise<void> {
    const found = await this.#find({ robot: id });
    const key = found?.question?.key ?? "";
    const to = accept ? "accepted" : "refused";
    const isAnswered = keyId(key) === question && (await this.#settle(key, "asked", to));
    if (!isAnswered) throw nobodyAsks();
    if (accept) {
      try {
        await keys.admit(key);
      } catch (error) {
        // The owner may revoke a key, and say yes again.
        await this.#settle(key, "accepted", "asked").catch(() => false);
        throw error;
      }
    }
    this.#waits.wake();
  }

  /** Takes the code back, asked or not. */
  async remove(robot: string): Promise<void> {
    await this.#parts.pairings.remove(robot);
    this.#waits.wake();
  }

  // --- the script ---

  /**
   * Asks the owner whose page shows the code.
   * @throws Refusal no-pairing, code-used or too-fast
   */
  async ask({ code, name, client, from }: Asking): Promise<PairingAsked> {
    const hash = hashKey(code);
    const found = await this.#checks.run(from, async () => {
      const pairing = await this.#find({ code: hash });
      // Found by its hash, of which whoever guesses can choose no part, and compared as keys are.
      return pairing !== null && isSameHash(pairing.code, hash) ? pairing : null;
    });
    if (found === null) throw wrongCode();
    if (found.state !== "open") throw codeUsed();
    const key = mintKey("drive");
    const question = { key: hashKey(key), name, client };
    const now = this.#parts.clock.now();
    if (!(await this.#parts.pairings.ask(hash, question, now))) throw codeUsed();
    this.#waits.wake();
    return { key, endsInSeconds: this.#left(found.endsAt) };
  }

  /**
   * What came of the question; waits while the owner has not answered.
   * @param key that was given with the question
   * @param origin of the service as its users see it, such as https://host
   * @throws Refusal pairing-refused or no-pairing
   */
  async answerFor(key: string, origin: string, patience: Patience): Promise<PairingAnswer> {
    const hash = hashKey(key);
    const pairing = await this.#waits.until(
      `key ${hash}`,
      () => this.#answered(hash),
      (found) => found?.state !== "asked",
      patience,
    );
    if (pairing === null) throw pairingIsOver();
    if (pairing.state === "refused") throw ownerSaidNo();
    const isAccepted = pairing.state === "accepted";
    return {
      state: isAccepted ? "accepted" : "asked",
      address: isAccepted ? `${origin}/r/${pairing.robot}#${key}` : null,
      endsInSeconds: this.#left(pairing.endsAt),
    };
  }

  /** Ends what waits. */
  close(): void {
    this.#cancelTimer();
    this.#checks.close();
    this.#waits.close();
  }

  /** What was asked with a key, if anything. It is accepted once the key counts. */
  async #answered(hash: string): Promise<StoredPairing | null> {
    const found = await this.#find({ key: hash });
    if (found === null || !isSameHash(found.question?.key ?? "", hash)) return null;
    if (found.state !== "accepted") return found;
    const session = await this.#parts.sessions.find(found.robot);
    const counts = session?.keys.some((key) => key.hash === hash) === true;
    return counts ? found : { ...found, state: "asked" };
  }

  async #find(by: Parameters<PairingStore["find"]>[0]): Promise<StoredPairing | null> {
    return this.#parts.pairings.find(by, this.#parts.clock.now());
  }

  async #settle(
    key: string,
    from: StoredPairing["state"],
    to: StoredPairing["state"],
  ): Promise<boolean> {
    return this.#parts.pairings.settle(key, { from, to }, this.#parts.clock.now());
  }

  #left(endsAt: number): number {
    return Math.max(0, Math.ceil((endsAt - this.#parts.clock.now()) / 1000));
  }

  async #sweep(): Promise<void> {
    const { pairings, clock, log } = this.#parts;
    try {
      await pairings.removeEnded(clock.now());
    } catch (error) {
      log.error({ err: error }, "the sweep over the pairing codes failed");
    }
    this.#cancelTimer = clock.after(SWEEP_MS, () => void this.#sweep());
  }
}

function wrongCode(): Refusal {
  return new Refusal(
    "no-pairing",
    "No page shows this code. Check each letter; a code counts for 10 minutes, so the page may have to make a new one.",
  );
}

function codeUsed(): Refusal {
  return new Refusal("code-used", "A code is for one script. Make a new one in the robot's page.");
}

function pairingIsOver(): Refusal {
  return new Refusal(
    "no-pairing",
    "Its 10 minutes are over, or the page took it back. Make a new code in the robot's page, and ask with it.",
  );
}

function ownerSaidNo(): Refusal {
  return new Refusal(
    "pairing-refused",
    "Ask whoever has the robot's page open; with a new code you may ask again.",
  );
}

function nobodyAsks(): Refusal {
  return new Refusal(
    "no-question",
    "Nobody asks this any more: it was answered, or its 10 minutes are over.",
  );
}
