/**
 * A page that hosts the robot, like its worker: host, link, run and driver, with the tab's storage.
 */
import type { Platform } from "../../../../../packages/client/src/platform.ts";
import type { SocketEvents, SocketPort } from "@corridor/protocol";
import {
  RemoteDriver,
  type RemoteDriverEvents,
} from "../../../../web/src/simulator/drivers/remote-driver.ts";
import { firstMaze, firstProgram } from "../../../../web/src/simulator/protocol/first-project.ts";
import { RemoteHost } from "../../../../web/src/simulator/worker/remote-host.ts";
import { RunLoop } from "../../../../web/src/simulator/worker/run-loop.ts";
import type { RemoteSession } from "../../../../web/src/simulator/protocol/worker-messages.ts";
import type { VirtualTime } from "./virtual-time.ts";

const noop = (): void => undefined;
const INTERVAL_MS = 16;
const SNAPSHOT_MS = 250;

/** What a tab retains across reloads. */
export interface Tab {
  session: RemoteSession;
}

export interface PageOptions {
  tab: Tab;
  time: VirtualTime;
  platform: Omit<Platform, "uniqueText">;
  did(seq: number, what: "started" | Parameters<RemoteDriverEvents["ended"]>[1]["state"]): void;
}

export class FaultyPage {
  readonly #options: PageOptions;
  readonly #loop: RunLoop;
  readonly #host: RemoteHost;
  /** resolves when it starts to open its first connection */
  readonly opening: Promise<void>;
  #opened: () => void = () => undefined;
  #isAlive = true;
  #socket: SocketPort | null = null;
  #shownAt = 0;
  #thawsAt = 0;
  /** events that arrived while it was frozen */
  #queued: (() => void)[] = [];

  constructor(options: PageOptions) {
    this.#options = options;
    const { tab, time, platform } = options;
    const events: RemoteDriverEvents = {
      started: (seq) => {
        options.did(seq, "started");
        this.#host.started(seq);
      },
      ended: (seq, ending) => {
        options.did(seq, ending.state);
        this.#host.ended(seq, ending);
      },
    };
    this.#loop = new RunLoop(firstMaze, firstProgram, () => time.now());
    this.#loop.connect((robot) => new RemoteDriver(events, robot, () => time.now()));
    this.#host = new RemoteHost({
      origin: "http://robots.example",
      now: () => time.now(),
      snapshot: () => this.#loop.snapshot(),
      onView: ({ session }) => {
        if (this.#isAlive && session !== null) tab.session = session;
      },
      onDelivery: (delivery) => this.#loop.accept(delivery),
      cancel: (reason) => this.#loop.cancelRemote(reason),
      cancelOne: (seq) => this.#loop.remote?.cancelOne(seq),
      reset: () => this.#loop.remote?.reset(),
      renew: (alive) => this.#loop.remote?.renew(alive),
      fetch: () => Promise.reject(new Error("A session is there already.")),
      platform: { ...platform, connect: (url, events) => this.#connect(url, events) },
    });
    this.opening = new Promise((resolve) => {
      this.#opened = resolve;
    });
    this.#loop.setDriver("remote");
    this.#host.open(tab.session, true);
    // The connection module loads asynchronously.
    void time.during(() => this.opening);
    this.#turn();
  }

  /**
   * Closes the tab at any point of its work.
   * @param isClosed the browser closes the connection
   */
  leave(isClosed = false): void {
    this.#isAlive = false;
    if (isClosed) this.#socket?.close(1001, "");
  }

  /** Freezes the page. Events that arrive meanwhile are queued and handled first. */
  freeze(ms: number): void {
    this.#thawsAt = Math.max(this.#thawsAt, this.#options.time.now() + ms);
  }

  get isAlive(): boolean {
    return this.#isAlive;
  }

  /** Events for a closed page are discarded. */
  #connect(url: string, events: SocketEvents): SocketPort {
    this.#opened();
    if (!this.#isAlive) return { send: noop, close: noop, isOpen: false, waitingBytes: 0 };
    const ifAlive = (notify: () => void): void => {
      if (this.#options.time.now() < this.#thawsAt) this.#queued.push(() => ifAlive(notify));
      else if (this.#isAlive) notify();
    };
    this.#socket = this.#options.platform.connect(url, {
      opened: () => ifAlive(() => events.opened()),
      received: (text) => ifAlive(() => events.received(text)),
      closed: (code) => ifAlive(() => events.closed(code)),
    });
    return this.#socket;
  }

  #turn(): void {
    if (!this.#isAlive) return;
    const { time } = this.#options;
    if (time.now() < this.#thawsAt) {
      time.after(this.#thawsAt - time.now(), () => this.#turn());
      return;
    }
    const queued = this.#queued;
    this.#queued = [];
    for (const deliver of queued) deliver();
    this.#loop.advance();
    this.#loop.updates.take();
    this.#loop.updates.takeTimeline();
    if (this.#host.isOpen && time.now() - this.#shownAt >= SNAPSHOT_MS) {
      this.#shownAt = time.now();
      this.#host.sendSnapshot(this.#loop.snapshot());
    }
    time.after(INTERVAL_MS, () => this.#turn());
  }
}
