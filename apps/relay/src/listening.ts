/** A server's port: taken when it starts, given back when it ends. */
import type { Server } from "node:http";
import type { AddressInfo } from "node:net";

const IDLE_CHECK_MS = 50;

/** @returns the port that is listened on; null when there is none */
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
 * Takes no new connections and waits until requests under way have ended.
 * @param patienceMs after which what is still open is cut off
 * @param cut cuts connections that are no HTTP any more, such as WebSockets
 */
export function closeServer(server: Server, patienceMs: number, cut: () => void): Promise<void> {
  if (!server.listening) return Promise.resolve();
  return new Promise((resolve) => {
    const timer = setTimeout(() => {
      cut();
      server.closeAllConnections();
    }, patienceMs);
    // A connection that was just answered is kept open for the next request.
    const sweep = setInterval(() => server.closeIdleConnections(), IDLE_CHECK_MS);
    server.close(() => {
      clearTimeout(timer);
      clearInterval(sweep);
      resolve();
    });
  });
}
