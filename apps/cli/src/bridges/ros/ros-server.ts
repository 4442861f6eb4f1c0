/**
 * A WebSocket server for ROS clients. It needs no key, so it refuses pages of other sites: each page
 * that a user visits could connect to a server on the user's computer.
 */
import { createServer } from "node:http";
import { closeReasons, MAX_FRAME_BYTES, RefusedError, type CloseReason } from "@corridor/protocol";
import { closeReasonFor, RosSession } from "@corridor/ros";
import { WebSocketServer, type WebSocket } from "ws";
import type { ListenAddress } from "../bridge-arguments.ts";
import type { BridgedRobot } from "../bridged-robot.ts";
import { clock } from "../clock.ts";
import { isLoopback, listen, shownHost } from "../listen.ts";
import { log, type RunningBridge } from "../run-bridge.ts";

const MAX_CLIENTS = 32;
/** Unsent bytes above which a client is disconnected, because it does not read. */
const MAX_UNSENT = 1024 * 1024;
/** A client that does not answer a ping within this time is disconnected. */
const PING_MS = 20_000;
/** Interval of sentences about refused messages. */
const PROBLEM_MS = 1_000;
/** RFC 6455: an endpoint that goes away */
const GOING_AWAY = 1001;
/** RFC 6455, section 5.5 */
const MAX_REASON = 123;

/** @throws BridgeError if it cannot listen */
export async function serveRos(robot: BridgedRobot, at: ListenAddress): Promise<RunningBridge> {
  const http = createServer((_request, response) => {
    response.writeHead(426, { "Content-Type": "text/plain" });
    response.end("This is a WebSocket for ROS clients. Connect to it with ws://.\n");
  });
  const port = await listen(http, at);
  const sockets = new WebSocketServer({
    server: http,
    maxPayload: MAX_FRAME_BYTES,
    perMessageDeflate: false,
    verifyClient: ({ origin }: { origin: string | undefined }, answer) => {
      if (!isOwnPage(origin)) return answer(false, 403, "Pages of other sites cannot connect");
      if (sockets.clients.size >= MAX_CLIENTS) return answer(false, 503, "Too many clients");
      return answer(true);
    },
  });
  sockets.on("connection", (socket) => serveClient(robot, socket));
  const pings = setInterval(() => pingAll(sockets.clients), PING_MS);
  log(`ROS clients connect to ws://${shownHost(at.host)}:${port}. Press Ctrl+C to stop.`);
  if (!isLoopback(at.host)) log("Everyone in this network can drive the robot.");
  return {
    ended: new Promise(() => undefined),
    close: () => {
      clearInterval(pings);
      for (const socket of sockets.clients) socket.close(GOING_AWAY, "The bridge has stopped.");
      sockets.close();
      http.close();
    },
  };
}

/** Whether a program or a page of this computer connects. */
function isOwnPage(origin: string | undefined): boolean {
  if (origin === undefined) return true;
  return URL.canParse(origin) && isLoopback(new URL(origin).hostname.replaceAll(/[[\]]/g, ""));
}

function serveClient(robot: BridgedRobot, socket: WebSocket): void {
  const close = (reason: CloseReason, detail: string): void => {
    // Sentences of problems are ASCII.
    socket.close(reason.code, detail.replaceAll(/[^ -~]/g, "?").slice(0, MAX_REASON));
  };
  let loggedAt = Number.NEGATIVE_INFINITY;
  // On oversized messages or broken framing, `ws` closes the socket with 1009 or 1002.
  socket.on("error", () => undefined);
  try {
    const session = new RosSession({
      port: robot.openPort({ keepsVelocities: true }),
      timers: clock,
      send: (text) => {
        if (socket.bufferedAmount <= MAX_UNSENT) return socket.send(text);
        log("A ROS client does not read fast enough. It was disconnected.");
        return socket.terminate();
      },
      close,
      onProblem: ({ message }) => {
        if (clock.now() - loggedAt < PROBLEM_MS) return;
        loggedAt = clock.now();
        log(message);
      },
      onFailure: (error) => {
        log(`A ROS client was disconnected: ${String(error)}`);
        close(closeReasons.busy, closeReasons.busy.remedy);
      },
      onEnd: ({ problem }) => close(closeReasonFor(problem), problem.detail),
    });
    // ROS# sends its JSON as binary messages.
    socket.on("message", (data: Buffer) => void session.receive(data.toString()));
    socket.on("close", (code: number) => session.disconnected(code));
  } catch (error) {
    if (!(error instanceof RefusedError)) throw error;
    close(closeReasonFor(error.problem), error.message);
  }
}

const silent = new WeakSet<WebSocket>();

function pingAll(sockets: Iterable<WebSocket>): void {
  for (const socket of sockets) {
    if (silent.has(socket)) {
      socket.terminate();
      continue;
    }
    silent.add(socket);
    socket.once("pong", () => silent.delete(socket));
    socket.ping();
  }
}
