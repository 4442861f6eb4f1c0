/**
 * One robot at this relay: permissions, reports of its page, and expiry. `command-life.ts` implements
 * the lifecycle of its commands. Independent of WebSocket and HTTP.
 */
import {
  closeReasons,
  hasEnded,
  ABSENT_ROBOT_REASON,
  SILENT_ROBOT_REASON,
  type CommandRecord,
  type CommandTerms,
  type PageToRelay,
  type Resume,
  type ScriptView,
} from "@corridor/protocol";
import type { Clock } from "../platform/time/clock.ts";
import type { CoalescedTimers } from "../platform/time/coalesced-timers.ts";
import type { Bus } from "../bus/bus.ts";
import type { RobotStore, StoredKey, StoredScript, StoredRobot } from "../store/port.ts";
import { Subscribers, type CallerWait } from "./readers/subscribers.ts";
import { CarriedSnapshot } from "../bus/carried-snapshot.ts";
import { CommandLife } from "./delivery/command-life.ts";
import { Presence } from "./presence/presence.ts";
import { EventLog } from "./readers/event-log.ts";
import { KeyRing } from "./access/key-ring.ts";
import { limits } from "../platform/limits/limits.ts";
import { MazeBoard } from "./maze-board.ts";
import { OtherRelays } from "./other-relays.ts";
import { PageOwnership, type PageLink } from "./page/page-ownership.ts";
import type { ReaderSource } from "./readers/feed.ts";
import { Readers } from "./readers/readers.ts";
import { RobotChannel } from "./presence/robot-channel.ts";
import { RobotView } from "./robot-view.ts";
import { RightsVersion, type Verb, type Caller } from "./access/caller.ts";
import { ScriptClocks } from "./delivery/script-clocks.ts";
import { ScriptAccess } from "./access/script-access.ts";
import { RobotUse } from "./robot-use.ts";
import type { CommandObserver } from "./delivery/command-observer.ts";

export interface RobotParts {
  store: RobotStore;
  clock: Clock;
  /** shared by all robots */
  timers: CoalescedTimers;
  observer: CommandObserver;
  bus: Bus;
  /** called when another relay has deleted the robot */
  deleted: () => void;
}

export class Robot {
  readonly id: string;
  readonly createdAt: number;
  readonly presence: Presence;
  readonly keys: KeyRing;
  readonly scriptAccess: ScriptAccess;
  /** version for which the result of a check stays valid */
  readonly rights = new RightsVersion();
  readonly mazes: MazeBoard;
  readonly readers: Readers;
  /** clocks of the scripts that send single requests */
  readonly scriptClocks = new ScriptClocks();
  readonly #clock: Clock;
  readonly #view = new RobotView();
  readonly #events: EventLog;
  readonly #subscribers: Subscribers;
  readonly #ownership: PageOwnership;
  readonly #life: CommandLife;
  readonly #channel: RobotChannel;
  readonly #others: OtherRelays;
  readonly #use: RobotUse;
  #isOver = false;

