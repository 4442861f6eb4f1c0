/** A WebSocket client of VIPLE's own server, as robots in a page are. It connects again and again. */
import { MAX_FRAME_BYTES } from "@corridor/protocol";
import { WebSocket } from "ws";
import type { BridgedRobot } from "../bridged-robot.ts";
import { clock } from "../clock.ts";
import { log, type RunningBridge } from "../run-bridge.ts";
import { openSession, type OpenSession } from "./open-session.ts";
import type { SensorSettings } from "./sensor-settings.ts";

/** VIPLE starts its server with each run of a diagram. */
const RETRY_MS = 1_000;
const TIMEOUT_MS = 10_000;

export function connectToViple(
  robot: BridgedRobot,
  settings: SensorSettings,
  url: string,
): RunningBridge {
  const { host } = new URL(url);
  let socket: WebSocket;
  let isClosed = false;
  let hasReported = false;
  let cancelRetry = (): void => undefined;
  const connect = (): void => {
    let session: OpenSession | null = null;
    let reason = "it closed the connection";
    const opened = new WebSocket(url, {
      maxPayload: MAX_FRAME_BYTES,
      perMessageDeflate: false,
      handshakeTimeout: TIMEOUT_MS,
    });
    socket = opened;
    opened.on("open", () => {
      hasReported = false;
      log(`Connected to VIPLE at ${host}. Press Ctrl+C to stop.`);
      session = openSession(robot, settings, {
        unsent: () => opened.bufferedAmount,
        send: (text) => opened.send(text),
        drop: () => opened.terminate(),
      });
    });
    opened.on("message", (data: Buffer) => session?.receive(data.toString()));
    // Also a message of more than 16 KiB.
    opened.on("error", (error) => (reason = error.message || error.name));
    opened.on("close", () => {
      session?.close();
      if (isClosed) return;
      if (!hasReported) log(`VIPLE at ${host} is not connected: ${reason}. Retrying.`);
      hasReported = true;
      cancelRetry = clock.after(RETRY_MS, connect);
    });
  };
  connect();
  return {
    ended: new Promise(() => undefined),
    close: () => {
      isClosed = true;
      cancelRetry();
      socket.close();
    },
  };
}
