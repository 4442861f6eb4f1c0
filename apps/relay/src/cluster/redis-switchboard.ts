/**
 * Lines over Redis: a channel for each robot that this relay holds. The scripts of the store tell the
 * steps there, numbered, in the moment in which they are done; a number that is missing, or a connection
 * that was broken, is heard as `missed`. A relay that does not give a sign of life for three seconds counts as
 * dead, and the pages that it had as away; one that was not dead after all lets its pages connect anew.
 */
import {
  aliveDriverSchema,
  driversSchema,
  hasEnded,
  recallCauses,
  scriptSchema,
} from "@corridor/protocol";
import type { Logger } from "pino";
import { z } from "zod";
import type { Clock } from "../clock.ts";
import type { CarriedSnapshot } from "../sessions/carried-snapshot.ts";
import { limits } from "../sessions/limits.ts";
import { asked, type Redis } from "../store/redis/connection.ts";
import { lineOf, postOf, RELAYS, sessionOf } from "../store/redis/redis-keys.ts";
import { termedRow } from "../store/redis/rows.ts";
import { Script } from "../store/redis/script.ts";
import { readPost, SnapshotPost } from "./snapshot-post.ts";
import type { Ears, Line, News, Switchboard } from "./switchboard.ts";

const BEAT_MS = 1_000;
/** A relay that was silent for so long counts as dead. */
const ALIVE_MS = 3_000;
/** While nothing can be heard, keys may be revoked unheard: those that count are asked for this often. */
const DEAF_LOOK_MS = 300;

/** of a page; an earlier Corridor kept none */
const name = z.string().default("");
const holderSchema = z.object({ relay: z.string(), epoch: z.int(), name });
const beatSchema = z.object({ lapsed: z.boolean(), holders: z.array(holderSchema.nullable()) });
const scriptsSchema = driversSchema.extend({
  alive: z.array(aliveDriverSchema),
  scripts: z.array(scriptSchema),
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
    saidGoodbye: z.boolean().default(false),
  }),
  z.object({ kind: z.literal("yield"), from, epoch }),
  z.object({ kind: z.literal("yielded"), from, epoch }),
  z.object({ kind: z.literal("here"), from, scripts: scriptsSchema, asks: z.boolean() }),
  z.object({ kind: z.literal("cancel"), from, seq: z.int(), why: z.enum(recallCauses) }),
  z.object({ kind: z.literal("keys"), from }),
  z.object({ kind: z.literal("maze"), from, version: z.string() }),
  z.object({ kind: z.literal("over"), from }),
]);
type Message = z.infer<typeof messageSchema>;

interface Place {
  ears: Ears;
  /** number of the newest step that was heard; null: none yet */
  n: number | null;
  /** the other relay that has the page, as far as this one knows */
  holder: z.infer<typeof holderSchema> | null;
  /** this relay has it */
  isOwn: boolean;
  /** how often news of the page came: an answer that was on its way meanwhile is older */
  pageNews: number;
  /** other relays that hold the robot, and when they said so */
  others: Map<string, number>;
}

export interface RedisSwitchboardOptions {
  redis: Redis;
  /** a connection of its own, for what is heard */
  hearing: Redis;
  relay: string;
  clock: Clock;
  log: Logger;
}

export class RedisSwitchboard implements Switchboard {
  readonly #options: RedisSwitchboardOptions;
  readonly #script: Script;
  readonly #places = new Map<string, Place>();
  readonly #post: SnapshotPost;
  /** how news begin that this relay is here: most of what it hears of itself, and nothing to it */
  readonly #ownPresence: string;
  #cancelTimer: () => void = () => undefined;
  #cancelLook: () => void = () => undefined;
  #isClosed = false;
  /** no sign of life was asked for on the line to hear by that has not come */
  #isAnswered = true;

