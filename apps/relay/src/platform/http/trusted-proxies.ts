/**
 * Client address and requested origin behind proxies.
 *
 * Any client can send X-Forwarded-* headers. Only the values that trusted proxies wrote count, from
 * the nearest proxy outward. HTTP and WebSockets share this rule.
 */
import type { IncomingMessage } from "node:http";
import { BlockList, isIP } from "node:net";

/** Number of proxies in front of the relay, or their addresses and networks. */
export type TrustedProxies = number | readonly string[];

/** The client's view of a request, before any proxy. */
export interface Visitor {
  /**
   * IP address, or of IPv6 its network, for limits only; empty if the connection is already closed
   */
  address: string;
  protocol: "http" | "https";
  /** requested host name and port; empty if unknown */
  host: string;
}

/** Whether an address at a number of hops from the relay is a trusted proxy. */
type Trust = (address: string, hop: number) => boolean;

/** Parses an address or a network in CIDR notation. @returns null if invalid */
export function readNetwork(
  text: string,
): { address: string; prefix: number; family: "ipv4" | "ipv6" } | null {
  const [address = "", length, ...rest] = text.split("/");
  const version = isIP(address);
  if (version === 0 || rest.length > 0 || address.includes("%")) return null;
  const maxPrefix = version === 4 ? 32 : 128;
  if (length !== undefined && !/^\d{1,3}$/.test(length)) return null;
  const prefix = length === undefined ? maxPrefix : Number(length);
  return prefix > maxPrefix ? null : { address, prefix, family: `ipv${version === 4 ? 4 : 6}` };
}

/** @returns a function that determines the client of a request */
export function visitorReader(trusted: TrustedProxies): (request: IncomingMessage) => Visitor {
  const isTrusted = typeof trusted === "number" ? byCount(trusted) : byNetwork(trusted);
  return ({ socket, headers }) => {
    const nearest = normaliseAddress(socket.remoteAddress ?? "");
    if (!isTrusted(nearest, 0)) {
      return { address: limitedAddress(nearest), protocol: "http", host: headers.host ?? "" };
    }
    const chain = [nearest, ...list(headers["x-forwarded-for"]).toReversed().map(normaliseAddress)];
    let hop = 0;
    // An invalid address ends the chain at the last verified address.
    while (isIP(chain[hop + 1] ?? "") !== 0 && isTrusted(chain[hop] ?? "", hop)) hop += 1;
    const hops = Math.max(1, hop);
    const protocol = valueAtHop(hops, headers["x-forwarded-proto"])?.toLowerCase();
    return {
      address: limitedAddress(chain[hop] ?? nearest),
      protocol: protocol === "https" ? "https" : "http",
      host: valueAtHop(hops, headers["x-forwarded-host"]) ?? headers.host ?? "",
    };
  };
}

function byCount(proxies: number): Trust {
  return (_address, hop) => hop < proxies;
}

function byNetwork(networks: readonly string[]): Trust {
  const trustedNetworks = new BlockList();
  for (const text of networks) {
    const network = readNetwork(text);
    if (network === null) throw new Error(`${text} is not an address or network`);
    trustedNetworks.addSubnet(network.address, network.prefix, network.family);
  }
  return (address) => {
    const version = isIP(address);
    return version !== 0 && trustedNetworks.check(address, version === 4 ? "ipv4" : "ipv6");
  };
}

/** Removes the IPv4-mapped prefix, which dual-stack sockets report, and the zone. */
function normaliseAddress(address: string): string {
  return address.replace(/^::ffff:(?=\d+\.)/i, "").replace(/%.*$/, "");
}

/** An IPv4 address, or the /64 network of an IPv6 address, in which one client has any number. */
function limitedAddress(address: string): string {
  if (isIP(address) !== 6) return address;
  // A URL contains the canonical form, in which no part is an IPv4 address.
  const canonical = new URL(`http://[${address}]`).hostname.slice(1, -1);
  const groups = (text: string) => text.split(":").filter((group) => group !== "");
  const zeros = 8 - groups(canonical).length;
  const all = groups(canonical.replace("::", `:${"0:".repeat(zeros)}`));
  return `${all.slice(0, 4).join(":")}::/64`;
}

function list(header: string | string[] | undefined): string[] {
  const text = Array.isArray(header) ? header.join(",") : (header ?? "");
  return text === "" ? [] : text.split(",").map((part) => part.trim());
}

/** Value from the farthest trusted proxy. Each proxy replaces the value or appends its own. */
function valueAtHop(hops: number, header: string | string[] | undefined): string | undefined {
  const values = list(header);
  const value = values[Math.max(0, values.length - hops)];
  return value === "" ? undefined : value;
}
