/**
 * The pairing code of one robot as its page shows it. It goes on while the panel is closed: the code is shown
 * once by the service, and a script may ask meanwhile.
 */
import type { Pairing } from "@corridor/protocol";
import { createStore, type StoreApi } from "zustand/vanilla";
import type { Ask } from "./owner-calls.ts";
import {
  lookAtPairing,
  makeCode,
  replyToPairing,
  takeBackCode,
  type Owner,
} from "./pairing-calls.ts";

/** Below the 25 s that the service allows. */
const WAIT_SECONDS = 20;
const RETRY_MS = 2_000;

export type PairingQuestion = NonNullable<Pairing["question"]>;

export type PairingView = { trouble: "failed" | "tooManyKeys" | null } & (
  | { kind: "none" | "over" }
  | { kind: "open"; code: string; endsAt: number }
  | { kind: "asked"; question: PairingQuestion; endsAt: number }
  | { kind: "accepted" | "refused"; question: PairingQuestion }
);

export interface PairingState {
  view: PairingView;
  /** where the Remote panel asks, while it is open */
  field: Element | null;
  /** whether all of that is on the screen: a panel scrolls, or lies below the stage */
  isInSight: boolean;
}

export interface PairingParts {
  owner: Owner;
  ask: Ask;
  now: () => number;
  /** does something after so many ms */
  later: (work: () => void, milliseconds: number) => void;
}

export class RobotPairing {
  readonly store: StoreApi<PairingState>;
  readonly #parts: PairingParts;
  /** what was begun last: answers to anything earlier say nothing any more */
  #turn = 0;
  /** nothing that was begun waits for its first answer */
  #isIdle = true;

  constructor(parts: PairingParts) {
    this.#parts = parts;
    this.store = createStore(() => ({
      view: { kind: "none", trouble: null },
      field: null,
      isInSight: false,
    }));
  }

  /** Shows a new code, and waits for a script that asks by it. */
  async open(): Promise<void> {
    const turn = this.#begin();
    const made = await makeCode(this.#parts.ask, this.#parts.owner);
    if (turn !== this.#turn) return;
    if (made === null) return this.#trouble("failed");
    this.#show({ kind: "open", code: made.code, endsAt: this.#endOf(made) });
    await this.#follow(turn, this.#endOf(made));
  }

  /**
   * Finds a question that came before this page was loaded anew, or waits for it: the code that was shown
   * then still counts, though the page knows it no more.
   */
  async resume(): Promise<void> {
    // What its owner has begun meanwhile goes on.
    if (!this.#isIdle || this.store.getState().view.kind !== "none") return;
    const turn = this.#begin();
    const found = await lookAtPairing(this.#parts.ask, this.#parts.owner, 0);
    if (turn !== this.#turn) return;
    this.#isIdle = true;
    if (found === null || found === "gone") return;
    if (found.state === "asked") this.#take(found);
    if (found.state === "open") await this.#follow(this.#begin(), this.#endOf(found));
  }

  /** Takes an open code back, or says no to the script that asks. */
  async decline(): Promise<void> {
    const { view } = this.store.getState();
    if (view.kind === "asked") return this.#reply(view.question, false);
    const turn = this.#begin();
    const isDone = await takeBackCode(this.#parts.ask, this.#parts.owner);
    if (turn !== this.#turn) return;
    if (isDone) this.#show({ kind: "none" });
    else this.#trouble("failed");
  }

  /** Lets the script that asks drive. */
  async accept(): Promise<void> {
    const { view } = this.store.getState();
    if (view.kind === "asked") await this.#reply(view.question, true);
  }

  /** Nobody looks any more. */
  close(): void {
    this.#begin();
  }

  async #reply(question: PairingQuestion, accept: boolean): Promise<void> {
    const turn = this.#begin();
    const { ask, owner } = this.#parts;
    const outcome = await replyToPairing(ask, owner, question.id, accept);
    if (turn !== this.#turn) return;
    if (outcome === "done") this.#show({ kind: accept ? "accepted" : "refused", question });
    else if (outcome === "over") this.#show({ kind: "over" });
    else this.#trouble(outcome);
  }

  async #follow(turn: number, endsAt: number): Promise<void> {
    const { ask, owner, now, later } = this.#parts;
    while (turn === this.#turn) {
      const found = await lookAtPairing(ask, owner, WAIT_SECONDS);
      if (turn !== this.#turn) return;
      if (found === "gone" || now() >= endsAt) return this.#show({ kind: "over" });
      if (found === null) await new Promise<void>((resolve) => later(resolve, RETRY_MS));
      else if (found.state !== "open") return this.#take(found);
    }
  }

  #take(found: Pairing): void {
    const { state, question } = found;
    if (state !== "asked" || question === null) return this.#show({ kind: "over" });
    const endsAt = this.#endOf(found);
    this.#show({ kind: "asked", question, endsAt });
    this.#parts.later(() => {
      const { view } = this.store.getState();
      const isStill = view.kind === "asked" && view.question.id === question.id;
      if (isStill) this.#show({ kind: "over" });
    }, endsAt - this.#parts.now());
  }

  #endOf({ endsInSeconds }: { endsInSeconds: number }): number {
    return this.#parts.now() + endsInSeconds * 1_000;
  }

  #begin(): number {
    this.#turn += 1;
    this.#isIdle = false;
    return this.#turn;
  }

  #trouble(trouble: "failed" | "tooManyKeys"): void {
    const { view } = this.store.getState();
    this.#isIdle = true;
    this.store.setState({ view: { ...view, trouble } });
    // What was cut short by the try goes on.
    if (view.kind === "open") void this.#follow(this.#turn, view.endsAt);
  }

  #show(view: PairingShown): void {
    this.#isIdle = true;
    this.store.setState({ view: { ...view, trouble: null } });
  }
}

type PairingShown = PairingView extends infer View
  ? View extends PairingView
    ? Omit<View, "trouble">
    : never
  : never;

let newest: { id: string; pairing: RobotPairing } | null = null;

/** The pairing of a robot, the same each time. A page has one robot; that of an earlier one ends. */
export function pairingOf(owner: Owner): RobotPairing {
  if (newest?.id === owner.id) return newest.pairing;
  newest?.pairing.close();
  const { id, ownerKey } = owner;
  const pairing = new RobotPairing({
    owner: { id, ownerKey },
    ask: fetch,
    now: () => performance.now(),
    later: (work, milliseconds) => setTimeout(work, milliseconds),
  });
  newest = { id, pairing };
  return pairing;
}
