/**
 * What most rows begin with: robots at a relay, each with a page, and a process of pages that may
 * go.
 */
import { registerRobot } from "../../packages/client/src/register-robot.ts";
import {
  faultKinds,
  type Fault,
  type FaultKind,
} from "../../apps/relay/src/testing/faults/history.ts";
import type { CommandRecord } from "@corridor/protocol";
import type { Goal } from "../../benches/core/goals.ts";
import { until } from "./clock.ts";
import type { Doors, FromPages } from "./robots/page-messages.ts";
import { Pages } from "./robots/pages.ts";
import { Robot } from "./robots/robot.ts";
import type { Terms } from "./row.ts";
import { RequestScript } from "./scripts/request-script.ts";
import type { Script } from "./scripts/script.ts";
import { SocketScript } from "./scripts/socket-script.ts";

/** Pages connect, and commands end, within this; nothing is judged by it. */
const LONG_MS = 60_000;
const SHOWN_FAULTS = 12;

export class Scene {
  readonly #terms: Terms;
  readonly #byPage = new Map<number, Robot>();
  #newestPage = 0;
  readonly robots: Robot[] = [];

  constructor(terms: Terms) {
    this.#terms = terms;
  }

  /** A process of pages; it ends with the row. */
  async startPages(): Promise<Pages> {
    const pages = await Pages.start((message) => this.#heard(message));
    this.#terms.after(() => pages.kill());
    return pages;
  }

  /** Registers so many robots. @param origin of their relay, which nothing disturbs yet */
  async register(origin: string, count: number): Promise<void> {
    for (let n = 0; n < count; n++) {
      this.robots.push(new Robot(await registerRobot(origin, fetch)));
    }
  }

  /** Opens a page, or a further one, that is the robot from now on. */
  open(robot: Robot, pages: Pages, origin: string, doors: Doors): number {
    const page = (this.#newestPage += 1);
    this.#byPage.set(page, robot);
    robot.page = page;
    robot.status = { kind: "off" };
    const session = { ...robot.session };
    pages.send({ do: "open", page, origin, session, doors });
    return page;
  }

  /** Waits until every robot has its page at the relay. */
  async allConnected(withinMs = LONG_MS): Promise<number> {
    return until(() => this.robots.every(({ isConnected }) => isConnected), withinMs);
  }

  /**
   * A script for each robot, of each kind in turn.
   * @param originOf through which the script of a robot reaches its relay
   */
  async scripts(
    originOf: (robot: Robot) => string,
    kinds: readonly (Doors | "requests")[] = ["both", "https", "requests"],
  ): Promise<Script[]> {
    const scripts: Script[] = [];
    for (const [n, robot] of this.robots.entries()) {
      const kind = kinds[n % kinds.length] ?? "both";
      const origin = originOf(robot);
      const script =
        kind === "requests"
          ? new RequestScript(robot, origin)
          : await SocketScript.connect(robot, origin, kind);
      this.#terms.after(() => script.close());
      scripts.push(script);
    }
    return scripts;
  }

  /**
   * Compares what scripts, robots and relay have seen.
   * @param origin of a relay that nothing disturbs any more
   */
  async compare(origin: string): Promise<Comparison> {
    const logs = new Map<Robot, CommandRecord[]>();
    const faults: Fault[] = [];
    for (const robot of this.robots) {
      const compared = await robot.check(origin);
      logs.set(robot, compared.log);
      faults.push(...compared.faults);
    }
    const ways = this.robots.map(({ history }) => history.longestWay);
    this.#terms.say(
      `a command was on its way to the relay for ${Math.round(Math.max(...ways))} ms at most`,
    );
    for (const { kind, words } of faults.slice(0, SHOWN_FAULTS)) {
      this.#terms.say(`${kind}: ${words}`);
    }
    return new Comparison(faults, logs);
  }

  #heard(message: FromPages): void {
    if (message.tells !== "ready") this.#byPage.get(message.page)?.heard(message);
  }
}

export class Comparison {
  readonly #faults: readonly Fault[];
  readonly logs: ReadonlyMap<Robot, CommandRecord[]>;

  constructor(faults: readonly Fault[], logs: ReadonlyMap<Robot, CommandRecord[]>) {
    this.#faults = faults;
    this.logs = logs;
  }

  get commands(): number {
    return [...this.logs.values()].reduce((sum, { length }) => sum + length, 0);
  }

  /** None of any kind of fault. */
  goals(kinds: readonly FaultKind[] = faultKinds): Goal[] {
    return kinds.map((kind) => ({
      label: `${kind} commands`,
      measured: this.#faults.filter((fault) => fault.kind === kind).length,
      bound: { atMost: 0 },
      unit: `of ${this.commands}`,
    }));
  }
}
