/** Responses without a route: unknown paths, unsupported methods and errors. */
import type { ErrorRequestHandler, RequestHandler, Response } from "express";
import type { Logger } from "pino";
import type { ProblemDocument, RefusedError } from "@corridor/protocol";
import { problemKinds, type ProblemKind } from "../errors/problem-kinds.ts";
import { asRefusal, Refusal } from "../errors/problems.ts";

/** @param allowed supported methods, such as "GET, DELETE" */
export function methodNotAllowed(allowed: string): RequestHandler {
  return (request) => {
    throw new Refusal(
      "method-not-allowed",
      `${request.method} is not supported here. Supported methods: ${allowed}.`,
      { headers: { Allow: allowed } },
    );
  };
}

export const notFound: RequestHandler = () => {
  throw new Refusal(
    "not-found",
    "Check the path for typing errors. /openapi.json lists all API paths, such as /api/v1/robots/ID/commands.",
  );
};

/** Converts every error to a problem document. Only internal errors are logged. */
export function problemResponses(
  log: Logger,
  onRefusal: (kind: ProblemKind) => void,
): ErrorRequestHandler {
  return (error: unknown, request, response, next) => {
    const refusal = refusalOf(error);
    onRefusal(refusal.kind);
    if (refusal.kind === "internal") {
      log.error({ err: error, method: request.method }, "request failed");
    }
    // The response has started, so the connection can only be closed.
    if (response.headersSent) return next(error);
    sendProblem(response, refusal);
  };
}

/** Counts and logs refusals that a gateway answers in its own protocol. */
export function gatewayRefusals(
  log: Logger,
  onRefusal: (kind: ProblemKind) => void,
): (error: RefusedError) => void {
  return ({ cause, problem }) => {
    const kind = kindOf(problem);
    onRefusal(kind);
    if (kind === "internal") log.error({ err: cause }, "request of a gateway failed");
  };
}

function kindOf({ type }: ProblemDocument): ProblemKind {
  const name = type.replace("/problems/", "");
  return Object.hasOwn(problemKinds, name) ? (name as ProblemKind) : "bad-request";
}

function sendProblem(response: Response, { problem, headers }: Refusal): void {
  response.status(problem.status).set(headers).type("application/problem+json");
  response.send(JSON.stringify(problem));
}

/** Express and its body parser throw errors with a status. Their texts are not for the client. */
export function refusalOf(error: unknown): Refusal {
  const status = error instanceof Error && "status" in error ? error.status : undefined;
  if (status === 413) {
    const limit = error instanceof Error && "limit" in error ? Number(error.limit) : 0;
    return new Refusal(
      "too-large",
      `The body has more than ${limit / 1024} KiB, the maximum at this path. Send a smaller body.`,
    );
  }
  if (status === 415) {
    return new Refusal(
      "not-json",
      "The body is compressed or has an unsupported encoding. Send uncompressed JSON in UTF-8.",
    );
  }
  if (typeof status === "number" && status >= 400 && status < 500) {
    return new Refusal("bad-request", "The request is malformed or incomplete. Send it again.");
  }
  return asRefusal(error);
}
