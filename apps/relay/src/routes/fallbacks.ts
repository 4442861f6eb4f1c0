/** Answers where no route has one: unknown address, unknown method, and whatever went wrong. */
import type { ErrorRequestHandler, RequestHandler, Response } from "express";
import type { Logger } from "pino";
import type { ProblemKind } from "../problem-kinds.ts";
import { asRefusal, Refusal } from "../problems.ts";

/** @param allowed the methods that the address knows, such as "GET, DELETE" */
export function methodNotAllowed(allowed: string): RequestHandler {
  return (request) => {
    throw new Refusal(
      "method-not-allowed",
      `${request.method} is not known here. This address knows: ${allowed}.`,
      { headers: { Allow: allowed } },
    );
  };
}

export const notFound: RequestHandler = () => {
  throw new Refusal("not-found", "Check the address. The API begins with /api/v1/robots.");
};

/** Answers everything that was thrown with a problem document; only our own mistakes are logged. */
export function problemAnswers(
  log: Logger,
  refused: (kind: ProblemKind) => void,
): ErrorRequestHandler {
  return (error: unknown, request, response, next) => {
    const refusal = refusalOf(error);
    refused(refusal.kind);
    if (refusal.kind === "internal") {
      log.error({ err: error, method: request.method }, "a request failed");
    }
    // The answer has begun: all that is left is to cut it off.
    if (response.headersSent) return next(error);
    sendProblem(response, refusal);
  };
}

function sendProblem(response: Response, { problem, headers }: Refusal): void {
  response.status(problem.status).set(headers).type("application/problem+json");
  response.send(JSON.stringify(problem));
}

/** Express and its body reader throw errors with a status; their texts are not for the client. */
function refusalOf(error: unknown): Refusal {
  const status = error instanceof Error && "status" in error ? error.status : undefined;
  if (status === 413) {
    const limit = error instanceof Error && "limit" in error ? Number(error.limit) : 0;
    return new Refusal("too-large", `A body may have ${limit / 1024} KiB at most here.`);
  }
  if (status === 415) {
    return new Refusal("not-json", "Send the body as plain JSON in UTF-8, not compressed.");
  }
  if (typeof status === "number" && status >= 400 && status < 500) {
    return new Refusal("bad-request", "The request is damaged or was cut off. Send it again.");
  }
  return asRefusal(error);
}
