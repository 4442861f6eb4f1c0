/**
 * Storage of pairing codes: at most one for each robot, as a hash, with the script that used it. A
 * row is deleted with its robot, by the next code, when it is revoked, and when it expires.
 *
 * Each method is one atomic step, so that several relays can share a store. If two scripts use the
 * same code, one succeeds. If there are two answers, the first counts. A store checks the state that
 * a transition starts from, and knows no order of states. Every implementation passes
 * `cases/pairing-store.cases.ts`.
 */
export interface NewPairing {
  robot: string;
  /** SHA-256 of the code */
  code: string;
  endsAt: number;
}

/** The script that requests access. */
export interface PairingQuestion {
  /** SHA-256 of the key that becomes valid if the owner accepts */
  key: string;
  /** the script's name for itself */
  name: string | null;
  /** the script's language */
  client: string;
}

/** open: no script has used the code yet */
export type PairingState = "open" | "asked" | "accepted" | "refused";

export interface StoredPairing extends NewPairing {
  state: PairingState;
  question: PairingQuestion | null;
}

/** A transition, as the caller decides it. */
export interface PairingTransition {
  from: PairingState;
  to: PairingState;
  /** the script that requests access; default: unchanged */
  question?: PairingQuestion;
}

export type PairingFinder =
  | { robot: string }
  | { /** hash */ code: string }
  | { /** hash */ key: string };

export interface PairingStore {
  /**
   * Stores a code in place of the robot's previous one.
   * @returns taken: another robot has the same code; no-robot: the robot does not exist
   */
  open(pairing: NewPairing): Promise<"opened" | "taken" | "no-robot">;
  /** The pairing, unless it has expired. */
  find(by: PairingFinder, now: number): Promise<StoredPairing | null>;
  /**
   * Changes the pairing. @returns false if it is unknown, has expired or is not in the state `from`
   */
  transition(by: PairingFinder, transition: PairingTransition, now: number): Promise<boolean>;
  /** Deletes the robot's code. @returns false if there was none */
  remove(robot: string): Promise<boolean>;
  /** Deletes expired codes. @returns how many */
  removeEnded(now: number): Promise<number>;
}
