/** The kit on the real relay with a robot behind it, and on hosts that each do one thing wrong. */
import { describe, expect, it, onTestFinished } from "vitest";
import { registerRobot } from "../../../packages/client/src/register-robot.ts";
import { GridRobot } from "../../../packages/client/src/testing/grid-robot.ts";
import { startRelayProcess } from "../../../packages/client/src/testing/relay-process.ts";
import { runChecks, type Result } from "./run-checks.ts";
import { wrongHost, type Fault } from "./testing/wrong-host.ts";

const ROOM = ["#####", "#...#", "#...#", "#...#", "#####"];

async function rightAddress(): Promise<string> {
  const relay = await startRelayProcess();
  const registration = await registerRobot(relay.origin, fetch);
  const robot = new GridRobot(relay.origin, registration, ROOM);
  // A page reports at least once a second.
  const timer = setInterval(() => robot.link.sendSnapshot(robot.snapshot()), 500);
  onTestFinished(() => {
    clearInterval(timer);
    robot.link.close();
  });
  await expect.poll(() => robot.link.isConnected).toBe(true);
  return registration.address;
}

function failedIn(results: readonly Result[]): string[] {
  return results.flatMap(({ check, outcome }) => (outcome.kind === "failed" ? [check] : []));
}

describe("the conformance kit", () => {
  it("finds nothing wrong with the relay", async () => {
    const results = await runChecks(await rightAddress());
    const failed = results.filter(({ outcome }) => outcome.kind === "failed");
    expect(failed).toEqual([]);
    const unseen = results.filter(({ outcome }) => outcome.kind === "not seen");
    // The robot of this test does everything at once.
    expect(unseen.map(({ check }) => check)).toEqual([
      "what could not begin within its time to live ends as expired, and is not done",
    ]);
  });

  const withoutField = (name: string) => (text: string) => {
    const value: unknown = JSON.parse(text);
    if (typeof value === "object" && value !== null) Reflect.deleteProperty(value, name);
    return JSON.stringify(value);
  };

  it.each<{ name: string; fault: Fault; fails: string[] }>([
    {
      name: "forgets the keys of commands",
      fault: {
        there: ({ headers: { "idempotency-key": _key, ...headers }, ...rest }) => ({
          ...rest,
          headers,
        }),
      },
      fails: [
        "a retry with the same key is the same command",
        "ten tries at the same moment are one command",
        "the same key for another command is refused with 409",
        "a key that is too short, too long or has other signs is refused with 400",
      ],
    },
    {
      name: "takes old wishes for new ones",
      fault: {
        there: (passing) =>
          passing.body.startsWith('{"action":"left 90","ttl":1000')
            ? { ...passing, body: withoutField("age")(passing.body) }
            : passing,
      },
      fails: ["a command that is too old on arrival is refused with 422, and its key stays free"],
    },
    {
      name: "says what is wrong in HTML",
      fault: {
        back: (answered) =>
          answered.status < 400
            ? answered
            : { ...answered, headers: { "content-type": "text/html" }, text: "<h1>Error</h1>" },
      },
      fails: [
        "without a key there is no answer but 401, which asks for a bearer key",
        "a command that is too old on arrival is refused with 422, and its key stays free",
        "a host that knows its maze tells it by a version, and one that does not says so",
        "a wrong command is refused with 400, and the field is named",
        "a body above 16 KiB is refused with 413",
        "a body that is not said to be JSON is refused with 415",
        "waits and numbers that cannot be are refused with 400",
        "a command that there is not is 404",
        "an address that there is not is 404, a method that it does not know 405",
      ],
    },
    {
      name: "gives the first reading for ever",
      fault: (() => {
        let first: string | null = null;
        return {
          back: (answered, { path }) => {
            if (!path.includes("/sensors") || answered.status !== 200) return answered;
            first ??= answered.text;
            return { ...answered, text: first };
          },
        } satisfies Fault;
      })(),
      fails: [
        "a reading after a command is never from before its end",
        "a reading with after waits for a newer one",
      ],
    },
  ])("finds a host that $name", async ({ fault, fails }) => {
    const results = await runChecks(await wrongHost(await rightAddress(), fault));
    const failed = new Set(failedIn(results));
    // The wrong hosts of this test carry no streams.
    failed.delete("server-sent events tell snapshots and what becomes of commands");
    expect([...failed]).toEqual(fails);
  });

  it("refuses what is no address", async () => {
    await expect(runChecks("http://localhost/r/abc")).rejects.toThrow("not a robot's address");
  });
});
