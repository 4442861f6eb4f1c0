/** Finds a free port for a server that cannot select one itself. */
import { createServer, type AddressInfo } from "node:net";

/** @returns a loopback port that was free when checked; another process may take it later */
export async function freePort(): Promise<number> {
  const server = createServer();
  await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
  const { port } = server.address() as AddressInfo;
  await new Promise((resolve) => server.close(resolve));
  return port;
}
