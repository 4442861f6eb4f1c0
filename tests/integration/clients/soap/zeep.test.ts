/** The SOAP library of Python drives robots through a real relay. */
import { execFile } from "node:child_process";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";
import { describe, expect, it } from "vitest";
import { NotInstallableError, requireEnvironment } from "../../../../scripts/python.ts";
import { corridorHost } from "../../../support/mcp/corridor-host.ts";
import { room } from "../../../support/soap/room.ts";
import { sharedRelayProcess } from "../../../support/test-relay-process.ts";

const run = promisify(execFile);
const support = (name: string): string =>
  fileURLToPath(new URL(`../../../support/soap/${name}`, import.meta.url));

/** Python with the library, or why it cannot be installed here. */
function library(): { python: string } | { missing: string } {
  try {
    return { python: requireEnvironment("soap", support("requirements.txt")) };
  } catch (error) {
    if (error instanceof NotInstallableError) return { missing: error.message };
    throw error;
  }
}

const SIDES = ["move", "right 90", "move", "right 90", "move", "right 90", "move", "right 90"];

interface Record {
  action: string;
  state: string;
}

const sharedRelay = sharedRelayProcess();

describe("zeep", () => {
  it.for([
    { wsdl: "?wsdl", sender: "soap:Client" },
    { wsdl: "?wsdl=1.2", sender: "soap:Sender" },
  ])(
    "drives squares with a client generated from $wsdl, and reads typed faults",
    { timeout: 300_000 },
    async ({ wsdl, sender }, { skip }) => {
      const { relay, page, registration } = await corridorHost(await sharedRelay(), room);
      const other = await corridorHost(relay, room);
      const found = library();
      if ("missing" in found) return skip(found.missing);
      const { stdout } = await run(found.python, [
        support("zeep_client.py"),
        `${relay.url}/soap${wsdl}`,
        registration.address,
        other.registration.address,
      ]).catch((error: unknown) => {
        throw new Error(`${String(error)}\n${relay.log}`);
      });
      const received = JSON.parse(stdout) as { [name: string]: unknown };
      expect(received).toMatchObject({
        sense: { driver: "remote", sensors: { front: 150, left: 50 }, pose: { x: 150, y: 150 } },
        until: { state: "completed", pose: { y: 150 } },
        one: { seq: 1, action: "move", state: "completed", command: { distance: 100 } },
        stop: { action: "stop", state: "completed" },
        wrong: {
          code: sender,
          message: expect.stringContaining("distance: found 90000"),
          detail: { code: "bad-request", errors: [{ path: "distance", found: "90000" }] },
        },
        gone: { detail: { code: "no-command", retryAfter: null, errors: [] } },
        sensed: { pose: { x: 150, y: 150, heading: 90 }, bumps: 0 },
      });
      const actions = (records: unknown): string[] =>
        (records as Record[]).map(({ action }) => action);
      expect(actions(received["square"])).toEqual(SIDES);
      expect(actions(received["log"])).toEqual([...SIDES, "forward"]);
      expect(page.robot.done.map(({ action }) => action)).toEqual([...SIDES, "forward"]);
      expect(other.page.robot.done.map(({ action }) => action)).toEqual(SIDES);
    },
  );
});
