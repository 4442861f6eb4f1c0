/** The kit ends at once where no check can be tested. */
import { describe, expect, it, onTestFinished } from "vitest";
import { linesOf, passes, runChecks } from "../../../packages/conformance/src/index.ts";
import { PEN, startPhysicalRobot } from "../../support/conformance/physical-robot.ts";

async function reportOf(address: string): Promise<string[]> {
  const results = await runChecks(address);
  expect(passes(results)).toBe(false);
  return results.flatMap(linesOf);
}

const end = "                     The other checks need this one, so the run ends here.";

describe("the conformance kit", () => {
  it("ends with the reason if the key or the robot is unknown, or no host answers", async () => {
    const robot = await startPhysicalRobot({ room: PEN });
    onTestFinished(robot.stop);
    expect(await reportOf(`${robot.address}x`)).toEqual([
      expect.stringContaining("FAILED             key-address: "),
      expect.stringContaining("expected: 200 for GET /commands with the key"),
      expect.stringMatching(/found: {4}401: .*key/),
      end,
    ]);
    expect(await reportOf(robot.address.replace("/r/", "/r/x"))).toEqual([
      expect.stringContaining("FAILED             key-address: "),
      expect.stringContaining("expected: 200 for GET /commands with the key"),
      expect.stringMatching(/found: {4}404: .+/),
      end,
    ]);
    robot.stop();
    await expect
      .poll(() => reportOf(robot.address))
      .toEqual([
        expect.stringContaining("FAILED             key-address: "),
        expect.stringContaining("expected: 200 for GET /commands with the key"),
        expect.stringMatching(/found: {4}fetch failed \(connect ECONNREFUSED .*\)/),
        end,
      ]);
  });
});
