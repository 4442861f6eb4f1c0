/** Relay processes that end with the test. */
import { onTestFinished } from "vitest";
import { RelayProcess, type RelayOptions } from "./relay-process.ts";

/** Starts a relay, with an empty store by default, and waits until it is ready. */
export async function startRelayProcess(options: RelayOptions = {}): Promise<RelayProcess> {
  const relay = launchRelayProcess(options);
  await relay.ready();
  return relay;
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
