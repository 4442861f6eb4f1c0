/**
 * Responses to requests that Node's HTTP server cannot pass to the application: invalid bytes,
 * endless headers, incomplete requests and CONNECT. Node would respond without a body or close the
 * connection.
 */
import type { RequestListener, Server, ServerResponse } from "node:http";
import type { Duplex } from "node:stream";
import type { ProblemKind } from "../errors/problem-kinds.ts";
import { Refusal } from "../errors/problems.ts";
import { refuseUpgrade } from "./refuse-upgrade.ts";

/**
 * @param application handles complete requests
 * @param onRefusal called for each rejected request
 */
export function answerBrokenRequests(
  server: Server,
  application: RequestListener,
  onRefusal: (kind: ProblemKind) => void,
): void {
  const responses = new WeakMap<Duplex, ServerResponse>();
  server.on("request", ({ socket }, response) => {
    responses.set(socket, response);
    response.once("close", () => responses.delete(socket));
  });
  server.on("clientError", (error: NodeJS.ErrnoException, socket) => {
    // A second response would corrupt one that has already started.
    const hasStarted = responses.get(socket)?.headersSent === true;
    if (!socket.writable || hasStarted) return void socket.destroy();
    const refusal = refusalOf(error);
    onRefusal(refusal.kind);
    refuseUpgrade(socket, refusal);
  });
  // Only 100-continue has a meaning. Requests with other expectations are served normally.
  server.on("checkExpectation", application);
  server.on("connect", (_request, socket) => {
    onRefusal("method-not-allowed");
    refuseUpgrade(
      socket,
      new Refusal(
        "method-not-allowed",
        "This server is not a proxy. Use GET, POST, PUT or DELETE.",
      ),
    );
  });
}

function refusalOf({ code }: NodeJS.ErrnoException): Refusal {
  if (code === "HPE_HEADER_OVERFLOW") {
    return new Refusal(
      "headers-too-large",
      "Address and headers together are limited to 8 KiB. Put longer data into the body.",
    );
  }
  if (code === "ERR_HTTP_REQUEST_TIMEOUT") {
    return new Refusal(
      "too-slow",
      "Headers must arrive within 10 s and the whole request within 15 s. Send it again.",
    );
  }
  return new Refusal(
    "bad-request",
    "The request is not valid HTTP or is incomplete. Send it again.",
  );
}
