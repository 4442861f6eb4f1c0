/**
 * TCP servers for VIPLE: a diagram connects to a robot by host and port. They need no key, and each page
 * that a user visits could send a request to them, so they disconnect clients that speak HTTP.
 */
import { createServer, type Server, type Socket } from "node:net";
import { MAX_FRAME_BYTES } from "@corridor/protocol";
import type { ListenAddress } from "../bridge-arguments.ts";
import type { BridgedRobot } from "../bridged-robot.ts";
import { isLoopback, listen, shownHost } from "../listen.ts";
import { log, type RunningBridge } from "../run-bridge.ts";
import { LineReader } from "./line-reader.ts";
import { openSession } from "./open-session.ts";
import type { SensorSettings } from "./sensor-settings.ts";

const MAX_CLIENTS = 32;
/** How a request of a page begins. */
const HTTP = /^(?:GET|HEAD|POST|OPTIONS) /;
const TOO_LONG = `A line of VIPLE has more than ${MAX_FRAME_BYTES / 1024} KiB.`;

/** A port, and how its lines end. Lines that arrive may end either way. */
export interface VipleListener {
  at: ListenAddress;
  /** option that chooses another port */
  option: string;
  lineEnd: "\n" | "\r\n";
}

/** @throws BridgeError if it cannot listen */
export async function serveViple(
  robot: BridgedRobot,
  settings: SensorSettings,
  listeners: readonly VipleListener[],
): Promise<RunningBridge> {
  const sockets = new Set<Socket>();
  const servers: Server[] = [];
  const close = (): void => {
    for (const server of servers) server.close();
    for (const socket of sockets) socket.destroy();
  };
  const places: string[] = [];
  for (const { at, option, lineEnd } of listeners) {
    const server = createServer({ noDelay: true }, (socket) => {
      if (sockets.size >= MAX_CLIENTS) return socket.destroy();
      sockets.add(socket);
      socket.on("close", () => sockets.delete(socket));
      return serveClient(robot, settings, { socket, lineEnd });
    });
    servers.push(server);
    try {
      const port = await listen(server, at, option);
      places.push(`port ${port} (lines end with ${JSON.stringify(lineEnd).slice(1, -1)})`);
    } catch (error) {
      close();
      throw error;
    }
  }
  const [{ at } = { at: { host: "" } }] = listeners;
  log(`VIPLE connects to ${shownHost(at.host)}, ${places.join(" or ")}. Press Ctrl+C to stop.`);
  if (!isLoopback(at.host)) log("Everyone in this network can drive the robot.");
  return { ended: new Promise(() => undefined), close };
}

function serveClient(
  robot: BridgedRobot,
  settings: SensorSettings,
  { socket, lineEnd }: { socket: Socket; lineEnd: string },
): void {
  socket.on("error", () => undefined);
  const session = openSession(robot, settings, {
    unsent: () => socket.writableLength,
    send: (text) => void socket.write(text + lineEnd),
    drop: () => void socket.destroy(),
  });
  if (session === null) return;
  socket.on("close", () => session.close());
  const lines = new LineReader();
  let isFirst = true;
  socket.on("data", (bytes: Buffer) => {
    if (isFirst && HTTP.test(bytes.toString("latin1", 0, 8))) {
      session.report("A page or another HTTP client connected. It was disconnected.");
      socket.destroy();
      return;
    }
    isFirst = false;
    for (const line of lines.add(bytes)) {
      if (line === null) session.report(TOO_LONG);
      else if (line !== "") session.receive(line);
    }
  });
}
