/**
 * Who asks, and for which address, where proxies stand in front of the relay.
 *
 * Anybody can write X-Forwarded-* headers. They count only as far as they were written by proxies that
 * the operator has named, read from the nearest proxy outward; HTTP and WebSockets go by this one rule.
 */
import type { IncomingMessage } from "node:http";
import { BlockList, isIP } from "node:net";

/** How many proxies stand in front, or the addresses and networks that they have. */
export type TrustedProxies = number | readonly string[];

/** A request as its sender made it, before any proxy. */
export interface Visitor {
  /** IP address, for limits only; empty when the connection is gone already */
  address: string;
  protocol: "http" | "https";
  /** name and port in the address that was asked for; empty when nothing says it */
  host: string;
}

/** Whether the address, so many hops away from the relay, is that of a trusted proxy. */
type Trust = (address: string, hop: number) => boolean;

/** An address or a network in CIDR form. @returns null when it is neither */
export function readNetwork(
  text: string,
): { address: string; prefix: number; family: "ipv4" | "ipv6" } | null {
  const [address = "", length, ...rest] = text.split("/");
  const version = isIP(address);
  if (version === 0 || rest.length > 0 || address.includes("%")) return null;
  const longest = version === 4 ? 32 : 128;
  if (length !== undefined && !/^\d{1,3}$/.test(length)) return null;
  const prefix = length === undefined ? longest : Number(length);
  return prefix > longest ? null : { address, prefix, family: `ipv${version === 4 ? 4 : 6}` };
}

/** @returns how to read the visitor from a request */
export function visitorReader(trusted: TrustedProxies): (request: IncomingMessage) => Visitor {
  const trusts = typeof trusted === "number" ? byCount(trusted) : byNetwork(trusted);
  return ({ socket, headers }) => {
    const nearest = plain(socket.remoteAddress ?? "");
    if (!trusts(nearest, 0)) {
      return { address: nearest, protocol: "http", host: headers.host ?? "" };
    }
    const chain = [nearest, ...list(headers["x-forwarded-for"]).toReversed().map(plain)];
    let hop = 0;
    // What is no address leads nowhere: the visitor stays who was last known for certain.
    while (isIP(chain[hop + 1] ?? "") !== 0 && trusts(chain[hop] ?? "", hop)) hop += 1;
    const hops = Math.max(1, hop);
    const protocol = saidAt(hops, headers["x-forwarded-proto"])?.toLowerCase();
    return {
      address: chain[hop] ?? nearest,
      protocol: protocol === "https" ? "https" : "http",
      host: saidAt(hops, headers["x-forwarded-host"]) ?? headers.host ?? "",
    };
  };
}

function byCount(proxies: number): Trust {
  return (_address, hop) => hop < proxies;
}

function byNetwork(networks: readonly string[]): Trust {
  const known = new BlockList();
  for (const text of networks) {
    const network = readNetwork(text);
    if (network === null) throw new Error(`${text} is no address or network`);
    known.addSubnet(network.address, network.prefix, network.family);
  }
  return (address) => {
    const version = isIP(address);
    return version !== 0 && known.check(address, version === 4 ? "ipv4" : "ipv6");
  };
}

/** An IPv4 address is written in two ways where both families are listened on; and no zones. */
function plain(address: string): string {
  return address.replace(/^::ffff:(?=\d+\.)/i, "").replace(/%.*$/, "");
}

function list(header: string | string[] | undefined): string[] {
  const text = Array.isArray(header) ? header.join(",") : (header ?? "");
  return text === "" ? [] : text.split(",").map((part) => part.trim());
}

/** What the farthest trusted proxy said: each proxy replaces the value or adds its own at the end. */
function saidAt(hops: number, header: string | string[] | undefined): string | undefined {
  const values = list(header);
  const value = values[Math.max(0, values.length - hops)];
  return value === "" ? undefined : value;
}
