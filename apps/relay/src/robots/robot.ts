/**
 * One robot at this relay: creates the parts that hold its state, and starts and ends them together.
 * All changes of commands go through the one queue of `CommandLife`. Independent of WebSocket and
 * HTTP.
 */
import {
  closeReasons,
  hasEnded,
  RefusedError,
  waitingReason,
  type CommandRecord,
  type CommandTerms,
  type Obstacle,
  type ScriptView,
} from "@corridor/protocol";
import { asRefusal } from "../platform/errors/problems.ts";
import type { Clock } from "../platform/time/clock.ts";
import type { CoalescedTimers } from "../platform/time/coalesced-timers.ts";
import type { Bus } from "../bus/bus.ts";
import type { CarriedSnapshot } from "../bus/carried-snapshot.ts";
import type { RobotStore, StoredRobot } from "../store/robot-store.ts";
import type { StoredKey } from "../commands/robot-step.ts";
import { AccessEnforcement } from "./access-enforcement.ts";
import { RightsVersion, type Verb, type Caller, ScriptAccess } from "./access/callers.ts";
import { KeyRing } from "./access/key-ring.ts";
import { CommandLife } from "./delivery/command-life.ts";
import type { CommandObserver } from "./delivery/command-observer.ts";
import { ScriptClocks } from "./delivery/script-clocks.ts";
import { limits } from "../platform/limits/limits.ts";
import { LiveView } from "./live-view.ts";
import { MarkBoard } from "./mark-board.ts";
import { MazeBoard } from "./maze-board.ts";
import { OtherRelays } from "./other-relays.ts";
import { PageOwnership } from "./page/page-ownership.ts";
import { Presence } from "./presence/presence.ts";
import { RobotChannel } from "./channel/robot-channel.ts";
import { EventLog } from "../platform/events/event-log.ts";
import { recordPacking } from "./readers/packed-record.ts";
import { Readers } from "./readers/readers.ts";
import { Subscribers, type CallerWait } from "./readers/subscribers.ts";
import { RobotPage } from "./robot-page.ts";
import { RobotUse } from "./robot-use.ts";
import { ScriptReport } from "./script-report.ts";

export interface RobotParts {
  store: RobotStore;
  clock: Clock;
  /** shared by all robots */
  timers: CoalescedTimers;
  observer: CommandObserver;
  bus: Bus;
  /** called when the robot has ended, because any relay has deleted it */
  deleted: () => void;
}

export class Robot {
  readonly id: string;
  readonly createdAt: number;
  /** the page that owns the robot */
  readonly page: RobotPage;
  readonly keys: KeyRing;
  /** blocked scripts, and whether remote driving is paused */
  readonly scriptAccess: ScriptAccess;
  /** version for which the result of a check stays valid */
  readonly rights = new RightsVersion();
  /** scripts that use the robot at this relay */
  readonly presence: Presence;
  readonly readers: Readers;
  readonly mazes: MazeBoard;
  readonly marks: MarkBoard;
  /** last use of the robot and its keys */
  readonly use: RobotUse;
  /** clocks of the scripts that send single requests */
  readonly scriptClocks = new ScriptClocks();
  readonly #clock: Clock;
  readonly #view: LiveView;
  readonly #events: EventLog<CommandRecord>;
  readonly #subscribers: Subscribers;
  readonly #ownership: PageOwnership;
  readonly #life: CommandLife;
  readonly #channel: RobotChannel;
  readonly #others: OtherRelays;
  readonly #report: ScriptReport;
  #end: "over" | "restart" | null = null;

