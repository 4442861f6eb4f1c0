/** A session for a connection, and what is printed about it. */
import { RefusedError } from "@corridor/protocol";
import type { BridgedRobot } from "../bridged-robot.ts";
import { clock } from "../clock.ts";
import { log } from "../run-bridge.ts";
import type { SensorSettings } from "./sensor-settings.ts";
import { VipleSession } from "./viple-session.ts";

/** Unsent bytes above which a connection is closed, because VIPLE does not read. */
const MAX_UNSENT = 64 * 1024;
/** Interval of sentences about ignored messages. */
const PROBLEM_MS = 1_000;

/** A connection to VIPLE. */
export interface Connection {
  /** number of bytes that VIPLE has not read */
  unsent(): number;
  send(text: string): void;
  drop(): void;
}

export interface OpenSession {
  receive(text: string): void;
  /** Prints why a message is ignored, at most once a second. */
  report(sentence: string): void;
  close(): void;
}

/** @returns null if the robot has ended, and the connection is dropped */
export function openSession(
  robot: BridgedRobot,
  settings: SensorSettings,
  connection: Connection,
): OpenSession | null {
  let loggedAt = Number.NEGATIVE_INFINITY;
  const report = (sentence: string): void => {
    if (clock.now() - loggedAt < PROBLEM_MS) return;
    loggedAt = clock.now();
    log(sentence);
  };
  try {
    const session = new VipleSession({
      port: robot.openPort(),
      timers: clock,
      settings,
      send: (text) => {
        if (connection.unsent() <= MAX_UNSENT) return connection.send(text);
        log("VIPLE does not read fast enough. It was disconnected.");
        return connection.drop();
      },
      onProblem: report,
    });
    return {
      receive: (text) => session.receive(text),
      report,
      close: () => session.close(),
    };
  } catch (error) {
    if (!(error instanceof RefusedError)) throw error;
    connection.drop();
    return null;
  }
}
