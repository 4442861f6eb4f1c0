/**
 * The setup of most scenarios: robots at a relay, each with a page in a process that can be killed.
 */
import { registerRobot } from "../../packages/client/src/register-robot.ts";
import {
  faultKinds,
  type Fault,
  type FaultKind,
} from "../../apps/relay/src/testing/faults/history.ts";
import type { CommandRecord } from "@corridor/protocol";
import type { Goal } from "../../benches/core/goals.ts";
import { waitUntil } from "./clock.ts";
import type { Transports, FromPages } from "./robots/page-messages.ts";
import { Pages } from "./robots/pages.ts";
import { Robot } from "./robots/robot.ts";
import type { ScenarioContext } from "./scenario.ts";
import { RequestScript } from "./scripts/request-script.ts";
import type { Script } from "./scripts/script.ts";
import { ClientScript } from "./scripts/client-script.ts";

/** limit for connecting pages and for the end of commands; no goal depends on it */
const LONG_MS = 60_000;
const MAX_PRINTED_FAULTS = 12;

export class TestBed {
  readonly #context: ScenarioContext;
  readonly #byPage = new Map<number, Robot>();
  #newestPage = 0;
  readonly robots: Robot[] = [];

  constructor(context: ScenarioContext) {
    this.#context = context;
  }

  /** Starts a process of pages, which is killed after the scenario. */
  async startPages(): Promise<Pages> {
    const pages = await Pages.start((message) => this.#receive(message));
    this.#context.onCleanup(() => pages.kill());
    return pages;
  }

  /** Registers robots. @param origin of their relay, without faults so far */
  async register(origin: string, count: number): Promise<void> {
    for (let n = 0; n < count; n++) {
      this.robots.push(new Robot(await registerRobot(origin, fetch)));
    }
  }

  /** Opens a page that is the robot from now on, in place of any earlier page. */
  open(robot: Robot, pages: Pages, origin: string, transports: Transports): number {
    const page = (this.#newestPage += 1);
    this.#byPage.set(page, robot);
    robot.page = page;
    robot.status = { kind: "off" };
    const session = { ...robot.session };
    pages.send({ type: "open", page, origin, session, transports });
    return page;
  }

  /** Waits until every robot's page is connected to the relay. */
  async waitUntilConnected(withinMs = LONG_MS): Promise<number> {
    return waitUntil(() => this.robots.every(({ isConnected }) => isConnected), withinMs);
  }

  /**
   * Connects a script for each robot, with the kinds in turn.
   * @param originOf the address at which the script of a robot reaches its relay
   */
  async connectScripts(
    originOf: (robot: Robot) => string,
    kinds: readonly (Transports | "requests")[] = ["both", "https", "requests"],
  ): Promise<Script[]> {
    const connectScripts: Script[] = [];
    for (const [n, robot] of this.robots.entries()) {
      const kind = kinds[n % kinds.length] ?? "both";
      const origin = originOf(robot);
      const script =
        kind === "requests"
          ? new RequestScript(robot, origin)
          : await ClientScript.connect(robot, origin, kind);
      this.#context.onCleanup(() => script.close());
      connectScripts.push(script);
    }
    return connectScripts;
  }

  /**
   * Compares the histories of scripts, robots and relay.
   * @param origin of a relay without any remaining fault
   */
  async compare(origin: string): Promise<Comparison> {
    const logs = new Map<Robot, CommandRecord[]>();
    const faults: Fault[] = [];
    for (const robot of this.robots) {
      const compared = await robot.check(origin);
      logs.set(robot, compared.log);
      faults.push(...compared.faults);
    }
    const transitTimes = this.robots.map(({ history }) => history.longestTransit);
    this.#context.log(
      `a command needed at most ${Math.round(Math.max(...transitTimes))} ms to reach the relay`,
    );
    for (const { kind, words } of faults.slice(0, MAX_PRINTED_FAULTS)) {
      this.#context.log(`${kind}: ${words}`);
    }
    return new Comparison(faults, logs);
  }

  #receive(message: FromPages): void {
    if (message.type !== "ready") this.#byPage.get(message.page)?.receive(message);
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

  /** Goals that require zero faults of each kind. */
  goals(kinds: readonly FaultKind[] = faultKinds): Goal[] {
    return kinds.map((kind) => ({
      label: `commands ${kind}`,
      measured: this.#faults.filter((fault) => fault.kind === kind).length,
      bound: { atMost: 0 },
      unit: `of ${this.commands}`,
    }));
  }
}
