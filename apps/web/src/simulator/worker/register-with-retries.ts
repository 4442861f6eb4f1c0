/**
 * Registers a robot at the relay. Without an answer it retries by itself, as the link does: devices
 * report a network before requests get through.
 */
import type * as ClientLibrary from "@corridor/client/host";
import type { HostConnectionOptions } from "@corridor/client/host";
import type { RemoteSession, RemoteStatus } from "../protocol/worker-messages.ts";

export interface RegistrationPorts {
  client: typeof ClientLibrary;
  /** origin of the relay */
  origin: string;
  fetch: Parameters<typeof ClientLibrary.registerRobot>[1];
  platform: HostConnectionOptions["platform"];
  /** false once another attempt to connect has started */
  isCurrent: () => boolean;
  onStatus: (status: RemoteStatus) => void;
}

/** @returns null if the service has no robot for this page, or another attempt has started */
export async function registerWithRetries(ports: RegistrationPorts): Promise<RemoteSession | null> {
  const { client, origin, fetch, platform, isCurrent, onStatus } = ports;
  const { clock, random } = platform ?? client.globalPlatform();
  const backoff = new client.Backoff();
  while (isCurrent()) {
    try {
      return { ...(await client.registerRobot(origin, fetch)), lastApplied: 0 };
    } catch (error) {
      if (!isCurrent()) break;
      const reason = error instanceof client.RegistrationError ? error.code : "noService";
      if (reason !== "noAnswer") {
        onStatus({ kind: "lost", reason });
        break;
      }
    }
    onStatus({ kind: "lost", reason: "connectionLost" });
    const pause = Promise.withResolvers<void>();
    clock.after(backoff.next(clock.now(), random()), pause.resolve);
    await pause.promise;
    if (isCurrent()) onStatus({ kind: "connecting" });
  }
  return null;
}
