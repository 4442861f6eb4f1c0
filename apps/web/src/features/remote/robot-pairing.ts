/**
 * The pairing code of one robot. It continues while the panel is closed: the service returns a code
 * only once, and a script may use it meanwhile.
 */
import type { Pairing } from "@corridor/protocol";
import { createStore, type StoreApi } from "zustand/vanilla";
import type { Ask } from "./owner-calls.ts";
import {
  lookAtPairing,
  makeCode,
  replyToPairing,
  cancelCode,
  type Owner,
} from "./pairing-calls.ts";

/** Seconds, below the 25 s that the service allows. */
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
  /** the element of the Remote panel that displays the question, while the panel is open */
  field: Element | null;
  /** whether that element is in view: a panel scrolls, or lies below the stage */
  isInSight: boolean;
}

export interface PairingParts {
  owner: Owner;
  ask: Ask;
  now: () => number;
  /** calls `work` after a delay */
  later: (work: () => void, milliseconds: number) => void;
}

export class RobotPairing {
  readonly store: StoreApi<PairingState>;
  readonly #parts: PairingParts;
  /** number of the newest operation: responses to earlier ones are ignored */
  #turn = 0;
  /** whether no operation waits for its first response */
  #isIdle = true;

  constructor(parts: PairingParts) {
    this.#parts = parts;
    this.store = createStore(() => ({
      view: { kind: "none", trouble: null },
      field: null,
      isInSight: false,
    }));
  }

  /** Creates a code, and waits for a script that uses it. */
  async open(): Promise<void> {
    const turn = this.#begin();
    const made = await makeCode(this.#parts.ask, this.#parts.owner);
    if (turn !== this.#turn) return;
    if (made === null) return this.#trouble("failed");
    this.#show({ kind: "open", code: made.code, endsAt: this.#endOf(made) });
    await this.#follow(turn, this.#endOf(made));
  }

  /**
   * After a reload, finds a pending question or waits for one. The earlier code is still valid,
   * though the page no longer knows it.
   */
  async resume(): Promise<void> {
    // An operation that the owner has started continues.
    if (!this.#isIdle || this.store.getState().view.kind !== "none") return;
    const turn = this.#begin();
    const found = await lookAtPairing(this.#parts.ask, this.#parts.owner, 0);
    if (turn !== this.#turn) return;
    this.#isIdle = true;
    if (found === null || found === "gone") return;
    if (found.state === "asked") this.#take(found);
    if (found.state === "open") await this.#follow(this.#begin(), this.#endOf(found));
  }

  /** Deletes an open code, or declines the script that asks. */
  async decline(): Promise<void> {
    const { view } = this.store.getState();
    if (view.kind === "asked") return this.#reply(view.question, false);
    const turn = this.#begin();
    const isDone = await cancelCode(this.#parts.ask, this.#parts.owner);
    if (turn !== this.#turn) return;
    if (isDone) this.#show({ kind: "none" });
    else this.#trouble("failed");
  }

  /** Accepts the script that asks. */
  async accept(): Promise<void> {
    const { view } = this.store.getState();
    if (view.kind === "asked") await this.#reply(view.question, true);
  }

  /** Ends the pairing: responses to earlier operations are ignored. */
  close(): void {
    this.#begin();
  }

  async #reply(question: PairingQuestion, accept: boolean): Promise<void> {
    // A double click sends one answer.
    if (!this.#isIdle) return;
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
    // The failed operation interrupted the wait for a script, which continues here.
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

/**
 * The pairing of a robot, the same object on each call. A page has one robot: the pairing of an
 * earlier robot ends.
 */
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
