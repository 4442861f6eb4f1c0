/** Opens and closes the port of a server. */
import type { Server } from "node:http";
import type { AddressInfo } from "node:net";

const IDLE_CHECK_MS = 50;

/** @returns the port that the server listens on, or null if it does not listen */
export function portOf(server: Server): number | null {
  return (server.address() as AddressInfo | null)?.port ?? null;
}

/** @throws the error of `listen`, such as EADDRINUSE */
export function listen(server: Server, port: number, host: string | null): Promise<void> {
  return new Promise((resolve, reject) => {
    server.once("error", reject);
    server.listen({ port, ...(host !== null && { host }) }, () => {
      server.off("error", reject);
      resolve();
    });
  });
}

/**
 * Stops accepting connections and waits until pending requests have ended.
 * @param timeoutMs time after which open connections are destroyed
 * @param destroyUpgraded destroys upgraded connections, such as WebSockets
 */
export function closeServer(
  server: Server,
  timeoutMs: number,
  destroyUpgraded: () => void,
): Promise<void> {
  if (!server.listening) return Promise.resolve();
  return new Promise((resolve) => {
    const timer = setTimeout(() => {
      destroyUpgraded();
      server.closeAllConnections();
    }, timeoutMs);
    // Keep-alive connections stay open after their last response.
    const idleCheck = setInterval(() => server.closeIdleConnections(), IDLE_CHECK_MS);
    server.close(() => {
      clearTimeout(timer);
      clearInterval(idleCheck);
      resolve();
    });
  });
}
