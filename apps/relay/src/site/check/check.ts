/**
 * `/check`: a page that shows a school's administrator what their filter blocks, and the endpoints
 * that it tests. The page is small and self-contained, because a filter may block most requests.
 */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import express, { Router, type RequestHandler } from "express";
import { checkPage, checkWords } from "./check-words.ts";
import type { Clock } from "../../platform/time/clock.ts";
import type { RequestGuard } from "../../platform/http/request-guard.ts";
import { Refusal, retryAfter } from "../../platform/errors/problems.ts";
import { limits } from "../../platform/limits/limits.ts";
import { methodNotAllowed } from "../../platform/http/fallbacks.ts";
import { listedFiles } from "../../platform/http/listed-files.ts";
import { waitLimitOf, readWaitSeconds } from "../../platform/http/reading.ts";

const FOLDER = import.meta.dirname;
const FILES = {
  "/check/check.css": join(FOLDER, "check.css"),
  "/check/check.js": join(FOLDER, "check.js"),
  "/check/probes.js": join(FOLDER, "probes.js"),
  "/check/check.worker.js": join(FOLDER, "check.worker.js"),
};
const COMPRESSED = gzipSync("Corridor ".repeat(500));
const EVENTS = 5;
const EVENT_MS = 400;

export function checkRoutes(guard: RequestGuard, clock: Clock): Router {
  // Before the routes, because a nested router at the end delays every other request by a turn.
  const router = Router().use(listedFiles(FILES));
  const html = readFileSync(join(FOLDER, "check.html"), "utf8");
  router
    .route("/check")
    .get((request, response) => {
      const { lang } = request.query;
      const known = [...checkWords.keys()];
      const asked = known.find((language) => language === lang);
      // One Chinese translation serves all Chinese locales.
      const accepted = request.acceptsLanguages(["en", "zh", ...known]);
      const best = accepted === "zh" ? "zh-Hans" : accepted === false ? "en" : accepted;
      const { host } = new URL(guard.originOf(request));
      response.vary("Accept-Language").set("Cache-Control", "no-cache");
      response.type("html").send(checkPage(html, asked ?? best, host));
    })
    .all(methodNotAllowed("GET"));

  const echo: RequestHandler = (request, response) => {
    const { method } = request;
    const body: unknown = request.body;
    const authorization = request.get("authorization") ?? null;
    response.set("Cache-Control", "no-store");
    response.json({ method, authorization, body: typeof body === "string" ? body : null });
  };
  router
    .route("/check/echo")
    .get(echo)
    .post(express.text({ type: "application/json", limit: "8kb", inflate: false }), echo)
    .delete(echo)
    .all(methodNotAllowed("GET, POST, DELETE"));

  router
    .route("/check/compressed")
    .get((_request, response) => {
      response.set({ "Cache-Control": "no-store", "Content-Encoding": "gzip" });
      response.type("text").send(COMPRESSED);
    })
    .all(methodNotAllowed("GET"));

  const held = new SlowResponses();
  router
    .route("/check/wait")
    .get(async (request, response) => {
      const waited = readWaitSeconds(request);
      await held.hold(async () => {
        const { milliseconds, signal } = waitLimitOf(response, waited);
        await delay(clock, milliseconds, signal);
      });
      response.set("Cache-Control", "no-store").json({ waited });
    })
    .all(methodNotAllowed("GET"));

  router
    .route("/check/events")
    .get(async (_request, response) => {
      await held.hold(async () => {
        const { signal } = waitLimitOf(response, 0);
        response.on("error", () => response.destroy());
        response.writeHead(200, {
          "Content-Type": "text/event-stream",
          "Cache-Control": "no-store",
          "X-Accel-Buffering": "no",
        });
        for (let n = 1; n <= EVENTS && !signal.aborted; n++) {
          response.write(`data: ${n}\n\n`);
          if (n < EVENTS) await delay(clock, EVENT_MS, signal);
        }
        response.end();
      });
    })
    .all(methodNotAllowed("GET"));

  return router;
}

/** Limits concurrent slow responses, because they need no authentication. */
class SlowResponses {
  #count = 0;

  /** @throws Refusal if too many are pending */
  async hold(answer: () => Promise<void>): Promise<void> {
    if (this.#count >= limits.heldChecks) {
      throw new Refusal("too-fast", "Too many network checks are running. Try again in a minute.", {
        headers: retryAfter(30_000),
      });
    }
    this.#count += 1;
    try {
      await answer();
    } finally {
      this.#count -= 1;
    }
  }
}

function delay(clock: Clock, ms: number, signal: AbortSignal): Promise<void> {
  return new Promise((resolve) => {
    const cancel = clock.after(ms, resolve);
    signal.addEventListener("abort", () => {
      cancel();
      resolve();
    });
  });
}
