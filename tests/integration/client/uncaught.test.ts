/** What a script without its own error handling prints. */
import { execFile } from "node:child_process";
import { join } from "node:path";
import { promisify } from "node:util";
import { describe, expect, it } from "vitest";
import type { ClientError } from "../../../packages/client/src/client-error.ts";
import { RobotClient } from "../../../packages/client/src/robot-client.ts";
import { robotIn } from "../../support/client/robot-in.ts";
import { sharedRelayProcess } from "../../support/test-relay-process.ts";

const sharedRelay = sharedRelayProcess();
const ROOT = join(import.meta.dirname, "../../..");

/** Runs lines of JavaScript after the import. @returns the standard error, in lines */
async function failureOf(...lines: string[]): Promise<string[]> {
  const code = ['import { RobotClient } from "@corridor/client";', ...lines].join("\n");
  const args = ["--input-type=module", "-e", code];
  const failed = promisify(execFile)(process.execPath, args, { cwd: ROOT });
  const { stderr } = await failed.then(
    () => ({ stderr: "" }),
    (error: { stderr: string }) => error,
  );
  return stderr.trimEnd().split("\n");
}

describe("an uncaught error of a JavaScript script", () => {
  it("is the line of the script and a sentence, without a line of the library", async () => {
    const { registration } = await robotIn(["###", "#.#", "###"], await sharedRelay());
    const wrong = registration.address.replace(/#.*/, "#drv_AAAAAAAAAAAAAAAAAAAAAA");
    const connect = await failureOf(`await RobotClient.connect("${wrong}");`);
    expect(connect[0]).toMatch(/\[eval1\]:2$/);
    expect(connect[1]).toContain("await RobotClient.connect(");
    expect(connect).toContainEqual(expect.stringMatching(/^ClientError: .*\(not-authorised\)/));
    expect(connect.join("\n")).not.toMatch(/robot-client|client-error|node:internal/);
    expect(connect.length).toBeLessThan(10);
    const forward = await failureOf(
      `const robot = await RobotClient.connect("${registration.address}");`,
      "await robot.forward(100);",
    );
    expect(forward.slice(0, 2)).toEqual([
      expect.stringMatching(/:3$/),
      "await robot.forward(100);",
    ]);
    expect(forward.join("\n")).toContain("Use move(100).");
  });
});

describe("an error of RobotClient", () => {
  it.each([
    { wrong: "key", change: /#.*/, to: "#drv_AAAAAAAAAAAAAAAAAAAAAA" },
    { wrong: "id", change: /r\/.*#/, to: "r/AAAAAAAAAAAAAAAAAAAAAA#" },
  ])("has the words of the relay's HTTP response for a wrong $wrong", async ({ change, to }) => {
    const { registration } = await robotIn(["###", "#.#", "###"], await sharedRelay());
    const address = registration.address.replace(change, to);
    const { href, hash } = new URL(address);
    const url = href.replace("/r/", "/api/v1/robots/").replace(hash, "/sensors");
    const headers = { Authorization: `Bearer ${hash.slice(1)}` };
    const { detail } = (await (await fetch(url, { headers })).json()) as { detail: string };
    const error = await RobotClient.connect(address).catch((reason: unknown) => reason);
    expect((error as ClientError).hint).toBe(detail);
  });
});
