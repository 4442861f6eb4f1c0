/** Makes a server listen, and explains why it cannot. */
import { once } from "node:events";
import type { AddressInfo, Server } from "node:net";
import type { ListenAddress } from "./bridge-arguments.ts";
import { BridgeError } from "./bridge-error.ts";

/** @param option that chooses another port @returns the port @throws BridgeError */
export async function listen(
  server: Server,
  { host, port }: ListenAddress,
  option = "--port",
): Promise<number> {
  try {
    await once(server.listen(port, host), "listening");
  } catch (error) {
    const { code = "" } = error as NodeJS.ErrnoException;
    const sentence = sentences[code]?.({ host, port, option });
    throw new BridgeError(sentence ?? `Cannot listen on port ${port} of ${host} (${code}).`, {
      cause: error,
    });
  }
  return (server.address() as AddressInfo).port;
}

type Place = ListenAddress & { option: string };

const sentences: Readonly<Record<string, (place: Place) => string>> = {
  EADDRINUSE: ({ port, option }) =>
    `Port ${port} is in use. Stop the other program, or choose another port with ${option}.`,
  EACCES: ({ port, option }) =>
    `Port ${port} is not permitted. Choose a port above 1023 with ${option}.`,
  EADDRNOTAVAIL: noAddress,
  ENOTFOUND: noAddress,
  EAI_AGAIN: noAddress,
};

function noAddress({ host }: Place): string {
  return `This computer has no address ${host}. Omit --host, or use 0.0.0.0 for all addresses.`;
}

/** The host as clients of this computer write it. */
export function shownHost(host: string): string {
  return ["127.0.0.1", "::1", "0.0.0.0", "::"].includes(host) ? "localhost" : host;
}

/** Whether only programs of this computer can connect. */
export function isLoopback(host: string): boolean {
  return host === "localhost" || host === "::1" || /^127(?:\.\d{1,3}){3}$/.test(host);
}