  /** Creates the parts from the bottom up: each one knows only those before it. */
  private constructor(stored: StoredRobot, parts: RobotParts) {
    const { store, clock, timers, observer } = parts;
    const { id: robot, createdAt } = stored;
    this.id = robot;
    this.createdAt = createdAt;
    this.#clock = clock;

    const channel = new RobotChannel(clock, timers);
    const ownership = new PageOwnership(clock.now(), stored);
    const events = new EventLog(clock, recordPacking);
    const subscribers = new Subscribers(clock, events);
    const view = new LiveView({ clock, subscribers, channel });
    const shared = { store, clock, timers, observer };
    const life = new CommandLife({ ...shared, robot, subscribers, ownership, channel });

    const presence = new Presence(clock);
    const clocks = this.scriptClocks;
    const { recall, display } = life;
    const reaction = { subscribers, ownership, recall, presence, channel, clocks };
    const listener = new AccessEnforcement(reaction);
    const access = { robot, rights: this.rights, stored, store, changes: recall, listener };
    const scripts = new ScriptAccess(access);
    const keys = new KeyRing({ ...access, clock, scripts });
    const use = new RobotUse(stored, { store, clock, keys });

    const sent = { clock, presence, access: scripts, channel, ownership, display };
    const report = new ScriptReport(sent);
    const page = new RobotPage({ createdAt, clock, ownership, life, view, channel, use, report });
    const mazes = new MazeBoard({ robot, store, clock, subscribers, channel });
    const marks = new MarkBoard({ ownership, subscribers, channel });
    const source = {
      events,
      newest: () => view.newest,
      readOpen: life.log.readOpen.bind(life.log),
    };

    this.page = page;
    this.keys = keys;
    this.scriptAccess = scripts;
    this.presence = presence;
    this.mazes = mazes;
    this.marks = marks;
    this.readers = new Readers({ clock, timers, subscribers, source, presence });
    this.#view = view;
    this.#events = events;
    this.#subscribers = subscribers;
    this.#ownership = ownership;
    this.#life = life;
    this.#channel = channel;
    this.#report = report;
    this.use = use;
    this.#others = new OtherRelays({
      clock,
      ownership,
      view,
      channel,
      life,
      keys,
      mazes,
      marks,
      page,
      report,
      over: () => {
        if (this.isOver) return;
        parts.deleted();
        this.close("over");
      },
    });
  }

  /**
   * Loads a robot into memory and subscribes to its channel.
   * @returns null if it was deleted meanwhile
   */
  static async open(stored: StoredRobot, parts: RobotParts): Promise<Robot | null> {
    const robot = new Robot(stored, parts);
    await robot.#channel.open(parts.bus, stored.id, {
      commandsChanged: (changes, isOwn) => robot.#life.receivedChanges(changes, isOwn),
      missed: () => robot.missedMessages(),
      received: (message) => robot.#others.received(message),
    });
    try {
      // Another relay may have revoked a key or deleted the robot before this one joined the channel.
      if (await robot.keys.reread()) {
        await robot.#others.waitForPage();
        return robot;
      }
    } catch (error) {
      robot.leave();
      throw error;
    }
    robot.leave();
    return null;
  }

  /**
   * The stored key that matches; null if none matches, or the robot has ended.
   * @param use where the key stood: in a header or message by default
   */
  grantOf(key: string, use?: StoredKey["use"]): StoredKey | null {
    if (this.isOver) return null;
    const grant = this.keys.match(key, use);
    if (grant !== null) this.use.used();
    return grant;
  }

  get isOver(): boolean {
    return this.#end !== null;
  }

  /** Why the robot has ended at this relay: it was deleted, or the relay stops. */
  get end(): "over" | "restart" | null {
    return this.#end;
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
    return this.#report.scripts;
  }

  get newest(): CarriedSnapshot | null {
    return this.#view.newest;
  }

  /**
   * Whether the robot is unused, has no pending work and can leave memory. If its page reported
   * here, it stays until it expires, because nothing else holds the newest snapshot.
   */
  get isQuiet(): boolean {
    const isUnused = this.#clock.now() - this.use.lastAt > limits.touchMs;
    const isAlone = !this.hasPage && this.#subscribers.isEmpty;
    const isHeldElsewhere = this.#ownership.isElsewhere || this.newest === null;
    return isUnused && isAlone && !this.#ownership.awaitsPage && isHeldElsewhere;
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
    this.use.used();
  }

  /** Stores a command and delivers it in its turn: see `CommandIntake.submit`. */
  async submit(
    caller: Caller,
    request: { key: string | null } & CommandTerms,
    acknowledge: (record: CommandRecord) => void,
  ): Promise<void> {
    try {
      await this.#life.intake.submit(caller, request, (record) => {
        if (caller.script !== null) this.presence.sent(caller.script, record);
        acknowledge(record);
      });
    } catch (error) {
      this.refused(caller, error);
      throw error;
    }
  }

  /** Records why the relay refused a command, as a sentence for the robot's owner. */
  refused({ script }: Caller, error: unknown): void {
    const { problem } = error instanceof RefusedError ? error : asRefusal(error);
    if (script !== null) this.presence.refused(script, problem.detail);
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
    return { ...record, reason: waitingReason(this.#obstacle()) };
  }

  /** Why a command does not end, if the robot is gone or paused. */
  #obstacle(): Obstacle {
    if (!this.#ownership.isOwned) return "absent";
    // While another driver has the robot, its page ends commands at once. A relay without the page
    // cannot distinguish a paused run from a page that is asleep.
    return this.hasPage && this.#view.isRunPaused ? "paused" : "asleep";
  }

  /** Records a message of a script on its connection. */
  spoke({ script }: Caller): void {
    this.use.used();
    if (script !== null) this.presence.spoke(script);
  }

  /** Records a request of a script. @returns function to call once the request is answered */
  received({ script }: Caller): () => void {
    this.use.used();
    return script === null ? () => undefined : this.presence.received(script);
  }

  // --- time and end ---

  /** Called about once a second. Detects pages that are asleep or gone for good. */
  async checkLife(): Promise<void> {
    const now = this.#clock.now();
    this.rights.changed();
    this.#events.deleteOld();
    if (this.hasPage) this.#view.checkAsleep();
    this.#report.repeatAnnouncement();
    if (this.#ownership.disconnectedMs(now) >= limits.pageDisconnectedMs)
      await this.#life.pageIsGone();
  }

  /** Ends the robot for all connected clients. */
  close(reason: "over" | "restart"): void {
    if (this.#end !== null) return;
    this.#end = reason;
    if (this.hasPage) this.#channel.pageLeft(this.#ownership.epoch, false);
    if (reason === "over") this.#channel.deleted();
    this.#life.close(reason);
    this.presence.close();
    this.#ownership.page?.connection.close(closeReasons[reason]);
    this.#ownership.clear();
    this.#subscribers.close(reason);
    this.leave();
  }

  /** Releases the robot from memory. Other relays may still hold it. */
  leave(): void {
    this.keys.close();
    this.#channel.leave();
  }

  /** Messages of other relays may have been missed. */
  missedMessages(): void {
    this.#others.missed();
  }
}
