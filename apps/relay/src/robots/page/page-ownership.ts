/**
 * Ownership of the robot: the page that acquired it last, here or at another relay, or the time
 * since which no page owns it.
 */
import type { CloseReason, RelayToPage } from "@corridor/protocol";

/** The connection of a robot's page, as the robot uses it. */
export interface PageConnection {
  /** false once the page disconnected or was closed */
  readonly isOpen: boolean;
  /** Sends the messages together, in order. */
  send(...messages: RelayToPage[]): void;
  close(reason: CloseReason): void;
}

export interface OwningPage {
  connection: PageConnection;
  epoch: number;
  /** identifies the page across its connections; empty if the page sends none */
  name: string;
  /** it was asked to release the robot, and must not receive commands */
  isReleasing: boolean;
}

export class PageOwnership {
  #page: OwningPage | null = null;
  /** epoch of the page at another relay; null: none */
  #elsewhere: number | null = null;
  /** highest known epoch */
  #epoch: number;
  /** name of the page with that epoch; empty if unknown */
  #name: string;
  /** whether the last page may have started more than it reported */
  #isInDoubt: boolean;
  /**
   * time since which no page owns the robot; also null once the last page's commands have been
   * ended
   */
  #disconnectedAt: number | null;

  /**
   * @param now a robot without a page counts as disconnected from this time on
   * @param last the page that owned the robot last; epoch 0: none
   */
  constructor(now: number, last: { epoch: number; page: string }) {
    this.#disconnectedAt = now;
    this.#epoch = last.epoch;
    this.#name = last.page;
    this.#isInDoubt = last.epoch > 0;
  }

  get page(): OwningPage | null {
    return this.#page;
  }

  /** Epoch of the page that acquired the robot last, as far as known. */
  get epoch(): number {
    return this.#epoch;
  }

  /** Name of the same page; empty if unknown. */
  get name(): string {
    return this.#name;
  }

  get isElsewhere(): boolean {
    return this.#elsewhere !== null;
  }

  /** Whether a page owns the robot, here or at another relay. */
  get isOwned(): boolean {
    return this.#page !== null || this.isElsewhere;
  }

  /** Whether work is due once the page has been disconnected for long enough. */
  get awaitsPage(): boolean {
    return this.#disconnectedAt !== null;
  }

  /** Whether no page owns the robot, and the last one may have started more than it reported. */
  get isInDoubt(): boolean {
    return this.#isInDoubt;
  }

  isHeldBy(connection: PageConnection): boolean {
    return this.#page?.connection === connection;
  }

  disconnectedMs(now: number): number {
    return this.#disconnectedAt === null ? 0 : now - this.#disconnectedAt;
  }

  take(page: Omit<OwningPage, "isReleasing">): void {
    this.#page = { ...page, isReleasing: false };
    this.#epoch = page.epoch;
    this.#name = page.name;
    this.#elsewhere = null;
    this.#isInDoubt = false;
    this.#disconnectedAt = null;
  }

  /**
   * A page has acquired the robot at another relay.
   * @returns the page that owned the robot at this relay until then, if any
   */
  acquireElsewhere(epoch: number, name: string): OwningPage | null {
    if (epoch < this.#epoch) return null;
    const before = this.#page;
    this.#page = null;
    this.#epoch = epoch;
    this.#name = name;
    this.#elsewhere = epoch;
    this.#isInDoubt = false;
    this.#disconnectedAt = null;
    return before;
  }

  /** The page at another relay disconnected. @returns false if it was not the newest */
  leaveElsewhere(epoch: number, now: number, closedByPage: boolean): boolean {
    if (this.#elsewhere !== epoch) return false;
    this.#isInDoubt = !closedByPage;
    this.#elsewhere = null;
    this.#disconnectedAt = now;
    return true;
  }

  leave(now: number, closedByPage: boolean): void {
    this.#isInDoubt = !closedByPage;
    this.#page = null;
    this.#disconnectedAt = now;
  }

  /** The commands of the disconnected page have been ended. */
  settleDisconnected(): void {
    this.#disconnectedAt = null;
  }

  /** Removes the page. No work is due any more. */
  clear(): void {
    this.#page = null;
    this.#disconnectedAt = null;
  }
}
