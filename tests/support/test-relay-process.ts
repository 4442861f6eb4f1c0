/** Relay processes that end with the test or with the file. */
import { setImmediate } from "node:timers/promises";
import { afterAll, beforeAll, onTestFinished } from "vitest";
import { RelayProcess, type RelayOptions } from "./relay-process.ts";

/** Starts a relay, with an empty store by default, and waits until it is ready. */
export async function startRelayProcess(options: RelayOptions = {}): Promise<RelayProcess> {
  const relay = launchRelayProcess(options);
  await relay.ready();
  return relay;
}

/**
 * One relay for all tests of a file, as a start takes more than a second of processor time. For tests
 * that register a robot of their own, and neither configure nor restart the relay.
 * @returns the relay, in a test
 */
export function sharedRelayProcess(): () => Promise<RelayProcess> {
  let relay: RelayProcess | undefined;
  beforeAll(async () => {
    relay = await RelayProcess.start();
  });
  afterAll(async () => relay?.stop());
  return async () => {
    if (relay === undefined) throw new Error("The shared relay starts before the first test.");
    // A test may have blocked this process, for instance while it installed packages, and the relay
    // closed idle connections. After a turn of the event loop, `fetch` does not reuse them.
    for (let phase = 0; phase < 2; phase++) await setImmediate();
    return relay;
  };
}

/** Starts a relay that may exit before it is ready. */
export function launchRelayProcess(options: RelayOptions = {}): RelayProcess {
  const relay = RelayProcess.launch(options);
  onTestFinished(async () => {
    await relay.kill();
    await relay.stop();
  });
  return relay;
}
