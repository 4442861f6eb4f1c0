/**
 * One robot session: who may do what, and the life of its commands between scripts and page.
 *
 * Knows neither WebSocket nor HTTP. Whatever changes commands goes through one queue, so the order in
 * the store is the order on the line. A command is marked delivered before it is sent; from then on
 * only the robot ends it, or this session once the page is away for good.
 */
import {
  closeReasons,
  hasEnded,
  PROTOCOL_VERSION,
  type Command,
  type CommandRecord,
  type Ending,
  type PageToRelay,
  type Resume,
  type Snapshot,
} from "@corridor/protocol";
import type { Clock } from "../clock.ts";
import { matchKey } from "../keys.ts";
import { Refusal, restarting, retryAfter } from "../problems.ts";
import type { SessionStore, StoredKey, StoredSession } from "../store/session-store.ts";
import { Audience, type Patience, type ReaderDoor } from "./audience.ts";
import { DriverRoster } from "./driver-roster.ts";
import { limits } from "./limits.ts";
import type { PageLink } from "./page-link.ts";
import { ReaderFeed, type ReaderSink } from "./reader-feed.ts";
import { RobotView } from "./robot-view.ts";
import { TokenBucket } from "./token-bucket.ts";
import { noWitness, type Witness } from "./witness.ts";

interface Page {
  link: PageLink;
  epoch: number;
}

export class Session {
  readonly id: string;
  readonly createdAt: number;
  readonly roster: DriverRoster;
  readonly #keys: readonly StoredKey[];
  readonly #store: SessionStore;
  readonly #clock: Clock;
  readonly #witness: Witness;
  readonly #view = new RobotView();
  readonly #audience: Audience;
  /** by key, one for commands and one for stops */
  readonly #buckets = new Map<string, { commands: TokenBucket; stops: TokenBucket }>();
  /** seq of the newest command while that is a stop */
  #newestStop: number | null = null;
  #page: Page | null = null;
  #awaySince: number | null;
  #lastUsedAt: number;
  #touchedAt: number;
  #work: Promise<unknown> = Promise.resolve();
  #end: "over" | "restart" | null = null;

  constructor(stored: StoredSession, store: SessionStore, clock: Clock, witness = noWitness) {
    this.id = stored.id;
    this.createdAt = stored.createdAt;
    this.#keys = stored.keys;
    this.#lastUsedAt = stored.lastUsedAt;
    this.#touchedAt = stored.lastUsedAt;
    this.#store = store;
    this.#clock = clock;
    this.#witness = witness;
    this.#audience = new Audience(clock);
    this.#awaySince = clock.now();
    this.roster = new DriverRoster(clock, (drivers) => {
      this.#page?.link.send({ type: "drivers", ...drivers });
    });
  }

