/**
 * Lines over Redis: a channel for each robot that this relay holds. The scripts of the store tell the
 * steps there, numbered, in the moment in which they are done; a number that is missing, or a connection
 * that was broken, is heard as `missed`. A relay that does not give a sign of life for three seconds counts as
 * dead, and the pages that it had as away.
 */
import { aliveDriverSchema, driversSchema, hasEnded, type Snapshot } from "@corridor/protocol";
import type { Logger } from "pino";
import { z } from "zod";
import type { Clock } from "../clock.ts";
import { limits } from "../sessions/limits.ts";
import { asked, type Redis } from "../store/redis/connection.ts";
import { lineOf, postOf, sessionOf } from "../store/redis/redis-keys.ts";
import { termedRow } from "../store/redis/rows.ts";
import { Script } from "../store/redis/script.ts";
import { readPost, SnapshotPost } from "./snapshot-post.ts";
import type { Ears, Line, News, Switchboard } from "./switchboard.ts";

const BEAT_MS = 1_000;
/** A relay that was silent for so long counts as dead. */
const ALIVE_MS = 3_000;
/** While nothing can be heard, keys may be revoked unheard: those that count are asked for this often. */
const DEAF_LOOK_MS = 400;
const RELAYS = "corridor:relays";

const holderSchema = z.object({ relay: z.string(), epoch: z.int() });
const scriptsSchema = driversSchema.extend({ alive: z.array(aliveDriverSchema) });
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
  z.object({ kind: z.literal("page"), from, epoch }),
  z.object({ kind: z.literal("page-left"), from, epoch }),
  z.object({ kind: z.literal("here"), from, scripts: scriptsSchema, asks: z.boolean() }),
  z.object({ kind: z.literal("cancel"), from, seq: z.int() }),
  z.object({ kind: z.literal("keys"), from }),
  z.object({ kind: z.literal("over"), from }),
]);
type Message = z.infer<typeof messageSchema>;

interface Place {
  ears: Ears;
  /** number of the newest step that was heard; null: none yet */
  n: number | null;
  /** the relay that has the page, as far as this one knows */
  holder: z.infer<typeof holderSchema> | null;
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
  #cancelTimer: () => void = () => undefined;
  #cancelLook: () => void = () => undefined;
  #isClosed = false;

  private constructor(options: RedisSwitchboardOptions) {
    this.#options = options;
    this.#script = new Script(options.redis, "../../cluster/switchboard.lua", [options.relay]);
    this.#post = new SnapshotPost(options.clock, (relay, text) => {
      // Lost with the connection: the next one is newer.
      options.redis.publish(postOf(relay), text).catch(() => undefined);
    });
  }

  /** Opens the switchboard; from now on this relay counts as alive. */
  static async open(options: RedisSwitchboardOptions): Promise<RedisSwitchboard> {
    const switchboard = new RedisSwitchboard(options);
    await asked(
      options.hearing.subscribe(postOf(options.relay), (text) => {
        for (const [robot, snapshot] of Object.entries(readPost(text) ?? {})) {
          switchboard.#places.get(robot)?.ears.heard({ kind: "snapshot", snapshot });
        }
      }),
    );
    await switchboard.#beat();
    // The client listens again by itself, but nobody keeps for it what was said meanwhile.
    options.hearing.on("ready", () => switchboard.#missed());
    switchboard.#lookWhileDeaf();
    return switchboard;
  }

  async join(robot: string, ears: Ears): Promise<Line> {
    const { hearing, relay, log } = this.#options;
    const place: Place = { ears, n: null, holder: null, others: new Map() };
    const hear = (text: string): void => {
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
      ears.heard({ kind: "page", epoch: holder.epoch });
    }
    return {
      // The script that did the step has told it.
      stepped: () => undefined,
      tell: (news) => this.#tell(robot, news),
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
        ? this.#run("left", robot, { epoch: news.epoch })
        : redis.publish(lineOf(robot), JSON.stringify({ ...news, from: relay }));
    told.catch((error: unknown) =>
      log.debug({ err: error }, "news did not reach the other relays"),
    );
  }

  #tellSnapshot(robot: string, snapshot: Snapshot): void {
    const others = this.#places.get(robot)?.others;
    if (others === undefined) return;
    const oldest = this.#options.clock.now() - limits.relaySilenceMs;
    for (const [relay, heardAt] of others) if (heardAt < oldest) others.delete(relay);
    this.#post.post(robot, snapshot, others.keys());
  }

  #hear(place: Place, message: Message): void {
    const { relay } = this.#options;
    if (message.kind === "step") return this.#hearStep(place, message);
    if (message.from === relay) {
      if (message.kind === "page") place.holder = null;
      return;
    }
    if (message.kind === "page") place.holder = { relay: message.from, epoch: message.epoch };
    if (message.kind === "page-left") place.holder = null;
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
  }

  #lookWhileDeaf(): void {
    const { clock, hearing } = this.#options;
    if (!hearing.isReady) {
      for (const { ears } of this.#places.values()) ears.heard({ kind: "keys" });
    }
    this.#cancelLook = clock.after(DEAF_LOOK_MS, () => this.#lookWhileDeaf());
  }

  /** Gives a sign of life, and looks for those who do not any more. */
  async #beat(): Promise<void> {
    try {
      const alive = new Set(
        z.array(z.string()).parse(await this.#run("beat", "", { ms: ALIVE_MS })),
      );
      for (const place of this.#places.values()) {
        const { holder } = place;
        if (holder === null || alive.has(holder.relay)) continue;
        place.holder = null;
        place.ears.heard({ kind: "page-left", epoch: holder.epoch });
      }
    } catch (error) {
      this.#options.log.debug({ err: error }, "no sign of life could be given");
    }
    if (this.#isClosed) return;
    this.#cancelTimer = this.#options.clock.after(BEAT_MS, () => void this.#beat());
  }

  async #run(step: string, robot: string, values: unknown = {}): Promise<unknown> {
    return this.#script.run(step, [sessionOf(robot), lineOf(robot), RELAYS], values);
  }
}
