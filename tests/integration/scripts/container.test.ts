/** The health check of the Dockerfile. */
import { spawn } from "node:child_process";
import { once } from "node:events";
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { join } from "node:path";
import { describe, expect, it, onTestFinished } from "vitest";

const dockerfile = readFileSync(join(import.meta.dirname, "../../../Dockerfile"), "utf8");

/** @returns the exit code of the health check if `/readyz` has this status */
async function healthCheck(status: number): Promise<unknown> {
  const relay = createServer((request, response) => {
    response.writeHead(request.url === "/readyz" ? status : 404).end();
  });
  onTestFinished(() => {
    relay.close();
  });
  await once(relay.listen(0, "127.0.0.1"), "listening");
  const { port } = relay.address() as AddressInfo;
  const words = /^HEALTHCHECK [^\n]*\\\n +CMD (\[.*\])$/m.exec(dockerfile)?.[1] ?? "";
  const [, ...args] = JSON.parse(words) as string[];
  const env = { ...process.env, PORT: String(port) };
  const [code] = await once(spawn(process.execPath, args, { env }), "exit");
  return code;
}

describe("the recipe for a container", () => {
  it.each([
    { status: 200, code: 0 },
    { status: 503, code: 1 },
  ])("has a health check that ends with $code if /readyz is $status", async ({ status, code }) => {
    expect(await healthCheck(status)).toBe(code);
  });
});
