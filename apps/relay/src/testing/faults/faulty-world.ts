/**
 * A script, a relay and a page on unreliable connections, in virtual time. Events are random and
 * repeatable by seed: commands, disconnections, relay crashes, page reloads, second pages.
 */
import { join } from "node:path";
import { setImmediate as turn } from "node:timers/promises";
import {
  relayToDriverSchema,
  decodeFrame,
  driverToRelaySchema,
  TTL_MS,
  type CommandRecord,
  type Registration,
} from "@corridor/protocol";
import { RobotClient } from "../../../../../packages/client/src/robot-client.ts";
import { SeededRandom } from "./seeded-random.ts";
import { FaultyNet, type Tap } from "./faulty-net.ts";
import { FaultyPage, type Tab } from "./faulty-page.ts";
import { Backend, FaultyRelay } from "./faulty-relay.ts";
import { History } from "./history.ts";
import { VirtualTime } from "./virtual-time.ts";

/** Mostly short, because long values hide faults. */
const TTLS = [400, 400, 2_000, 10_000];
/** A command crosses two connections, and the robot checks its clock on each step. */
const TOLERANCE_MS = 120;
/** After this time no command waits, and every client has reconnected. */
const RECOVERY_MS = 30_000;

export class FaultyWorld {
  readonly #time = new VirtualTime();
  readonly #random: SeededRandom;
  readonly #backend: Backend;
  readonly #history = new History(TOLERANCE_MS);
  readonly #registration: Registration;
  /** of the newest page */
  #tab: Tab;
  readonly #pageNet: FaultyNet;
  readonly #scriptNet: FaultyNet;
  /** one, or two that share the store */
  readonly #relays: FaultyRelay[] = [];
  #page: FaultyPage | null = null;
  #pages = 0;
  /** the page that last acquired the robot; only its actions count */
  #robot = 0;
  /** earlier pages that are still open */
  readonly #others: FaultyPage[] = [];
  #script: RobotClient | null = null;
  #keys = 0;

  private constructor(seed: number, backend: Backend, robot: Registration) {
    this.#random = new SeededRandom(seed);
    this.#backend = backend;
    this.#registration = robot;
    this.#tab = { session: { ...robot, lastApplied: 0 } };
    const net = (tap: Tap): FaultyNet =>
      new FaultyNet(this.#time, this.#random, () => this.#anyRelay(), robot.id, tap);
    this.#pageNet = net(() => undefined);
    this.#scriptNet = net((direction, text) => this.#tapScript(direction, text));
  }

  /**
   * @param folder for the database
   * @param relays number of relays that share it
   */
  static async run(
    seed: number,
    folder: string,
    steps: number,
    relays: 1 | 2 = 1,
  ): Promise<string[]> {
    const backend = new Backend(join(folder, `${seed}-${relays}.sqlite`));
    const time = new VirtualTime();
    const first = new FaultyRelay(backend, time);
    const robot = await first.registry.register("10.0.0.1", "http://robots.example");
    first.kill();
    const world = new FaultyWorld(seed, backend, robot);
    return world.#simulate(steps, relays);
  }

  async #simulate(steps: number, relays: number): Promise<string[]> {
    for (let n = 0; n < relays; n++) this.#startRelay(n);
    this.#loadPage();
    const connecting = RobotClient.connect(this.#registration.address, {
      platform: this.#platform(this.#scriptNet),
      answerTimeout: 20_000,
      finishTimeout: 60_000,
    });
    await this.#time.pass(500);
    this.#script = await connecting;
    for (let n = 0; n < steps; n++) await this.#step();
    await this.#recover();
    const stored = await this.#backend.store.commandsAfter(this.#registration.id, 0, 10_000);
    this.#script.close();
    for (const page of [this.#page, ...this.#others]) page?.leave();
    for (const relay of this.#relays) relay.kill();
    await turn();
    await this.#backend.store.close();
    return this.#history.check(stored).map(({ words }) => words);
  }

  async #step(): Promise<void> {
    const random = this.#random;
    const chance = random.next();
    if (chance < 0.4) this.#command();
    else if (chance < 0.43) this.#cancel();
    else if (chance < 0.46) this.#pageNet.cut();
    else if (chance < 0.49) this.#scriptNet.cut();
    else if (chance < 0.51) this.#breakFor(this.#pageNet, random.between(50, 3_000));
    else if (chance < 0.53) this.#breakFor(this.#scriptNet, random.between(50, 3_000));
    else if (chance < 0.55) this.#killRelay();
    else if (chance < 0.57) this.#loadPage();
    else if (chance < 0.58) this.#page?.freeze(random.between(100, 6_000));
    else if (chance < 0.59) this.#pageNet.holdUp(random.between(100, 4_000));
    else if (chance < 0.592) this.#breakFor(this.#pageNet, 125_000);
    else if (chance < 0.61) this.#openSecondPage();
    await this.#time.pass(random.chance(0.9) ? random.between(0, 150) : random.between(150, 2_000));
  }

  #command(): void {
    const script = this.#script;
    if (script === null) return;
    const random = this.#random;
    const terms = { ttl: random.pick(TTLS), replace: random.chance(0.08) };
    const send = random.pick([
      () => script.move(random.between(-60, 90), terms),
      () => script.move(random.between(5, 30), terms),
      () => script.turn(random.between(-90, 90), terms),
      () => script.left90(terms),
      () => script.forward(terms),
      () => script.drive(0.2, 0.3, undefined, terms),
      () => script.drive(0.2, -0.2, 300, terms),
      () => (random.chance(0.3) ? script.stop(terms) : script.right90(terms)),
    ]);
    // The history compares its ending with the store.
    send().catch(() => undefined);
    this.#time.touch();
  }