  private constructor(stored: StoredRobot, parts: RobotParts) {
    const { store, clock, timers, observer } = parts;
    this.id = stored.id;
    this.createdAt = stored.createdAt;
    this.#clock = clock;
    this.#events = new EventLog(clock);
    const subscribers = new Subscribers(clock, this.#events);
    const ownership = new PageOwnership(clock.now(), stored);
    const channel = new RobotChannel(clock, timers);
    this.#subscribers = subscribers;
    this.#ownership = ownership;
    this.#channel = channel;
    const shared = { store, clock, timers, observer };
    this.#life = new CommandLife({ ...shared, robot: this.id, subscribers, ownership, channel });
    this.keys = new KeyRing({
      robot: this.id,
      rights: this.rights,
      keys: stored.keys,
      store,
      clock,
      change: (change) => this.#life.recall.changeKeys(change),
      changed: () => channel.rightsChanged(),
      found: (found) => {
        this.scriptAccess.apply(found);
        this.presence.blockedChanged();
      },
      revoked: (key) => this.#revoked(key),
      doubted: () => subscribers.dismiss(({ kind }) => kind !== "own", "busy"),
    });
    this.#use = new RobotUse(stored, { store, clock, keys: this.keys });
    this.scriptAccess = new ScriptAccess({
      robot: this.id,
      rights: this.rights,
      stored,
      store,
      change: (change) => this.#life.recall.changeBlocked(change),
      pause: async (isPaused) => this.#life.recall.pause(isPaused),
      changed: () => {
        channel.rightsChanged();
        this.presence.blockedChanged();
      },
      blocked: (script) => this.#blocked(script),
      paused: () => this.#askToEnd(),
    });
    this.mazes = new MazeBoard({
      robot: this.id,
      store,
      clock,
      notify: (version) => subscribers.publishMaze(version),
      changed: (version) => channel.mazeChanged(version),
    });
    const notify = (): void => this.#notifyScripts();
    this.presence = new Presence(clock, notify, () => this.scriptAccess.blocked);
    const source: ReaderSource = {
      events: this.#events,
      newest: () => this.newest,
      readOpen: (toReader) => this.#life.log.readOpen(toReader),
    };
    this.readers = new Readers({ clock, timers, subscribers, source, presence: this.presence });
    this.#others = new OtherRelays({
      clock,
      ownership,
      view: this.#view,
      channel,
      life: this.#life,
      keys: this.keys,
      mazes: this.mazes,
      presence: this.presence,
      lapsed: (link) => {
        link.close(closeReasons.restart);
        this.leavePage(link, false);
      },
      notifyReaders: () => this.#notifyReaders(),
      notifyScripts: notify,
      over: () => {
        if (this.isOver) return;
        parts.deleted();
        this.close("over");
      },
    });
  }

  /** Loads a robot into memory and subscribes to its channel. */
  static async open(stored: StoredRobot, parts: RobotParts): Promise<Robot> {
    const robot = new Robot(stored, parts);
    await robot.#channel.open(parts.bus, stored.id, {
      stepped: (step, isOwn) => robot.#life.receivedStep(step, isOwn),
      missed: () => robot.missedMessages(),
      received: (message) => robot.#others.received(message),
    });
    await robot.#others.meet();
    return robot;
  }

  /** The stored key that matches a bearer key; null if none matches, or the robot has ended. */
  grantOf(key: string): StoredKey | null {
    if (this.isOver) return null;
    const grant = this.keys.match(key);
    if (grant !== null) this.#use.used();
    return grant;
  }

  get isOver(): boolean {
    return this.#isOver;
  }

  get lastUsedAt(): number {
    return this.#use.lastAt;
  }

  /** Milliseconds until the robot reaches its maximum lifetime. */
  get leftMs(): number {
    return Math.max(0, this.createdAt + limits.robotLifeMs - this.#clock.now());
  }

  get hasPage(): boolean {
    return this.#ownership.page !== null;
  }

  /**
   * Scripts by name, at all relays that this one knows of: connected, recently active or blocked.
   */
  get scripts(): ScriptView[] {
    return this.#channel.withOthers(this.presence.report()).scripts;
  }

  get newest(): CarriedSnapshot | null {
    return this.#view.newest;
  }

  /**
   * Whether the robot is unused, has no pending work and can leave memory. If its page reported
   * here, it stays until it expires, because nothing else holds the newest snapshot.
   */
  get isQuiet(): boolean {
    const isUnused = this.#clock.now() - this.lastUsedAt > limits.touchMs;
    const isAlone = !this.hasPage && this.#subscribers.isEmpty;
    const isHeldElsewhere = this.#ownership.isElsewhere || this.newest === null;
    return isUnused && isAlone && !this.#ownership.isAwayOpen && isHeldElsewhere;
  }

  // --- the page ---

  /** A page acquires the robot. The previous page is disconnected. */
  async acquirePage(link: PageLink, resume: Resume): Promise<void> {
    await this.#life.acquirePage(link, resume, () => {
      this.#use.used();
      const now = this.#clock.now();
      this.#view.pageConnected(now, this.#ownership.epoch > 1 ? now - this.createdAt : 0);
      // Before the endings in the same message, so that readers of an ending see no older snapshot.
      if (resume.snapshot !== undefined) this.#show(CarriedSnapshot.of(resume.snapshot));
      this.#notifyScripts();
      // The page disconnected before it owned the robot, when `leavePage` had no effect yet.
      if (!link.isOpen) this.leavePage(link, false);
    });
  }

  /**
   * The page's connection is closed. No effect if another page owns the robot.
   * @param closedByPage whether the page closed it, after all of its reports
   */
  leavePage(link: PageLink, closedByPage: boolean): void {
    if (!this.#ownership.isHeldBy(link)) return;
    this.#ownership.leave(this.#clock.now(), closedByPage);
    this.#life.handover.left(this.#ownership.epoch, closedByPage);
    this.#view.pageLeft();
    this.#publishSnapshot();
    this.#channel.pageLeft(this.#ownership.epoch, closedByPage);
  }

  /**
   * Handles a snapshot of the page. The check of the page's permission already recorded the use.
   */
  receiveSnapshot(link: PageLink, epoch: number, snapshot: CarriedSnapshot): void {
    if (this.#isCurrent(link, epoch)) this.#show(snapshot);
  }

  /**
   * Handles a message of the page. Ignores messages of a replaced page. Disconnects a page that
   * sends another epoch.
   */
  receiveFromPage(link: PageLink, message: PageToRelay): Promise<void> | undefined {
    if (!this.#isCurrent(link, message.epoch)) return undefined;
    this.#use.used();
    switch (message.type) {
      case "snapshot":
        this.#show(CarriedSnapshot.of(message.snapshot));
        return undefined;
      case "time":
        link.send({ type: "time", at: this.#clock.now() });
        return undefined;
      case "ended":
        this.#channel.flush();
        return this.#life.receiveFromPage(link, message);
      case "started":
      case "yielded":
        return this.#life.receiveFromPage(link, message);
    }
  }

  /**
   * Whether the page owns the robot with this epoch. Disconnects a page that sends another epoch.
   */
  #isCurrent(link: PageLink, epoch: number): boolean {
    if (!this.#ownership.isHeldBy(link)) return false;
    if (epoch !== this.#ownership.page?.epoch) {
      link.close(closeReasons.replaced);
      return false;
    }
    return true;
  }

  // --- scripts ---

  /**
   * Checks the permissions of a caller. Callers may reuse the result while `rights` is unchanged.
   * @throws Refusal if the key is revoked or lacks the permission, or the script is blocked;
   * StoreUnavailableError if it is unknown whether the key is still valid
   */
  check(caller: Caller, verb: Verb): void {
    this.keys.check(caller, verb);
    this.scriptAccess.check(caller);
    this.#use.used();
  }

  /** Stores a command and delivers it in its turn: see `CommandIntake.submit`. */
  async submit(
    caller: Caller,
    request: { key: string | null } & CommandTerms,
    acknowledge: (record: CommandRecord) => void,
  ): Promise<void> {
    await this.#life.intake.submit(caller, request, (record) => {
      if (caller.script !== null) this.presence.sent(caller.script, record);
      acknowledge(record);
    });
  }

  /** Recalls one command: see `CommandRecall.one`. */
  async cancel(grant: StoredKey, seq: number): Promise<CommandRecord> {
    return this.#life.recall.one(grant, seq);
  }

  async commandsAfter(seq: number): Promise<CommandRecord[]> {
    return this.#life.log.after(seq);
  }

  /**
   * Waits for the command to end.
   * @returns its record after the wait. If it has not ended and the robot is gone or paused,
   * `reason` names what to check.
   */
  async endOf(seq: number, waitLimit: CallerWait): Promise<CommandRecord> {
    const record = await this.#life.log.endOf(seq, waitLimit);
    const hasWaited = waitLimit.milliseconds > 0;
    if (!hasWaited || hasEnded(record.state) || this.#view.isAwake) return record;
    return {
      ...record,
      reason: this.#ownership.isOwned ? SILENT_ROBOT_REASON : ABSENT_ROBOT_REASON,
    };
  }

  /** Records a message of a script on its connection. */
  spoke({ script }: Caller): void {
    this.#use.used();
    if (script !== null) this.presence.spoke(script);
  }

  /** Records a request of a script. @returns function to call once the request is answered */
  received({ script }: Caller): () => void {
    this.#use.used();
    return script === null ? () => undefined : this.presence.received(script);
  }

  // --- time and end ---

  /** Called about once a second. Detects pages that are asleep or gone for good. */
  async checkLife(): Promise<void> {
    const now = this.#clock.now();
    this.rights.changed();
    this.#events.deleteOld();
    if (this.hasPage && this.#view.checkAsleep(now)) this.#publishSnapshot();
    if (this.#ownership.isElsewhere) this.#channel.repeatAnnouncement(this.presence.report());
    if (this.#ownership.disconnectedMs(now) >= limits.pageDisconnectedMs)
      await this.#life.pageIsGone();
  }

  /** Whether a use of the robot or its keys is due to be stored. */
  get isUseDue(): boolean {
    return this.#use.isDue;
  }

  /** Whether the store may soon treat the robot as expired although it is in use. */
  get isUseUrgent(): boolean {
    return this.#use.isUrgent(this.#clock.now());
  }

  /** Stores the latest uses of the robot and its keys. */
  async noteUse(): Promise<void> {
    await this.#use.note();
  }

  /** Ends the robot for all connected clients. */
  close(reason: "over" | "restart"): void {
    this.#isOver = true;
    if (this.hasPage) this.#channel.pageLeft(this.#ownership.epoch, false);
    if (reason === "over") this.#channel.deleted();
    this.#life.close(reason);
    this.presence.close();
    this.#ownership.page?.link.close(closeReasons[reason]);
    this.#ownership.clear();
    this.#subscribers.close(reason);
    this.leave();
  }

  /** Releases the robot from memory. Other relays may still hold it. */
  leave(): void {
    this.keys.close();
    this.#channel.leave();
  }

  // --- other relays ---

  /** Messages of other relays may have been missed. */
  missedMessages(): void {
    this.#others.missed();
  }

  /** Sends the current scripts to the page, here or at another relay. */
  #notifyScripts(): void {
    const scripts = this.presence.report();
    if (this.#ownership.isElsewhere) return this.#channel.announce(scripts);
    this.#life.display.sendWith({
      type: "drivers",
      at: this.#clock.now(),
      ...this.#channel.withOthers(scripts),
      paused: this.scriptAccess.isPaused,
    });
  }

  /** Disconnects the users of a revoked key and ends their commands. */
  #revoked({ hash }: StoredKey): void {
    this.scriptClocks.revoked(hash);
    this.#subscribers.dismiss((caller) => caller.hash === hash, "revoked");
    this.#askToEnd();
    // A blocked script is removed with its key.
    this.scriptAccess.apply({
      blocked: this.scriptAccess.blocked.filter(({ driver }) => driver !== hash),
    });
  }

  /** Disconnects a blocked script and ends its commands. */
  #blocked({ id }: StoredScript): void {
    this.#subscribers.dismiss(({ script }) => script?.id === id, "blocked");
    this.#askToEnd();
  }

  /** Asks a page at this relay to end recalled commands. */
  #askToEnd(): void {
    // If that fails, the page is asked when it reconnects.
    if (this.hasPage) this.#life.recall.askAgain().catch(() => undefined);
  }

  /** Stores a snapshot of the page and publishes it. */
  #show(snapshot: CarriedSnapshot): void {
    this.#view.report(snapshot, this.#clock.now());
    this.#publishSnapshot();
  }

  #publishSnapshot(): void {
    const { newest } = this;
    if (newest === null) return;
    this.#subscribers.publishSnapshot(newest);
    this.#channel.snapshot(newest);
  }

  #notifyReaders(): void {
    if (this.newest !== null) this.#subscribers.publishSnapshot(this.newest);
  }
}
