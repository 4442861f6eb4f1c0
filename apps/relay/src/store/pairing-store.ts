/**
 * What the relay keeps of pairing codes: at most one for each robot, as a hash, with the script that asked by
 * it. A row goes with its robot, with the next code, when it is taken back, and when its time is over.
 *
 * Each method is one atomic step, so that several relays can share a store: of two scripts that come with one
 * code one has it, of two answers the first counts. Every implementation passes `testing/pairing-store.cases.ts`.
 */
export interface NewPairing {
  robot: string;
  /** SHA-256 of the code */
  code: string;
  endsAt: number;
}

/** Who asks. */
export interface PairingQuestion {
  /** SHA-256 of the key that the script gets by a yes */
  key: string;
  /** as it calls itself */
  name: string | null;
  /** its language */
  client: string;
}

export interface StoredPairing extends NewPairing {
  /** open: nobody has used the code yet */
  state: "open" | "asked" | "accepted" | "refused";
  question: PairingQuestion | null;
}

export type PairingFinder =
  | { robot: string }
  | { /** hash */ code: string }
  | { /** hash */ key: string };

export interface PairingStore {
  /**
   * Makes a code count, in place of an earlier one of the robot.
   * @returns taken: another robot has the same code; no-robot: there is none to pair with
   */
  open(pairing: NewPairing): Promise<"opened" | "taken" | "no-robot">;
  /** What still counts. */
  find(by: PairingFinder, now: number): Promise<StoredPairing | null>;
  /** open → asked. @returns false when the code does not count, or was used */
  ask(code: string, question: PairingQuestion, now: number): Promise<boolean>;
  /**
   * From one state to another, for the question with this key alone.
   * @returns false when it is not in that state
   */
  settle(
    key: string,
    change: { from: StoredPairing["state"]; to: StoredPairing["state"] },
    now: number,
  ): Promise<boolean>;
  /** Forgets the robot's code. @returns false when there was none */
  remove(robot: string): Promise<boolean>;
  /** Forgets what counts no more. @returns how many */
  removeEnded(now: number): Promise<number>;
}
