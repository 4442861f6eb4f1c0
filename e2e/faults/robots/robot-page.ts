/**
 * A page that is the robot, as its worker is: run, driver, host and link, on real timers and
 * sockets.
 */
import { decodeFrame, relayToPageSchema } from "@corridor/protocol";
import { RemoteDriver } from "../../../apps/web/src/drivers/remote-driver.ts";
import { firstMaze, firstProgram } from "../../../apps/web/src/worker/first-work.ts";
import { RemoteHost } from "../../../apps/web/src/worker/remote-host.ts";
import { RunLoop } from "../../../apps/web/src/worker/run-loop.ts";
import { machineNow } from "../clock.ts";
import { overheard, platformWith } from "../platforms.ts";
import type { FromPages, ToPages } from "./page-messages.ts";

/** As the worker does it (simulator.worker.ts). */
const RELAY_INTERVAL_MS = 50;
const RELAY_HEARTBEAT_MS = 1000;

type Opening = Extract<ToPages, { do: "open" }>;

export class RobotPage {
  readonly #number: number;
  readonly #tell: (message: FromPages) => void;
  readonly #loop: RunLoop;
  readonly #host: RemoteHost;
  #isMoving = false;
  #where = "";
  #sentAt = Number.NEGATIVE_INFINITY;
  #hasUnsentNews = false;

  constructor({ page, origin, session, doors }: Opening, tell: (message: FromPages) => void) {
    this.#number = page;
    this.#tell = tell;
    this.#loop = new RunLoop(firstMaze, firstProgram, () => performance.now());
    this.#host = new RemoteHost({
      origin,
      now: () => Date.now(),
      snapshot: () => this.#loop.snapshot(),
      onView: ({ session: kept, status }) => {
        if (kept !== null) tell({ tells: "session", page, session: kept });
        tell({ tells: "status", page, status, at: machineNow() });
      },
      onDelivery: (delivery) => this.#loop.accept(delivery),
      cancel: (reason) => this.#loop.cancelRemote(reason),
      takeBack: (seq) => this.#loop.remote?.takeBack(seq),
      giveBack: () => this.#loop.remote?.giveBack(),
      hear: (alive) => this.#loop.remote?.hear(alive),
      fetch: () => Promise.reject(new Error("The robot is registered already.")),
      platform: overheard(platformWith(doors), (direction, text) => {
        if (direction === "down") this.#hears(text);
      }),
    });
    const events = {
      started: (seq: number) => {
        tell({ tells: "deed", page, seq, what: "started", at: machineNow() });
        this.#host.started(seq);
      },
      ended: (seq: number, ending: Parameters<RemoteHost["ended"]>[1]) => {
        tell({ tells: "deed", page, seq, what: ending.state, at: machineNow() });
        this.#host.ended(seq, ending);
      },
    };
    this.#loop.connect((robot) => new RemoteDriver(events, robot, () => performance.now()));
    this.#loop.setDriver("remote");
    this.#host.open(session, true);
  }

  /** As time passes; as often as the worker does it. */
  turn(): void {
    this.#loop.advance();
    this.#hasUnsentNews ||= this.#loop.takeNews() !== null;
    this.#loop.takeTimeline();
    this.#watchMotion();
    const wait = this.#hasUnsentNews ? RELAY_INTERVAL_MS : RELAY_HEARTBEAT_MS;
    if (!this.#host.isOpen || performance.now() - this.#sentAt < wait) return;
    this.#sentAt = performance.now();
    this.#hasUnsentNews = false;
    this.#host.sendSnapshot(this.#loop.snapshot());
  }

  /** The tab is closed: its line goes, and nobody asks what it would have said. */
  leave(): void {
    this.#host.close();
  }

  /**
   * When the relay, by the clock of the same machine, has given it the robot, and until when each
   * command holds.
   */
  #hears(text: string): void {
    const read = decodeFrame(relayToPageSchema, text);
    if (!read.ok) return;
    if (read.value.type === "command" || read.value.type === "stop") {
      const { seq, at: sentAt, remaining } = read.value;
      this.#tell({ tells: "given", page: this.#number, seq, deadline: sentAt + remaining });
    }
    if (read.value.type !== "welcome") return;
    const at = machineNow() - Math.max(0, Date.now() - read.value.at);
    this.#tell({ tells: "taken", page: this.#number, at });
  }

  #watchMotion(): void {
    const { x, y, heading } = this.#loop.snapshot().pose;
    const where = `${x} ${y} ${heading}`;
    const isMoving = this.#where !== "" && where !== this.#where;
    this.#where = where;
    if (isMoving === this.#isMoving) return;
    this.#isMoving = isMoving;
    this.#tell({ tells: "motion", page: this.#number, isMoving, at: machineNow() });
  }
}
