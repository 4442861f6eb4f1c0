/**
 * Answers to what is no request that an application could get: broken bytes, headers without end, a request
 * that never comes to its end, a tunnel. Node would answer without a word, or hang up.
 */
import type { RequestListener, Server, ServerResponse } from "node:http";
import type { Duplex } from "node:stream";
import type { ProblemKind } from "../problem-kinds.ts";
import { Refusal } from "../problems.ts";
import { refuseUpgrade } from "./refuse-upgrade.ts";

/**
 * @param application answers every whole request
 * @param refused is told of each refusal
 */
export function answerBrokenRequests(
  server: Server,
  application: RequestListener,
  refused: (kind: ProblemKind) => void,
): void {
  const answers = new WeakMap<Duplex, ServerResponse>();
  server.on("request", ({ socket }, response) => {
    answers.set(socket, response);
    response.once("close", () => answers.delete(socket));
  });
  server.on("clientError", (error: NodeJS.ErrnoException, socket) => {
    // Words of ours would land in the midst of an answer that has begun.
    const isTooLate = answers.get(socket)?.headersSent === true;
    if (!socket.writable || isTooLate) return void socket.destroy();
    const refusal = refusalOf(error);
    refused(refusal.kind);
    refuseUpgrade(socket, refusal);
  });
  // No expectation but 100-continue has a meaning: the request counts all the same.
  server.on("checkExpectation", application);
  server.on("connect", (_request, socket) => {
    refused("method-not-allowed");
    refuseUpgrade(
      socket,
      new Refusal("method-not-allowed", "This is no proxy. Use GET, POST, PUT and DELETE here."),
    );
  });
}

function refusalOf({ code }: NodeJS.ErrnoException): Refusal {
  if (code === "HPE_HEADER_OVERFLOW") {
    return new Refusal(
      "headers-too-large",
      "Address and headers may have 8 KiB together. Put what is longer into the body.",
    );
  }
  if (code === "ERR_HTTP_REQUEST_TIMEOUT") {
    return new Refusal(
      "too-slow",
      "Headers may take 10 s and a whole request 15 s. Send it again, in one go.",
    );
  }
  return new Refusal("bad-request", "This is no HTTP request, or it was cut off. Send it again.");
}
