/** The Python library of the Model Context Protocol drives a robot through a real relay. */
import { execFile } from "node:child_process";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";
import { describe, expect, it } from "vitest";
import { corridorHost } from "../../../support/mcp/corridor-host.ts";
import { mcpEnvironment } from "../../../support/mcp/python-mcp.ts";
import { sharedRelayProcess } from "../../../support/test-relay-process.ts";

const run = promisify(execFile);
const support = (name: string): string =>
  fileURLToPath(new URL(`../../../support/mcp/${name}`, import.meta.url));

const sharedRelay = sharedRelayProcess();

describe("an agent in Python", () => {
  it.for(["auto", "legacy"])(
    "solves a corridor, reads why a command is refused, and repeats one whose answer was lost (%s)",
    { timeout: 300_000 },
    async (mode, { skip }) => {
      const { relay, page, registration, url } = await corridorHost(await sharedRelay());
      const found = mcpEnvironment();
      if ("missing" in found) return skip(found.missing);
      const args = [support("agent.py"), mode, url, registration.driverKey];
      const { stdout } = await run(found.python, args).catch((error: unknown) => {
        throw new Error(`${String(error)}\n${relay.log}`);
      });
      const received = JSON.parse(stdout) as Record<string, unknown>;
      const { tools, snapshot, refused, sentence, repeated } = received;
      expect(tools).toEqual(["sense", "look", "wait", "act", "stop", "reset"]);
      expect(snapshot).toMatchObject({ goalReached: true, bumps: 0 });
      expect(refused).toBe(true);
      expect(sentence).toContain("distance: found 90000");
      expect(repeated).toContain("the robot did not move again");
      expect(page.robot.done.filter(({ action }) => action === "turn")).toHaveLength(1);
      expect(page.robot.snapshot().bumps).toBe(0);
    },
  );
});