  #cancel(): void {
    const relay = this.#anyRelay();
    if (!relay.isAlive) return;
    const { registry } = relay;
    const { id, driverKey } = this.#registration;
    const back = this.#random.between(0, 4);
    this.#time.touch();
    void (async () => {
      const { robot, caller } = await registry.authorise(id, driverKey, "command");
      const { seq = 0 } = (await robot.commandsAfter(0)).at(-1) ?? {};
      await robot.cancel(caller, seq - back);
    })().catch(() => undefined);
  }

  #breakFor(net: FaultyNet, ms: number): void {
    net.isUp = false;
    net.cut();
    this.#time.after(ms, () => {
      net.isUp = true;
    });
  }

  #killRelay(): void {
    const relay = this.#anyRelay();
    if (!relay.isAlive) return;
    const n = this.#relays.indexOf(relay);
    relay.kill();
    this.#pageNet.cut();
    this.#scriptNet.cut();
    this.#time.after(this.#random.between(20, 1_500), () => this.#startRelay(n));
  }

  #startRelay(n: number): void {
    if (this.#relays[n]?.isAlive === true) return;
    this.#relays[n] = new FaultyRelay(this.#backend, this.#time);
  }

  /** A random live relay, as a load balancer would choose. */
  #anyRelay(): FaultyRelay {
    const alive = this.#relays.filter(({ isAlive }) => isAlive);
    const [only] = this.#relays;
    if (only === undefined) throw new Error("there is no relay yet");
    if (this.#relays.length === 1 || alive.length === 0) return only;
    return this.#random.pick(alive);
  }

  #loadPage(): void {
    if (this.#page !== null) {
      const isClosed = this.#pages % 2 === 0;
      this.#page.leave(isClosed);
      this.#history.left(this.#pages);
      if (!isClosed) this.#pageNet.cut();
    }
    this.#openPage();
  }

  /** Duplicates the tab with its storage. */
  #openSecondPage(): void {
    if (this.#page !== null) this.#others.push(this.#page);
    this.#tab = { session: { ...this.#tab.session } };
    this.#openPage();
  }

  #openPage(): void {
    const number = ++this.#pages;
    const net = this.#pageNet;
    const onSent = (text: string): void => {
      if (text.startsWith('{"type":"welcome"')) this.#robot = number;
    };
    const page: FaultyPage = new FaultyPage({
      tab: this.#tab,
      time: this.#time,
      platform: { ...this.#platform(net), connect: (_url, events) => net.connect(events, onSent) },
      did: (seq, what) => {
        if (number === this.#robot && page.isAlive) {
          this.#history.did({ seq, what, page: number, at: this.#time.now() });
        }
      },
    });
    this.#page = page;
  }

  async #recover(): Promise<void> {
    this.#pageNet.isUp = true;
    this.#scriptNet.isUp = true;
    for (const n of this.#relays.keys()) this.#startRelay(n);
    await this.#time.pass(RECOVERY_MS);
  }

  #tapScript(direction: "up" | "down", text: string): void {
    this.#time.touch();
    if (direction === "up") {
      const read = decodeFrame(driverToRelaySchema, text);
      if (!read.ok || read.value.type !== "command") return;
      const { key = "", command } = read.value;
      const ttl = command.ttl ?? TTL_MS.default;
      this.#history.tried(key, { sender: "script", at: this.#time.now(), ttl });
      return;
    }
    const read = decodeFrame(relayToDriverSchema, text);
    if (!read.ok) return;
    const onSent = read.value as { type: string; record: CommandRecord };
    if (onSent.type === "ack") this.#history.acknowledged(onSent.record);
    if (onSent.type === "state") this.#history.reported(onSent.record);
  }

  #platform(net: FaultyNet) {
    return {
      connect: (_url: string, events: Parameters<FaultyNet["connect"]>[0]) => net.connect(events),
      clock: this.#time,
      random: () => this.#random.next(),
      uniqueText: () => `key-${String((this.#keys += 1)).padStart(8, "0")}`,
    };
  }
}