  /** The stored key that belongs to a bearer key; null when it is none of this robot's. */
  grantOf(key: string): StoredKey | null {
    if (this.isOver) return null;
    const grant = matchKey(key, this.#keys);
    if (grant !== null) this.#used();
    return grant;
  }

  get isOver(): boolean {
    return this.#end !== null;
  }

  get lastUsedAt(): number {
    return this.#lastUsedAt;
  }

  get hasPage(): boolean {
    return this.#page !== null;
  }

  /** How many follow the robot, by the way in which they do. */
  get readers(): Record<ReaderDoor, number> {
    return this.#audience.count();
  }

  get newest(): Snapshot | null {
    return this.#view.newest;
  }

  /**
   * Whether nobody has used it for a while and nothing is due, so that it need not stay in memory.
   * One whose robot has reported stays until it expires: nothing else holds the newest snapshot.
   */
  get isQuiet(): boolean {
    const isUnused = this.#clock.now() - this.#lastUsedAt > limits.touchMs;
    const isAlone = this.#page === null && this.#audience.isEmpty;
    return isUnused && isAlone && this.#awaySince === null && this.newest === null;
  }

  // --- the page ---

  /** A page takes the robot; the page before it is sent away. */
  async takePage(link: PageLink, resume: Resume): Promise<void> {
    await this.#inOrder(async () => {
      const taken = await this.#store.takeOver(this.id, resume);
      if (taken === null || this.isOver) return link.close(closeReasons[this.#end ?? "over"]);
      this.#page?.link.close(closeReasons.replaced);
      this.#page = { link, epoch: taken.epoch };
      this.#awaySince = null;
      this.#used();
      this.#view.pageCame(this.#clock.now());
      link.send({ type: "welcome", version: PROTOCOL_VERSION, epoch: taken.epoch });
      for (const { seq } of resume.endings) link.send({ type: "stored", seq });
      link.send({ type: "drivers", ...this.roster.now() });
      this.#tellStates(taken.changed);
      await this.#deliver();
    });
  }

  /** The page's connection is gone. Does nothing when another page has taken over. */
  leavePage(link: PageLink): void {
    if (this.#page?.link !== link) return;
    this.#page = null;
    this.#awaySince = this.#clock.now();
    this.#view.pageLeft();
    this.#tellSnapshot();
  }

  /** A message of the page. Frames of a page that was replaced or of an older epoch are refused. */
  async hearPage(link: PageLink, message: PageToRelay): Promise<void> {
    if (this.#page?.link !== link) return;
    if (message.epoch !== this.#page.epoch) return link.close(closeReasons.replaced);
    this.#used();
    if (message.type === "snapshot") {
      this.#view.report(message.snapshot, this.#clock.now());
      return this.#tellSnapshot();
    }
    await this.#inOrder(async () => {
      if (this.#page?.link !== link) return;
      if (message.type === "started") return this.#started(message.seq);
      const { type: _type, epoch: _epoch, ...ending } = message;
      await this.#ended(link, ending);
    });
  }

  async #started(seq: number): Promise<void> {
    const record = await this.#store.start(this.id, seq);
    if (record !== null) {
      this.#witness.started(this.#secondsSince(Date.parse(record.acceptedAt)));
      this.#tellStates([record]);
    }
    await this.#deliver();
  }

  async #ended(link: PageLink, ending: Ending): Promise<void> {
    const record = await this.#store.end(this.id, ending);
    // Also when it had ended before: the page need not tell it again.
    link.send({ type: "stored", seq: ending.seq });
    if (record !== null) this.#tellStates([record]);
    await this.#deliver();
  }

  async #deliver(): Promise<void> {
    if (this.#page === null) return;
    const { link, epoch } = this.#page;
    let records: CommandRecord[];
    try {
      records = await this.#store.deliver(this.id, epoch, limits.deliveredWindow);
    } catch {
      // What is stored stays stored; the page comes back in a moment and gets it then.
      return link.close(closeReasons.busy);
    }
    for (const { seq, key, command, acceptedAt } of records) {
      const type = command.action === "stop" ? "stop" : "command";
      link.send({ type, seq, key, command, acceptedAt });
    }
    this.#tellStates(records);
  }

  // --- scripts ---

  /**
   * Stores a command and sends it on when its turn comes. A stop overtakes everything. One that
   * comes too fast, without a key, is not lost while the stop before it is open: that one answers.
   * @param acknowledge gets the record once it is stored, before anything else is said about it;
   *   `duplicate` when the key and the command were stored before
   * @throws Refusal when it comes too fast, too many wait, or the key had another command
   */
  async submit(
    grant: StoredKey,
    request: { key: string | null; command: Command },
    acknowledge: (record: CommandRecord) => void,
  ): Promise<void> {
    const cameAt = this.#clock.now();
    const isStop = request.command.action === "stop";
    const tooFast = this.#takeToken(grant, isStop);
    if (tooFast !== null && !isStop) throw tooFast;
    await this.#inOrder(async () => {
      if (this.#end !== null) throw this.#end === "restart" ? restarting() : noRobot();
      if (tooFast !== null) {
        const stop = await this.#openStop();
        // Whoever sends another key counts on a record of its own, and will try again for it.
        const mayShare = request.key === null || request.key === stop?.key;
        if (stop === null || !mayShare) throw tooFast;
        return acknowledge({ ...stop, duplicate: true });
      }
      const result = await this.#store.add(this.id, {
        ...request,
        driver: grant.hash,
        acceptedAt: this.#clock.now(),
        maxWaiting: limits.waitingCommands,
        keep: limits.keptCommands,
      });
      switch (result.outcome) {
        case "no-session":
          throw noRobot();
        case "full":
          throw new Refusal(
            "queue-full",
            `${limits.waitingCommands} commands wait at this robot. Wait until one has ended, then send this one again.`,
            { headers: retryAfter(1000) },
          );
        case "conflict":
          throw new Refusal(
            "key-conflict",
            `This key belongs to command ${result.record.seq} (${result.record.action}). Use a new key for each command.`,
          );
        case "duplicate":
          return acknowledge({ ...result.record, duplicate: true });
        case "stored":
          this.#newestStop = isStop ? result.record.seq : null;
          this.#witness.stored(this.#secondsSince(cameAt));
          acknowledge(result.record);
          this.#tellStates(result.ended);
          return this.#deliver();
      }
    });
  }

  /** @returns the refusal when the key sends too fast */
  #takeToken(grant: StoredKey, isStop: boolean): Refusal | null {
    const now = this.#clock.now();
    const buckets = this.#buckets.get(grant.hash) ?? {
      commands: new TokenBucket(limits.commandRate, now),
      stops: new TokenBucket(limits.stopRate, now),
    };
    this.#buckets.set(grant.hash, buckets);
    const waitMs = (isStop ? buckets.stops : buckets.commands).take(now);
    if (waitMs === 0) return null;
    const { perSecond, burst } = isStop ? limits.stopRate : limits.commandRate;
    return new Refusal(
      "too-fast",
      `One script may send ${perSecond} ${isStop ? "stops" : "commands"} a second, ${burst} at once. Wait a moment, then send this one again.`,
      { headers: retryAfter(waitMs) },
    );
  }

  /** The stop that has not ended and after which nothing came: another would change nothing. */
  async #openStop(): Promise<CommandRecord | null> {
    if (this.#newestStop === null) return null;
    const record = await this.#store.command(this.id, this.#newestStop);
    return record === null || hasEnded(record.state) ? null : record;
  }

  /** @throws Refusal when there is no command with this number */
  async command(seq: number): Promise<CommandRecord> {
    const record = await this.#store.command(this.id, seq);
    if (record !== null) return record;
    throw new Refusal(
      "no-command",
      `This robot has no command ${seq}. GET .../commands lists those that it has.`,
    );
  }

  async commandsAfter(seq: number): Promise<CommandRecord[]> {
    return this.#store.commandsAfter(this.id, seq, limits.logPage);
  }

  /** A script was heard by HTTP or socket. */
  heard(client: string): void {
    this.#used();
    this.roster.heard(client);
  }

  /**
   * Joins a reader of snapshots and states.
   * @returns a function that lets it go
   * @throws Refusal when too many read already
   */
  join(grant: StoredKey, sink: ReaderSink): () => void {
    const feed = new ReaderFeed(sink, this.#clock);
    const leave = this.#audience.join(feed, grant.hash, sink.door);
    this.roster.connected(1);
    return () => {
      feed.close();
      if (leave()) this.roster.connected(-1);
    };
  }

  /** Waits for a snapshot newer than `after`, or for the robot to go. @returns the newest then */
  async nextSnapshot(after: number, patience: Patience): Promise<Snapshot | null> {
    const before = this.newest;
    if ((before?.seq ?? -1) > after) return before;
    await this.#audience.until(patience, (done) => ({
      snapshot: ({ seq, state }) => {
        if (seq > after || state !== before?.state) done();
      },
    }));
    return this.newest;
  }

  /** Waits for the command to end. @returns its record then, whether it has ended or not */
  async endOf(seq: number, patience: Patience): Promise<CommandRecord> {
    // Begun between two changes, so that no ending falls between asking and listening.
    const { record, end } = await this.#inOrder(async () => {
      const now = await this.command(seq);
      return { record: now, end: hasEnded(now.state) ? null : this.#nextEnd(seq, patience) };
    });
    if (end === null) return record;
    await end;
    return this.command(seq);
  }

  #nextEnd(seq: number, patience: Patience): Promise<void> {
    return this.#audience.until(patience, (done) => ({
      state: (changed) => {
        if (changed.seq === seq && hasEnded(changed.state)) done();
      },
    }));
  }

  // --- time and end ---

  /** Called about once a second: finds pages that sleep or that are away for good. */
  async checkLife(): Promise<void> {
    const now = this.#clock.now();
    if (this.#page !== null && this.#view.checkAsleep(now)) this.#tellSnapshot();
    if (this.#awaySince === null || now - this.#awaySince < limits.pageAwayMs) return;
    await this.#inOrder(async () => {
      if (this.#page !== null) return;
      this.#awaySince = null;
      this.#tellStates(await this.#store.cancelOpen(this.id, "the robot's page is gone"));
    });
  }

  /** Writes down that the session is in use, at most once a minute. */
  async noteUse(): Promise<void> {
    if (this.#lastUsedAt - this.#touchedAt < limits.touchMs) return;
    this.#touchedAt = this.#lastUsedAt;
    await this.#store.touch(this.id, this.#lastUsedAt);
  }

  /** Ends the session for everyone who is connected. */
  close(reason: "over" | "restart"): void {
    this.#end = reason;
    this.roster.close();
    this.#page?.link.close(closeReasons[reason]);
    this.#page = null;
    this.#audience.close(reason);
  }

  #used(): void {
    this.#lastUsedAt = Math.max(this.#lastUsedAt, this.#clock.now());
  }

  #tellStates(records: readonly CommandRecord[]): void {
    for (const { state } of records) if (hasEnded(state)) this.#witness.ended(state);
    this.#audience.tellStates(records);
  }

  #secondsSince(time: number): number {
    return Math.max(0, this.#clock.now() - time) / 1000;
  }

  #tellSnapshot(): void {
    if (this.newest !== null) this.#audience.tellSnapshot(this.newest);
  }

  /** Runs one change after the other; a failed one does not stop the next. */
  #inOrder<T>(change: () => Promise<T>): Promise<T> {
    const result = this.#work.then(change);
    this.#work = result.catch(() => undefined);
    return result;
  }
}

/** The answer where no session has the id. */
export function noRobot(): Refusal {
  return new Refusal(
    "no-robot",
    "There is no robot with this id. Robots are forgotten after 2 hours without use: open the page and copy the new address.",
  );
}
