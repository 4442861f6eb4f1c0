/**
 * Lifecycle of one robot's commands, between the scripts that send them and the page that executes
 * them.
 *
 * All changes of commands go through one serial queue, so the order in the store is the order on
 * the connection. Waiting commands expire here. A command is marked as delivered before it is sent.
 * From then on only the robot ends it, or the relay once the page is gone for good.
 */
import {
  closeReasons,
  hasEnded,
  PROTOCOL_VERSION,
  type CommandRecord,
  type Ending,
  type PageToRelay,
  type Resume,
} from "@corridor/protocol";
import { abandonStep, acquireStep } from "../../commands/page-transitions.ts";
import { endStep, expireStep, startStep } from "../../commands/state-machine.ts";
import type { Clock } from "../../platform/time/clock.ts";
import type { CommandChanges } from "../../bus/bus.ts";
import type { CoalescedTimers } from "../../platform/time/coalesced-timers.ts";
import type { RobotStore } from "../../store/robot-store.ts";
import type { TermedRecord } from "../../commands/robot-commands.ts";
import type { Subscribers } from "../readers/subscribers.ts";
import { CommandDelivery, PageDisplay } from "./command-delivery.ts";
import { CommandIntake } from "./command-intake.ts";
import { CommandLog } from "./command-log.ts";
import { CommandRecall } from "./command-recall.ts";
import { DeadlineTimer } from "./deadline-timer.ts";
import { limits } from "../../platform/limits/limits.ts";
import { SerialQueue } from "../../platform/serial-queue.ts";
import { PageHandover, type PreviousPage } from "../page/page-handover.ts";
import type { PageConnection, PageOwnership } from "../page/page-ownership.ts";
import type { RobotChannel } from "../channel/robot-channel.ts";
import type { CommandObserver } from "./command-observer.ts";

export interface CommandLifeParts {
  robot: string;
  store: RobotStore;
  clock: Clock;
  timers: CoalescedTimers;
  observer: CommandObserver;
  subscribers: Subscribers;
  ownership: PageOwnership;
  channel: RobotChannel;
}

export class CommandLife {
  readonly #robot: string;
  readonly #store: RobotStore;
  readonly #clock: Clock;
  readonly #observer: CommandObserver;
  readonly #subscribers: Subscribers;
  readonly #ownership: PageOwnership;
  readonly #channel: RobotChannel;
  readonly #delivery: CommandDelivery;
  readonly #work = new SerialQueue();
  /** serializes pages that connect */
  readonly #arrivals = new SerialQueue();
  /** transfers the robot from one page to the next */
  readonly handover: PageHandover;
  /** shows the page commands that it does not have */
  readonly display: PageDisplay;
  /** takes in commands of scripts */
  readonly intake: CommandIntake;
  /** queries for the same commands */
  readonly log: CommandLog;
  /** cancels the same commands for their senders and the owner */
  readonly recall: CommandRecall;
  readonly #deadlines: DeadlineTimer;
  /** whether the store may hold a waiting command that it did not confirm */
  #isInDoubt = false;
  #end: "over" | "restart" | null = null;

