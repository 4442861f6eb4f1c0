import { describe, expect, it, onTestFinished } from "vitest";
import { RobotClient } from "../../../packages/client/src/robot-client.ts";
import { robotWithCode } from "../../support/client/robot-with-code.ts";
import { sharedRelayProcess } from "../../support/test-relay-process.ts";

const sharedRelay = sharedRelayProcess();

describe("pairing with a real relay", () => {
  it("drives with its own key once the owner accepts", async () => {
    const {
      origin,
      code,
      answer: reply,
      registration,
    } = await robotWithCode((await sharedRelay()).url, ["####", "#..#", "####"]);
    const pairing = RobotClient.pair(origin, code, { name: "Paired" });
    await reply(true);
    const robot = await pairing;
    onTestFinished(() => robot.close());
    expect(await robot.right90()).toMatchObject({ state: "completed" });
    expect(robot.address).toContain(`${origin}/r/${registration.id}#drv_`);
    expect(robot.address).not.toBe(registration.address);
  });

  it("fails if the owner refuses", async () => {
    const testBed = await robotWithCode((await sharedRelay()).url, ["####", "#..#", "####"]);
    const { origin, code, answer: reply } = testBed;
    const pairing = RobotClient.pair(origin, code);
    await Promise.all([
      expect(pairing).rejects.toMatchObject({ code: "pairing-refused" }),
      reply(false),
    ]);
  });
});
