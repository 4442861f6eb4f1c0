/**
 * Downloads built files. `e2e/installed-libraries.spec.ts` drives a robot with `corridor.js`, and
 * `e2e/installed-command.spec.ts` grades with `grade.mjs`.
 */
import { once } from "node:events";
import { writeFileSync } from "node:fs";
import { get } from "node:http";
import type { AddressInfo } from "node:net";
import { join } from "node:path";
import express from "express";
import { pino } from "pino";
import { describe, expect, it, onTestFinished } from "vitest";
import { testFolder } from "../../testing/test-relay.ts";
import { problemResponses } from "../../platform/http/fallbacks.ts";
import { builtFileRoute } from "./built-files.ts";

const SOURCE = "export class RobotClient {}\n";

async function serve(file: string): Promise<string> {
  const app = express();
  app.use(builtFileRoute(file));
  app.use(problemResponses(pino({ level: "silent" }), () => undefined));
  const server = app.listen(0, "127.0.0.1");
  onTestFinished(() => void server.close());
  await new Promise((resolve) => server.once("listening", resolve));
  return `http://127.0.0.1:${(server.address() as AddressInfo).port}/corridor.js`;
}

function builtFile(): string {
  const file = join(testFolder(), "corridor.js");
  writeFileSync(file, SOURCE);
  return file;
}

describe("/corridor.js", () => {
  it("is a module that scripts save and pages of other sites import", async () => {
    const answer = await fetch(await serve(builtFile()));
    expect(answer.status).toBe(200);
    expect(Object.fromEntries(answer.headers)).toMatchObject({
      "access-control-allow-origin": "*",
      "cache-control": "no-cache",
      "content-type": "text/javascript; charset=utf-8",
      "cross-origin-resource-policy": "cross-origin",
    });
    expect(await answer.text()).toBe(SOURCE);
  });

  it("is compressed for a browser, and not for curl", async () => {
    const url = await serve(builtFile());
    const answer = await fetch(url);
    expect(answer.headers.get("content-encoding")).toBe("gzip");
    expect(answer.headers.get("vary")).toContain("Accept-Encoding");
    const [plain] = await once(get(url), "response");
    plain.resume();
    expect(plain.headers["content-encoding"]).toBeUndefined();
  });

  it("is not sent again if it has not changed", async () => {
    const url = await serve(builtFile());
    const lastModified = (await fetch(url)).headers.get("last-modified") ?? "";
    // fetch would add "Cache-Control: no-cache" to a conditional request.
    const request = get(url, { headers: { "If-Modified-Since": lastModified } });
    const [answer] = await once(request, "response");
    answer.resume();
    expect(answer.statusCode).toBe(304);
  });

  it("without a build, reports how to build it", async () => {
    const answer = await fetch(await serve(join(testFolder(), "corridor.js")));
    expect(answer.status).toBe(404);
    expect(await answer.json()).toMatchObject({
      type: "/problems/not-found",
      detail: "corridor.js has not been built yet. Run: npm run build (npm start does both).",
    });
  });

  it("is read-only", async () => {
    const answer = await fetch(await serve(builtFile()), { method: "POST" });
    expect(answer.status).toBe(405);
  });
});