  constructor({
    robot,
    store,
    clock,
    timers,
    observer,
    subscribers,
    ownership,
    channel,
  }: CommandLifeParts) {
    this.#robot = robot;
    this.#store = store;
    this.#clock = clock;
    this.#observer = observer;
    this.#subscribers = subscribers;
    this.#ownership = ownership;
    this.#channel = channel;
    this.handover = new PageHandover({ clock, ownership, channel });
    const sent = (records: readonly CommandRecord[]): void => this.#publishStates(records);
    const display = new PageDisplay({ ownership, clock, timers });
    this.display = display;
    this.#delivery = new CommandDelivery({
      robot,
      store,
      clock,
      ownership,
      display,
      sent,
    });
    this.intake = new CommandIntake({
      robot,
      store,
      clock,
      observer,
      work: this.#work,
      delivery: this.#delivery,
      end: () => this.#end,
      expiresAt: (time) => this.#deadlines.wake(time),
      doubted: () => this.#doubt(),
      commandsChanged: (changes) => this.#commandsChanged(changes),
    });
    this.log = new CommandLog(robot, store, subscribers, this.#work);
    this.recall = new CommandRecall({
      robot,
      store,
      work: this.#work,
      ended: (commands) => this.#endedHere(commands),
      ask: (seq, cause) => {
        ownership.page?.connection.send({ type: "cancel", seq, cause });
        channel.cancel(seq, cause);
      },
    });
    this.#deadlines = new DeadlineTimer(clock, () => void this.#expire().catch(() => undefined));
    // Commands from before the start of this relay may have expired.
    this.#deadlines.wake(clock.now());
  }

  // --- the page ---

  /**
   * Connects a page to the robot once the previous page has released it. The previous page is
   * disconnected.
   * @param acquired called when the page owns the robot, before commands are delivered to it
   */
  async acquirePage(
    connection: PageConnection,
    resume: Resume,
    acquired: () => void,
  ): Promise<void> {
    await this.#arrivals.run(async () => {
      const previous = await this.handover.releasePrevious(resume);
      // The page disconnected while the previous page released the robot. That one may reconnect.
      if (!connection.isOpen) return;
      await this.#admitPage(connection, resume, { ...previous, acquired });
    });
  }

  async #admitPage(
    connection: PageConnection,
    resume: Resume,
    { epoch: knownEpoch, left, acquired }: PreviousPage & { acquired: () => void },
  ): Promise<void> {
    const { lastApplied, fresh, endings, snapshot, page: name = "" } = resume;
    await this.#work.run(async () => {
      const taken = await this.#store.commit(
        this.#robot,
        acquireStep({
          lastApplied,
          // A page can never end a command that another page started.
          fresh: fresh || (this.#ownership.name !== "" && !this.handover.isSame(resume)),
          endings,
          pose: snapshot?.pose ?? null,
          page: name,
          knownEpoch,
          left,
        }),
      );
      if (taken === null || this.#end !== null)
        return connection.close(closeReasons[this.#end ?? "over"]);
      // Another relay's page may be newer, and its message may arrive before this response.
      if (this.#ownership.isElsewhere && this.#ownership.epoch > taken.epoch)
        return connection.close(closeReasons.replaced);
      this.#ownership.page?.connection.close(closeReasons.replaced);
      this.#ownership.take({ connection, epoch: taken.epoch, name });
      this.#channel.pageConnected(taken.epoch, name);
      const at = this.#clock.now();
      connection.send({ type: "welcome", version: PROTOCOL_VERSION, epoch: taken.epoch, at });
      const refused = new Map(taken.refused.map((record) => [record.seq, record]));
      for (const { seq } of endings) this.#answerEnding(connection, seq, refused.get(seq) ?? null);
      acquired();
      this.#publishStates(taken.changed);
      await this.recall.repeatRequests();
      await this.#expireNow();
      await this.#delivery.run();
    });
  }

  /** Handles a page's report that a command started or ended, or that it released the robot. */
  async receiveFromPage(
    connection: PageConnection,
    message: Extract<PageToRelay, { type: "started" | "ended" | "yielded" }>,
  ): Promise<void> {
    await this.#work.run(async () => {
      // The connection may be closed by now. Its reports count until another page acquires the
      // robot.
      if (message.epoch !== this.#ownership.epoch) return;
      try {
        await this.#handleReport(connection, message);
      } catch (error) {
        // No later report may count after this failure. The page repeats all of them when it
        // reconnects.
        connection.close(closeReasons.busy);
        throw error;
      }
    });
  }

  async #handleReport(
    connection: PageConnection,
    message: Parameters<CommandLife["receiveFromPage"]>[1],
  ): Promise<void> {
    switch (message.type) {
      case "started":
        return this.#started(message.epoch, message.seq);
      case "ended": {
        const { type: _type, epoch, ...ending } = message;
        return this.#ended(connection, epoch, ending);
      }
      case "yielded":
        // All earlier reports of the page are stored by now.
        if (connection.isOpen) this.handover.yielded(message.epoch, true);
        return;
    }
  }

  /** Ends the commands of a page that is gone, unless a page is connected again. */
  async pageIsGone(): Promise<void> {
    await this.#work.run(async () => {
      if (this.#ownership.page !== null || this.#ownership.isElsewhere) return;
      const { epoch } = this.#ownership;
      const ended = await this.#store.commit(this.#robot, abandonStep(epoch));
      // Another relay has the page after all, and its message arrives soon.
      if (ended === null) return;
      this.#ownership.settleDisconnected();
      this.#publishStates(ended);
    });
  }

  async #started(epoch: number, seq: number): Promise<void> {
    const started = this.#store.commit(this.#robot, startStep(epoch, seq));
    const due = this.#delivery.take();
    const record = await started;
    if (record !== null) {
      this.#observer.started(this.#secondsSince(Date.parse(record.acceptedAt)));
      this.#publishStates([record]);
    }
    this.#delivery.send(await due);
  }

  async #ended(connection: PageConnection, epoch: number, ending: Ending): Promise<void> {
    const ended = this.#store.commit(this.#robot, endStep(epoch, ending));
    const due = this.#delivery.take();
    const { outcome, record } = await ended;
    // The held commands were sent for the same situation as the cancelled one. The page receives
    // both together.
    if (ending.state === "cancelled") this.display.flush();
    // The page may not end this command now. It retains the ending and sends it again when it
    // reconnects.
    const isStored = outcome === "over" && record !== null && !hasEnded(record.state);
    if (!isStored) {
      const isRepeated = record?.state === ending.state;
      this.#answerEnding(connection, ending.seq, isRepeated ? null : record);
    }
    if (outcome === "ended") this.#publishStates([record]);
    this.#delivery.send(await due);
  }

  /**
   * Confirms an ending. In both cases the page need not send it again.
   * @param other the record with its earlier, different ending; null: there is none
   */
  #answerEnding(connection: PageConnection, seq: number, other: CommandRecord | null): void {
    connection.send(other === null ? { type: "stored", seq } : { type: "refused", record: other });
  }

  // --- time ---

  async #expire(): Promise<void> {
    await this.#work.run(async () => {
      if (this.#end !== null) return;
      await this.#expireNow();
      if (!this.#isInDoubt) return;
      this.#isInDoubt = false;
      await this.#delivery.run();
    });
  }

  async #expireNow(): Promise<void> {
    try {
      const isAbsent = !this.#ownership.isOwned;
      const { ended, next } = await this.#store.commit(
        this.#robot,
        expireStep(this.#clock.now(), isAbsent),
      );
      if (next !== null) this.#deadlines.wake(next);
      this.#endedHere(ended);
    } catch {
      this.#deadlines.wake(this.#clock.now() + limits.storeRetryMs);
    }
  }

  /** The store failed to respond, but may have stored a command. Looks for it after a delay. */
  #doubt(): void {
    this.#isInDoubt = true;
    this.#deadlines.wake(this.#clock.now() + limits.storeRetryMs);
  }

  /** Publishes commands that the relay has ended, and shows them to the page. */
  #endedHere(ended: readonly TermedRecord[]): void {
    const changed = ended.map(({ record }) => record);
    this.#commandsChanged({ added: null, changed, ended: [...ended] });
  }

  // --- other relays ---

  /** Handles changes by another relay, or by this one if the bus returns them in its order. */
  receivedChanges(changes: CommandChanges, isOwn: boolean): void {
    const received = this.#work.run(async () => {
      this.#subscribers.publishStates(changes.changed);
      if (isOwn || this.#end !== null) return;
      this.display.show(changes.ended);
      const { added } = changes;
      if (added === null) return;
      this.intake.storedElsewhere(added);
      // The relay that stored the command may fail before the deadline.
      this.#deadlines.wake(added.deadline);
      if (this.#ownership.page !== null)
        this.#delivery.sendOrShow(added, await this.#delivery.take());
    });
    received.catch(() => undefined);
  }

  /** Changes may have been missed: notifies readers of the gap and delivers waiting commands. */
  missedChanges(): void {
    const made = this.#work.run(async () => {
      this.#subscribers.publishMissed();
      this.#deadlines.wake(this.#clock.now());
      if (this.#ownership.page !== null) await this.recall.repeatRequests();
      await this.#delivery.run();
    });
    made.catch(() => undefined);
  }

  /** Stops accepting and delivering commands. */
  close(reason: "over" | "restart"): void {
    this.#end = reason;
    this.display.flush();
    this.#deadlines.close();
  }

  #publishStates(records: readonly CommandRecord[]): void {
    this.#commandsChanged({ added: null, ended: [], changed: [...records] });
  }

  /** Publishes changes by this relay to its readers, its page and other relays. */
  #commandsChanged(changes: CommandChanges): void {
    const { changed, ended } = changes;
    for (const { state } of changed) if (hasEnded(state)) this.#observer.ended(state);
    if (!this.#channel.returnsOwnChanges) this.#subscribers.publishStates(changed);
    this.#channel.commandsChanged(changes);
    if (ended.length > 0) this.display.show(ended);
  }

  #secondsSince(time: number): number {
    return Math.max(0, this.#clock.now() - time) / 1000;
  }
}
