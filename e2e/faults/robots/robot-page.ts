/**
 * A page that is the robot, assembled as in its worker from run, driver, host and connection, on
 * real timers and sockets.
 */
import type { MazeDocument } from "@corridor/maze";
import { decodeFrame, relayToPageSchema } from "@corridor/protocol";
import { RemoteDriver } from "../../../apps/web/src/simulator/drivers/remote-driver.ts";
import { firstMaze, firstProgram } from "../../../apps/web/src/simulator/protocol/first-project.ts";
import type { Speed } from "../../../apps/web/src/simulator/protocol/worker-messages.ts";
import { RemoteHost } from "../../../apps/web/src/simulator/worker/remote-host.ts";
import { RunLoop } from "../../../apps/web/src/simulator/worker/run-loop.ts";
import { SnapshotThrottle } from "../../../apps/web/src/simulator/worker/snapshot-throttle.ts";
import { machineNow } from "../clock.ts";
import { withListener, platformFor } from "../platforms.ts";
import type { FromPages, ToPages } from "./page-messages.ts";

type OpenMessage = Extract<ToPages, { type: "open" }>;

export class RobotPage {
  readonly #number: number;
  readonly #report: (message: FromPages) => void;
  readonly #loop: RunLoop;
  readonly #host: RemoteHost;
  #isMoving = false;
  #lastPose = "";
  readonly #throttle = new SnapshotThrottle(() => performance.now());

  constructor(
    { page, origin, session, transports }: OpenMessage,
    report: (message: FromPages) => void,
    maze = firstMaze,
  ) {
    this.#number = page;
    this.#report = report;
    this.#loop = new RunLoop(maze, firstProgram, () => performance.now());
    this.#host = new RemoteHost({
      origin,
      now: () => Date.now(),
      snapshot: () => this.#loop.snapshot(),
      onView: ({ session: stored, status }) => {
        if (stored !== null) report({ type: "session", page, session: stored });
        report({ type: "status", page, status, at: machineNow() });
      },
      onDelivery: (delivery) => this.#loop.accept(delivery),
      cancel: (reason) => this.#loop.cancelRemote(reason),
      cancelOne: (seq) => this.#loop.remote?.cancelOne(seq),
      reset: () => this.#loop.remote?.reset(),
      renew: (alive) => this.#loop.remote?.renew(alive),
      fetch: () => Promise.reject(new Error("The robot is registered already.")),
      platform: withListener(platformFor(transports), (direction, text) => {
        if (direction === "down") this.#onReceived(text);
      }),
    });
    const events = {
      started: (seq: number) => {
        report({ type: "state", page, seq, state: "started", at: machineNow() });
        this.#host.started(seq);
      },
      ended: (seq: number, ending: Parameters<RemoteHost["ended"]>[1]) => {
        report({ type: "state", page, seq, state: ending.state, at: machineNow() });
        this.#host.ended(seq, ending);
      },
    };
    this.#loop.connect((robot) => new RemoteDriver(events, robot, () => performance.now()));
    this.#loop.setDriver("remote");
    this.#host.open(session, true);
  }

  /** Advances the page by the elapsed time. Called as often as in the worker. */
  advance(): void {
    this.#loop.advance();
    if (this.#loop.updates.take() !== null) this.#throttle.changed();
    this.#loop.updates.takeTimeline();
    this.#reportMotion();
    if (this.#host.isOpen && this.#throttle.take()) {
      this.#host.sendSnapshot(this.#loop.snapshot());
    }
  }

  setSpeed(speed: Speed): void {
    this.#loop.setSpeed(speed);
  }

  /** The next run, such as after a script's reset, starts in this maze. */
  editMaze(maze: MazeDocument): void {
    this.#loop.editMaze(maze);
  }

  /** Closes the tab: its connection closes without further messages. */
  close(): void {
    this.#host.close();
  }

  /** Reports when the relay assigned the robot to this page, and the deadline of each command. */
  #onReceived(text: string): void {
    const read = decodeFrame(relayToPageSchema, text);
    if (!read.ok) return;
    if (read.value.type === "command" || read.value.type === "stop") {
      const { seq, at: sentAt, remaining } = read.value;
      this.#report({ type: "delivered", page: this.#number, seq, deadline: sentAt + remaining });
    }
    if (read.value.type !== "welcome") return;
    const at = machineNow() - Math.max(0, Date.now() - read.value.at);
    this.#report({ type: "acquired", page: this.#number, at });
  }

  #reportMotion(): void {
    const { x, y, heading } = this.#loop.snapshot().pose;
    const pose = `${x} ${y} ${heading}`;
    const isMoving = this.#lastPose !== "" && pose !== this.#lastPose;
    this.#lastPose = pose;
    if (isMoving === this.#isMoving) return;
    this.#isMoving = isMoving;
    this.#report({ type: "motion", page: this.#number, isMoving, at: machineNow() });
  }
}
