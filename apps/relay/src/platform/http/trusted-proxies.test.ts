import type { IncomingMessage } from "node:http";
import { describe, expect, it } from "vitest";
import { visitorReader, type TrustedProxies } from "./trusted-proxies.ts";

interface Case {
  name: string;
  trusted: TrustedProxies;
  /** remote address of the connection */
  from?: string;
  for?: string;
  proto?: string;
  host?: string;
  /** expected address, protocol and host */
  expected: [string, string, string];
}

const PROXY = "10.0.0.1";
const OWN = "relay.local:8080";

const cases: Case[] = [
  {
    name: "trusts no header by default",
    trusted: 0,
    for: "1.1.1.1",
    proto: "https",
    host: "evil.example",
    expected: [PROXY, "http", OWN],
  },
  {
    name: "trusts no header from a proxy that is not listed",
    trusted: ["10.0.0.2"],
    for: "1.1.1.1",
    proto: "https",
    host: "evil.example",
    expected: [PROXY, "http", OWN],
  },
  {
    name: "trusts the headers of a listed proxy",
    trusted: [PROXY],
    for: "1.1.1.1",
    proto: "https",
    host: "robots.example",
    expected: ["1.1.1.1", "https", "robots.example"],
  },
  {
    name: "falls back to the connection if the proxy adds no headers",
    trusted: 1,
    expected: [PROXY, "http", OWN],
  },
  {
    name: "ignores values that the client wrote before the proxy appended its own",
    trusted: 1,
    for: "6.6.6.6, 1.1.1.1",
    proto: "https, http",
    host: "evil.example, robots.example",
    expected: ["1.1.1.1", "http", "robots.example"],
  },
  {
    name: "ignores values of the client if the proxy is in a trusted network",
    trusted: ["10.0.0.0/8"],
    for: "6.6.6.6, 1.1.1.1",
    proto: "https, http",
    host: "evil.example, robots.example",
    expected: ["1.1.1.1", "http", "robots.example"],
  },
  {
    name: "ignores a forged proxy behind the client",
    trusted: ["10.0.0.0/8"],
    for: "6.6.6.6, 10.0.0.9, 1.1.1.1",
    expected: ["1.1.1.1", "http", OWN],
  },
  {
    name: "supports two proxies that append",
    trusted: 2,
    for: "6.6.6.6, 1.1.1.1, 10.0.0.9",
    proto: "http, https, http",
    host: "evil.example, robots.example, inner.local",
    expected: ["1.1.1.1", "https", "robots.example"],
  },
  {
    name: "supports two proxies of which the inner one forwards the headers unchanged",
    trusted: ["10.0.0.0/8"],
    for: "1.1.1.1, 10.0.0.9",
    proto: "https",
    host: "robots.example",
    expected: ["1.1.1.1", "https", "robots.example"],
  },
  {
    name: "gives no advantage to a client that connects to the inner of two proxies",
    trusted: ["10.0.0.1", "10.0.0.9"],
    for: "6.6.6.6, 1.1.1.1",
    proto: "https, http",
    expected: ["1.1.1.1", "http", OWN],
  },
  {
    name: "stops at an invalid address",
    trusted: 2,
    for: "1.1.1.1, unknown",
    expected: [PROXY, "http", OWN],
  },
  {
    name: "treats an invalid protocol as HTTP",
    trusted: 1,
    for: "1.1.1.1",
    proto: "javascript",
    expected: ["1.1.1.1", "http", OWN],
  },
  {
    name: "supports IPv4-mapped IPv6 addresses",
    trusted: ["10.0.0.0/8"],
    from: "::ffff:10.0.0.1",
    for: "::ffff:1.1.1.1",
    expected: ["1.1.1.1", "http", OWN],
  },
  {
    name: "supports IPv6",
    trusted: ["fd00::/8"],
    from: "fd00::1",
    for: "2001:db8::7",
    expected: ["2001:db8:0:0::/64", "http", OWN],
  },
];

describe("visitorReader", () => {
  it.each(cases)("$name", ({ trusted, from = PROXY, for: chain, proto, host, expected }) => {
    const headers = {
      host: OWN,
      ...(chain !== undefined && { "x-forwarded-for": chain }),
      ...(proto !== undefined && { "x-forwarded-proto": proto }),
      ...(host !== undefined && { "x-forwarded-host": host }),
    };
    const request = { headers, socket: { remoteAddress: from } } as unknown as IncomingMessage;
    const visitor = visitorReader(trusted)(request);
    expect([visitor.address, visitor.protocol, visitor.host]).toEqual(expected);
  });

  it.each([
    ["2001:db8:1:2:3:4:5:6", "2001:db8:1:2::/64"],
    ["2001:0DB8:0001:0002::1", "2001:db8:1:2::/64"],
    ["2001:db8:1:2::", "2001:db8:1:2::/64"],
    ["2001:db8::6", "2001:db8:0:0::/64"],
    ["64:ff9b::1.2.3.4", "64:ff9b:0:0::/64"],
    ["::1", "0:0:0:0::/64"],
    ["fe80::1%eth0", "fe80:0:0:0::/64"],
  ])("counts %s with its network, from which one client has any address", (from, network) => {
    const request = { headers: {}, socket: { remoteAddress: from } } as unknown as IncomingMessage;
    expect(visitorReader(0)(request).address).toBe(network);
  });
});
