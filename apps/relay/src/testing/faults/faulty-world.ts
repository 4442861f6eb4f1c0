/**
 * A script, a relay and a page, linked by lines that break, in a time of their own. What happens is
 * chance, and the same for the same seed: commands, cuts, kills of the relay, reloads of the page, second pages.
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
import { Dice } from "./dice.ts";
import { FaultyNet, type Tap } from "./faulty-net.ts";
import { FaultyPage, type Tab } from "./faulty-page.ts";
import { Backing, FaultyRelay } from "./faulty-relay.ts";
import { History } from "./history.ts";
import { VirtualTime } from "./virtual-time.ts";

/** Long ones hide what short ones show. */
const TTLS = [400, 400, 2_000, 10_000];
/** A command crosses two lines, and the robot looks at its clock at each step. */
const TOLERANCE_MS = 120;
/** After which no command waits any more, and every client has come back. */
const HEALING_MS = 30_000;

export class FaultyWorld {
  readonly #time = new VirtualTime();
  readonly #dice: Dice;
  readonly #backing: Backing;
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
  /** the page that a relay has given the robot last: only what that one does the robot has done */
  #robot = 0;
  /** earlier pages, which have not left */
  readonly #others: FaultyPage[] = [];
  #script: RobotClient | null = null;
  #keys = 0;

  private constructor(seed: number, backing: Backing, robot: Registration) {
    this.#dice = new Dice(seed);
    this.#backing = backing;
    this.#registration = robot;
    this.#tab = { session: { ...robot, lastApplied: 0 } };
    const net = (tap: Tap): FaultyNet =>
      new FaultyNet(this.#time, this.#dice, () => this.#anyRelay(), robot.id, tap);
    this.#pageNet = net(() => undefined);
    this.#scriptNet = net((direction, text) => this.#tapScript(direction, text));
  }

  /**
   * @param folder for the database
   * @param relays how many share it
   */
  static async run(
    seed: number,
    folder: string,
    steps: number,
    relays: 1 | 2 = 1,
  ): Promise<string[]> {
    const backing = new Backing(join(folder, `${seed}-${relays}.sqlite`));
    const time = new VirtualTime();
    const first = new FaultyRelay(backing, time);
    const robot = await first.hub.register("10.0.0.1", "http://robots.example");
    first.kill();
    const world = new FaultyWorld(seed, backing, robot);
    return world.#live(steps, relays);
  }

  async #live(steps: number, relays: number): Promise<string[]> {
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
    await this.#heal();
    const stored = await this.#backing.store.commandsAfter(this.#registration.id, 0, 10_000);
    this.#script.close();
    for (const page of [this.#page, ...this.#others]) page?.leave();
    for (const relay of this.#relays) relay.kill();
    await turn();
    await this.#backing.store.close();
    return this.#history.check(stored).map(({ words }) => words);
  }

  async #step(): Promise<void> {
    const dice = this.#dice;
    const chance = dice.next();
    if (chance < 0.4) this.#command();
    else if (chance < 0.43) this.#takeBack();
    else if (chance < 0.46) this.#pageNet.cut();
    else if (chance < 0.49) this.#scriptNet.cut();
    else if (chance < 0.51) this.#breakFor(this.#pageNet, dice.between(50, 3_000));
    else if (chance < 0.53) this.#breakFor(this.#scriptNet, dice.between(50, 3_000));
    else if (chance < 0.55) this.#killRelay();
    else if (chance < 0.57) this.#loadPage();
    else if (chance < 0.58) this.#page?.freeze(dice.between(100, 6_000));
    else if (chance < 0.59) this.#pageNet.holdUp(dice.between(100, 4_000));
    else if (chance < 0.592) this.#breakFor(this.#pageNet, 125_000);
    else if (chance < 0.61) this.#openSecondPage();
    await this.#time.pass(dice.isLucky(0.9) ? dice.between(0, 150) : dice.between(150, 2_000));
  }

  #command(): void {
    const script = this.#script;
    if (script === null) return;
    const dice = this.#dice;
    const wish = { ttl: dice.pick(TTLS), replace: dice.isLucky(0.08) };
    const send = dice.pick([
      () => script.move(dice.between(-60, 90), wish),
      () => script.move(dice.between(5, 30), wish),
      () => script.turn(dice.between(-90, 90), wish),
      () => script.left90(wish),
      () => script.forward(wish),
      () => script.drive(0.2, 0.3, undefined, wish),
      () => script.drive(0.2, -0.2, 300, wish),
      () => (dice.isLucky(0.3) ? script.stop(wish) : script.right90(wish)),
    ]);
    // How it ended is checked against what the store has.
    send().catch(() => undefined);
    this.#time.touch();
  }

  #takeBack(): void {
    const relay = this.#anyRelay();
    if (!relay.isAlive) return;
    const { hub } = relay;
    const { id, driverKey } = this.#registration;
    const back = this.#dice.between(0, 4);
    this.#time.touch();
    void (async () => {
      const { session, key } = await hub.authorise(id, driverKey, "command");
      const { seq = 0 } = (await session.commandsAfter(0)).at(-1) ?? {};
      await session.cancel(key, seq - back);
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
    this.#time.after(this.#dice.between(20, 1_500), () => this.#startRelay(n));
  }

  #startRelay(n: number): void {
    if (this.#relays[n]?.isAlive === true) return;
    this.#relays[n] = new FaultyRelay(this.#backing, this.#time);
  }

  /** The one that a balancer happens to choose. */
  #anyRelay(): FaultyRelay {
    const alive = this.#relays.filter(({ isAlive }) => isAlive);
    const [only] = this.#relays;
    if (only === undefined) throw new Error("there is no relay yet");
    if (this.#relays.length === 1 || alive.length === 0) return only;
    return this.#dice.pick(alive);
  }

  #loadPage(): void {
    if (this.#page !== null) {
      const saysGoodbye = this.#pages % 2 === 0;
      this.#page.leave(saysGoodbye);
      this.#history.left(this.#pages);
      if (!saysGoodbye) this.#pageNet.cut();
    }
    this.#openPage();
  }

  /** The tab is doubled, with all that it keeps. */
  #openSecondPage(): void {
    if (this.#page !== null) this.#others.push(this.#page);
    this.#tab = { session: { ...this.#tab.session } };
    this.#openPage();
  }

  #openPage(): void {
    const number = ++this.#pages;
    const net = this.#pageNet;
    const told = (text: string): void => {
      if (text.startsWith('{"type":"welcome"')) this.#robot = number;
    };
    const page: FaultyPage = new FaultyPage({
      tab: this.#tab,
      time: this.#time,
      platform: { ...this.#platform(net), connect: (_url, events) => net.connect(events, told) },
      did: (seq, what) => {
        if (number === this.#robot && page.isAlive) {
          this.#history.did({ seq, what, page: number, at: this.#time.now() });
        }
      },
    });
    this.#page = page;
  }

  async #heal(): Promise<void> {
    this.#pageNet.isUp = true;
    this.#scriptNet.isUp = true;
    for (const n of this.#relays.keys()) this.#startRelay(n);
    await this.#time.pass(HEALING_MS);
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
    const told = read.value as { type: string; record: CommandRecord };
    if (told.type === "ack") this.#history.acknowledged(told.record);
    if (told.type === "state") this.#history.told(told.record);
  }

  #platform(net: FaultyNet) {
    return {
      connect: (_url: string, events: Parameters<FaultyNet["connect"]>[0]) => net.connect(events),
      clock: this.#time,
      random: () => this.#dice.next(),
      uniqueText: () => `key-${String((this.#keys += 1)).padStart(8, "0")}`,
    };
  }
}
