/**
 * Clients that offer an upgrade to HTTP/2 get ordinary responses, although the port also serves
 * WebSockets.
 */
import { execFile, execFileSync } from "node:child_process";
import { join } from "node:path";
import { promisify } from "node:util";
import { describe, expect, it } from "vitest";
import { startTestRelay } from "../../../apps/relay/src/testing/test-relay.ts";
import { shortRunOptions } from "../../support/java.ts";

const run = promisify(execFile);

/** Whether the program is installed. Logs that the test is skipped if it is not. */
function has(program: string, versionOption: string): boolean {
  try {
    execFileSync(program, [versionOption], { stdio: "ignore" });
    return true;
  } catch {
    process.stderr.write(`old-clients.test.ts: skipped a test, there is no ${program} here\n`);
    return false;
  }
}

describe("clients that offer Upgrade: h2c", () => {
  it.skipIf(!has("java", "-version"))("Java's HttpClient by HTTP and WebSocket", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const program = join(import.meta.dirname, "OldClient.java");
    const api = `${relay.origin}/api/v1/robots/${robot.id}`;
    const { stdout } = await run("java", [...shortRunOptions, program, api, robot.driverKey]);
    const [status, welcome] = stdout.trim().split("\n");
    expect(status).toBe("202");
    expect(JSON.parse(welcome ?? "")).toMatchObject({
      type: "welcome",
      version: 1,
      snapshot: null,
    });
  });

  it.skipIf(!has("curl", "--version"))("curl --http2", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const { stdout } = await run("curl", [
      "--silent",
      "--http2",
      "--header",
      `Authorization: Bearer ${robot.driverKey}`,
      "--json",
      '{"action":"stop"}',
      "--write-out",
      "\n%{http_code}",
      `${relay.origin}/api/v1/robots/${robot.id}/commands`,
    ]);
    const [body, status] = stdout.split("\n");
    expect(status).toBe("202");
    expect(JSON.parse(body ?? "")).toMatchObject({ action: "stop", state: "accepted" });
  });
});
