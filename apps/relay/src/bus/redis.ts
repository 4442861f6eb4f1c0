/**
 * Message bus over Redis: a channel for each robot that this relay holds. The store
 * publishes numbered steps there, in the same transaction. A missing number or a broken connection
 * makes the bus call `missed`. A relay without a heartbeat for three seconds counts as dead, and
 * its pages as disconnected. If it was only stalled, it lets its pages reconnect.
 */
import {
  aliveDriverSchema,
  driversSchema,
  hasEnded,
  marksFields,
  recallCauses,
  scriptSchema,
} from "@corridor/protocol";
import type { Logger } from "pino";
import { z } from "zod";
import type { Clock } from "../platform/time/clock.ts";
import { asked, type Redis } from "../store/redis/connection.ts";
import { channelOf, postOf, RELAYS, robotKeyOf } from "../store/redis/redis-keys.ts";
import { termedRow } from "../store/redis/rows.ts";
import { Script } from "../store/redis/script.ts";
import { readPost, SnapshotPost } from "./snapshot-post.ts";
import type { BusListener, Channel, BusMessage, Bus } from "./bus.ts";

const HEARTBEAT_MS = 1_000;
/** A relay without a heartbeat for this long counts as dead. */
const ALIVE_MS = 3_000;
/**
 * Interval of key checks while the subscriber connection is broken, because revocations may be
 * missed.
 */
const KEY_CHECK_MS = 300;
/**
 * Pings of another connection that Redis answers before a missing answer counts. Each turn of its
 * event loop reads and answers all connections, in any order. After a stall, the first ping may be
 * read one turn before an older ping of the subscriber connection, and answered one turn earlier.
 */
const SILENCE_PINGS = 3;

/** name of a page; earlier versions of Corridor stored none */
const name = z.string().default("");
const holderSchema = z.object({ relay: z.string(), epoch: z.int(), name });
const heartbeatSchema = z.object({
  lapsed: z.boolean(),
  holders: z.array(holderSchema.nullable()),
});
const scriptsSchema = driversSchema.extend({
  alive: z.array(aliveDriverSchema),
  // Relays of earlier versions know no problems.
  scripts: z.array(
    scriptSchema.extend({ lastProblem: scriptSchema.shape.lastProblem.default(null) }),
  ),
});
const from = z.string();
const epoch = z.int();
const messageSchema = z.discriminatedUnion("kind", [
  z.object({
    kind: z.literal("step"),
    from,
    n: z.int(),
    added: termedRow.nullable(),
    changed: z.array(termedRow),
  }),
  z.object({ kind: z.literal("page"), from, epoch, name }),
  z.object({
    kind: z.literal("page-left"),
    from,
    epoch,
    closedByPage: z.boolean().default(false),
  }),
  z.object({ kind: z.literal("yield"), from, epoch }),
  z.object({ kind: z.literal("yielded"), from, epoch }),
  z.object({ kind: z.literal("here"), from, scripts: scriptsSchema, asks: z.boolean() }),
  z.object({ kind: z.literal("cancel"), from, seq: z.int(), cause: z.enum(recallCauses) }),
  z.object({ kind: z.literal("keys"), from }),
  z.object({ kind: z.literal("maze"), from, version: z.string() }),
  z.object({ kind: z.literal("marks"), from, marks: z.object(marksFields) }),
  z.object({ kind: z.literal("over"), from }),
]);
type Message = z.infer<typeof messageSchema>;

interface Member {
  listener: BusListener;
  /** number of the last received step; null: none yet */
  n: number | null;
  /** the other relay that owns the page, as far as known */
  holder: z.infer<typeof holderSchema> | null;
  /** whether this relay owns it */
  isOwn: boolean;
  /** counter of page messages, to detect responses that are older than a message */
  pageMessages: number;
}

export interface RedisBusOptions {
  redis: Redis;
  /** a dedicated connection for subscriptions */
  subscriber: Redis;
  relay: string;
  clock: Clock;
  log: Logger;
}