  private constructor(options: RedisSwitchboardOptions) {
    this.#options = options;
    this.#script = new Script(options.redis, "../../cluster/switchboard.lua", [options.relay]);
    this.#ownPresence = JSON.stringify({ kind: "here", from: options.relay }).slice(0, -1);
    this.#post = new SnapshotPost(options.clock, (relay, post) => {
      // Lost with the connection: the next one is newer.
      options.redis.publish(postOf(relay), post).catch(() => undefined);
    });
  }

  /** Opens the switchboard; from now on this relay counts as alive. */
  static async open(options: RedisSwitchboardOptions): Promise<RedisSwitchboard> {
    const switchboard = new RedisSwitchboard(options);
    await asked(
      options.hearing.subscribe(
        postOf(options.relay),
        (post) => {
          for (const [robot, snapshot] of readPost(post) ?? []) {
            switchboard.#places.get(robot)?.ears.heard({ kind: "snapshot", snapshot });
          }
        },
        true,
      ),
    );
    await switchboard.#beat();
    // The client listens again by itself, but nobody keeps for it what was said meanwhile.
    options.hearing.on("ready", () => {
      switchboard.#isAnswered = true;
      switchboard.#missed();
    });
    switchboard.#lookWhileDeaf();
    return switchboard;
  }

  async join(robot: string, ears: Ears): Promise<Line> {
    const { hearing, relay, log } = this.#options;
    const others = new Map<string, number>();
    const place: Place = { ears, n: null, holder: null, isOwn: false, pageNews: 0, others };
    const hear = (text: string): void => {
      if (text.startsWith(this.#ownPresence)) return;
      const message = messageSchema.safeParse(JSON.parse(text));
      if (message.success) this.#hear(place, message.data);
      else
        log.warn({ err: message.error }, "another relay said something that this one cannot read");
    };
    const channel = lineOf(robot);
    await asked(hearing.subscribe(channel, hear));
    this.#places.set(robot, place);
    const holder = holderSchema.nullable().parse(await this.#run("holder", robot));
    if (holder !== null && holder.relay !== relay && place.holder === null) {
      place.holder = holder;
      ears.heard({ kind: "page", epoch: holder.epoch, name: holder.name });
    }
    return {
      // The script that did the step has told it.
      stepped: () => undefined,
      tell: (news) => this.#tell(robot, news),
      // By the same connection as the steps, so that it arrives in this order, too.
      hurry: () => this.#post.flush(),
      leave: () => {
        if (this.#places.get(robot) === place) this.#places.delete(robot);
        hearing.unsubscribe(channel, hear).catch(() => undefined);
      },
    };
  }

  async close(): Promise<void> {
    this.#isClosed = true;
    this.#cancelTimer();
    this.#cancelLook();
    this.#post.close();
    this.#places.clear();
    await this.#run("stop", "").catch(() => undefined);
  }

  #tell(robot: string, news: News): void {
    const { redis, relay, log } = this.#options;
    // The script of the store has told it, a page with the new epoch.
    if (news.kind === "page" || news.kind === "keys" || news.kind === "over") return;
    if (news.kind === "snapshot") return this.#tellSnapshot(robot, news.snapshot);
    const told =
      news.kind === "page-left"
        ? this.#run("left", robot, { epoch: news.epoch, saidGoodbye: news.saidGoodbye })
        : redis.publish(lineOf(robot), JSON.stringify({ ...news, from: relay }));
    told.catch((error: unknown) =>
      log.debug({ err: error }, "news did not reach the other relays"),
    );
  }

  #tellSnapshot(robot: string, snapshot: CarriedSnapshot): void {
    const others = this.#places.get(robot)?.others;
    if (others === undefined) return;
    const oldest = this.#options.clock.now() - limits.relaySilenceMs;
    for (const [relay, heardAt] of others) if (heardAt < oldest) others.delete(relay);
    this.#post.post(robot, snapshot, others.keys());
  }

  #hear(place: Place, message: Message): void {
    const { relay } = this.#options;
    if (message.kind === "step") return this.#hearStep(place, message);
    const isOwn = message.from === relay;
    if (message.kind === "page" || message.kind === "page-left") {
      place.pageNews += 1;
      place.isOwn = message.kind === "page" && isOwn;
      place.holder = message.kind === "page" && !isOwn ? { ...message, relay: message.from } : null;
    }
    if (isOwn) return;
    if (message.kind === "here") place.others.set(message.from, this.#options.clock.now());
    place.ears.heard(message);
  }

  #hearStep(place: Place, { n, from: teller, added, changed }: Message & { kind: "step" }): void {
    if (place.n !== null && n !== place.n + 1) place.ears.missed();
    place.n = n;
    const ended = changed.filter(({ record }) => hasEnded(record.state));
    const step = { added, ended, changed: changed.map(({ record }) => record) };
    place.ears.stepped(step, teller === this.#options.relay);
  }

  #missed(): void {
    for (const place of this.#places.values()) {
      place.n = null;
      place.ears.missed();
    }
    if (!this.#isClosed) this.#look().catch(() => undefined);
  }

  #lookWhileDeaf(): void {
    const { clock, hearing, redis } = this.#options;
    if (!hearing.isReady) this.#keysMayHaveChanged();
    else if (this.#isAnswered) this.#askForLife();
    else {
      // Cut without a word, or Redis stands still: then nobody revokes a key either, and nobody is sent away.
      redis.ping().then(
        () => this.#isAnswered || this.#keysMayHaveChanged(),
        () => undefined,
      );
    }
    this.#cancelLook = clock.after(DEAF_LOOK_MS, () => this.#lookWhileDeaf());
  }

  #askForLife(): void {
    this.#isAnswered = false;
    const heard = (): void => void (this.#isAnswered = true);
    // An error is an answer, or the line is known to be broken.
    this.#options.hearing.ping().then(heard, heard);
  }

  #keysMayHaveChanged(): void {
    for (const { ears } of this.#places.values()) ears.heard({ kind: "keys" });
  }

  async #beat(): Promise<void> {
    try {
      await this.#look();
    } catch (error) {
      this.#options.log.debug({ err: error }, "no sign of life could be given");
    }
    if (this.#isClosed) return;
    this.#cancelTimer = this.#options.clock.after(BEAT_MS, () => void this.#beat());
  }

  /** Gives a sign of life, and looks where the pages are: their relays may be dead, or not be dead after all. */
  async #look(): Promise<void> {
    const places = [...this.#places].map(([robot, place]) => ({
      session: sessionOf(robot),
      place,
      pageNews: place.pageNews,
    }));
    const sessions = places.map(({ session }) => session);
    const answer = beatSchema.parse(await this.#run("beat", "", { ms: ALIVE_MS, sessions }));
    for (const [index, { place, pageNews }] of places.entries()) {
      if (place.isOwn && answer.lapsed) place.ears.heard({ kind: "lapsed" });
      else if (!place.isOwn && place.pageNews === pageNews)
        this.#learnHolder(place, answer.holders[index] ?? null);
    }
  }

  #learnHolder(place: Place, holder: Place["holder"]): void {
    const before = place.holder;
    const isOther = holder?.relay !== this.#options.relay;
    place.holder = isOther ? holder : null;
    if (place.holder?.epoch === before?.epoch) return;
    if (place.holder !== null) {
      place.ears.heard({ kind: "page", epoch: place.holder.epoch, name: place.holder.name });
    } else if (before !== null) {
      place.ears.heard({ kind: "page-left", epoch: before.epoch, saidGoodbye: false });
    }
  }

  async #run(step: string, robot: string, values: unknown = {}): Promise<unknown> {
    return this.#script.run(step, [sessionOf(robot), lineOf(robot), RELAYS], values);
  }
}