export class RedisBus implements Bus {
  readonly #options: RedisBusOptions;
  readonly #script: Script;
  readonly #members = new Map<string, Member>();
  readonly #post: SnapshotPost;
  /** prefix of this relay's own presence messages, which it ignores */
  readonly #ownPresence: string;
  #cancelTimer: () => void = () => undefined;
  #cancelCheck: () => void = () => undefined;
  #isClosed = false;
  /** the last ping of the subscriber connection */
  #ping = { isAnswered: true };

  private constructor(options: RedisBusOptions) {
    this.#options = options;
    this.#script = new Script(options.redis, ["page-holders.lua"], [options.relay]);
    this.#ownPresence = JSON.stringify({ kind: "here", from: options.relay }).slice(0, -1);
    this.#post = new SnapshotPost(options.clock, (relay, post) => {
      // Lost posts need no retry, because the next one is newer.
      options.redis.publish(postOf(relay), post).catch(() => undefined);
    });
  }

  /** Opens the message bus. From then on this relay counts as alive. */
  static async open(options: RedisBusOptions): Promise<RedisBus> {
    const bus = new RedisBus(options);
    await asked(
      options.subscriber.subscribe(
        postOf(options.relay),
        (post) => {
          for (const [robot, snapshot] of readPost(post) ?? []) {
            bus.#members.get(robot)?.listener.received({ kind: "snapshot", snapshot });
          }
        },
        true,
      ),
    );
    await bus.#sendHeartbeat();
    // The client resubscribes automatically, but messages in between are lost.
    options.subscriber.on("ready", () => {
      bus.#ping.isAnswered = true;
      bus.#onMissed();
    });
    bus.#checkSubscriber();
    return bus;
  }

  async join(robot: string, listener: BusListener): Promise<Channel> {
    const { subscriber, relay, log } = this.#options;
    const member: Member = {
      listener,
      n: null,
      holder: null,
      isOwn: false,
      pageMessages: 0,
    };
    const onMessage = (text: string): void => {
      if (text.startsWith(this.#ownPresence)) return;
      const message = messageSchema.safeParse(JSON.parse(text));
      if (message.success) this.#onMessage(member, message.data);
      else log.warn({ err: message.error }, "invalid message from another relay");
    };
    const channel = channelOf(robot);
    const leave = (): void => {
      if (this.#members.get(robot) === member) this.#members.delete(robot);
      subscriber.unsubscribe(channel, onMessage).catch(() => undefined);
    };
    await asked(subscriber.subscribe(channel, onMessage));
    this.#members.set(robot, member);
    const holder = await this.#holder(robot).catch((error: unknown) => {
      leave();
      throw error;
    });
    if (holder !== null && holder.relay !== relay && member.holder === null) {
      member.holder = holder;
      listener.received({ kind: "page", epoch: holder.epoch, name: holder.name });
    }
    return {
      returnsOwnChanges: true,
      // The store has published it.
      commandsChanged: () => undefined,
      notify: (message) => this.#publish(robot, message),
      sendSnapshot: (snapshot, relays) => this.#post.post(robot, snapshot, relays),
      // Uses the same connection as the steps, which preserves the order.
      flush: () => this.#post.flush(),
      leave,
    };
  }

  async close(): Promise<void> {
    this.#isClosed = true;
    this.#cancelTimer();
    this.#cancelCheck();
    this.#post.close();
    this.#members.clear();
    await this.#run("stop", "").catch(() => undefined);
  }

  #publish(robot: string, message: Exclude<BusMessage, { kind: "snapshot" }>): void {
    const { redis, relay, log } = this.#options;
    // The store has published it, for a page with the new epoch.
    if (message.kind === "page" || message.kind === "keys" || message.kind === "over") return;
    const published =
      message.kind === "page-left"
        ? this.#run("left", robot, { epoch: message.epoch, closedByPage: message.closedByPage })
        : redis.publish(channelOf(robot), JSON.stringify({ ...message, from: relay }));
    published.catch((error: unknown) =>
      log.debug({ err: error }, "publishing to other relays failed"),
    );
  }

  #onMessage(member: Member, message: Message): void {
    const { relay } = this.#options;
    if (message.kind === "step") return this.#onStep(member, message);
    const isOwn = message.from === relay;
    if (message.kind === "page" || message.kind === "page-left") {
      member.pageMessages += 1;
      member.isOwn = message.kind === "page" && isOwn;
      member.holder =
        message.kind === "page" && !isOwn ? { ...message, relay: message.from } : null;
    }
    // The response to a deletion of this relay can be lost, or late.
    if (isOwn && message.kind !== "over") return;
    member.listener.received(message);
  }

  #onStep(member: Member, { n, from: sender, added, changed }: Message & { kind: "step" }): void {
    if (member.n !== null && n !== member.n + 1) member.listener.missed();
    member.n = n;
    const ended = changed.filter(({ record }) => hasEnded(record.state));
    const changes = { added, ended, changed: changed.map(({ record }) => record) };
    member.listener.commandsChanged(changes, sender === this.#options.relay);
  }

  #onMissed(): void {
    for (const member of this.#members.values()) {
      member.n = null;
      member.listener.missed();
    }
    if (!this.#isClosed) this.#refreshOwners().catch(() => undefined);
  }

  #checkSubscriber(): void {
    const { clock, subscriber } = this.#options;
    if (!subscriber.isReady) this.#requestKeyChecks();
    else if (this.#ping.isAnswered) this.#pingSubscriber();
    else void this.#checkSilence(this.#ping);
    this.#cancelCheck = clock.after(KEY_CHECK_MS, () => this.#checkSubscriber());
  }

  #pingSubscriber(): void {
    const ping = { isAnswered: false };
    this.#ping = ping;
    const onAnswer = (): void => void (ping.isAnswered = true);
    // An error counts as an answer, because `isReady` reports a broken connection.
    this.#options.subscriber.ping().then(onAnswer, onAnswer);
  }

  /**
   * An unanswered ping means that the connection is dead, or that Redis is stalled. A stalled Redis
   * cannot revoke a key.
   */
  async #checkSilence(ping: { isAnswered: boolean }): Promise<void> {
    const { redis } = this.#options;
    try {
      for (let n = 0; n < SILENCE_PINGS; n++) await redis.ping();
    } catch {
      return;
    }
    if (!ping.isAnswered) this.#requestKeyChecks();
  }

  #requestKeyChecks(): void {
    for (const { listener } of this.#members.values()) listener.received({ kind: "keys" });
  }

  async #sendHeartbeat(): Promise<void> {
    try {
      await this.#refreshOwners();
    } catch (error) {
      this.#options.log.debug({ err: error }, "heartbeat failed");
    }
    if (this.#isClosed) return;
    this.#cancelTimer = this.#options.clock.after(HEARTBEAT_MS, () => void this.#sendHeartbeat());
  }

  /** Sends a heartbeat and checks who owns the pages, because relays may have died or recovered. */
  async #refreshOwners(): Promise<void> {
    const members = [...this.#members].map(([robot, member]) => ({
      session: robotKeyOf(robot),
      member,
      pageMessages: member.pageMessages,
    }));
    const sessions = members.map(({ session }) => session);
    const answer = heartbeatSchema.parse(await this.#run("beat", "", { ms: ALIVE_MS, sessions }));
    for (const [index, { member, pageMessages }] of members.entries()) {
      if (member.isOwn && answer.lapsed) member.listener.received({ kind: "lapsed" });
      else if (!member.isOwn && member.pageMessages === pageMessages)
        this.#updateHolder(member, answer.holders[index] ?? null);
    }
  }

  #updateHolder(member: Member, holder: Member["holder"]): void {
    const before = member.holder;
    const isOther = holder?.relay !== this.#options.relay;
    member.holder = isOther ? holder : null;
    if (member.holder?.epoch === before?.epoch) return;
    if (member.holder !== null) {
      member.listener.received({
        kind: "page",
        epoch: member.holder.epoch,
        name: member.holder.name,
      });
    } else if (before !== null) {
      member.listener.received({ kind: "page-left", epoch: before.epoch, closedByPage: false });
    }
  }

  /** @returns the page that owns the robot */
  async #holder(robot: string): Promise<Member["holder"]> {
    return holderSchema.nullable().parse(await this.#run("holder", robot));
  }

  async #run(step: string, robot: string, values: unknown = {}): Promise<unknown> {
    return this.#script.run(step, [robotKeyOf(robot), channelOf(robot), RELAYS], values);
  }
}
