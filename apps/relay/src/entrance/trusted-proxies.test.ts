import type { IncomingMessage } from "node:http";
import { describe, expect, it } from "vitest";
import { visitorReader, type TrustedProxies } from "./trusted-proxies.ts";

interface Case {
  name: string;
  trusted: TrustedProxies;
  /** address of the connection itself */
  from?: string;
  for?: string;
  proto?: string;
  host?: string;
  /** address, protocol, host */
  is: [string, string, string];
}

const PROXY = "10.0.0.1";
const OWN = "relay.local:8080";

const cases: Case[] = [
  {
    name: "nothing is believed by default",
    trusted: 0,
    for: "1.1.1.1",
    proto: "https",
    host: "evil.example",
    is: [PROXY, "http", OWN],
  },
  {
    name: "nor from a connection that is no named proxy",
    trusted: ["10.0.0.2"],
    for: "1.1.1.1",
    proto: "https",
    host: "evil.example",
    is: [PROXY, "http", OWN],
  },
  {
    name: "a named proxy is",
    trusted: [PROXY],
    for: "1.1.1.1",
    proto: "https",
    host: "robots.example",
    is: ["1.1.1.1", "https", "robots.example"],
  },
  {
    name: "a proxy that says nothing is asked about nothing",
    trusted: 1,
    is: [PROXY, "http", OWN],
  },
  {
    name: "what the visitor wrote before the proxy added to it does not count",
    trusted: 1,
    for: "6.6.6.6, 1.1.1.1",
    proto: "https, http",
    host: "evil.example, robots.example",
    is: ["1.1.1.1", "http", "robots.example"],
  },
  {
    name: "nor does it with a network",
    trusted: ["10.0.0.0/8"],
    for: "6.6.6.6, 1.1.1.1",
    proto: "https, http",
    host: "evil.example, robots.example",
    is: ["1.1.1.1", "http", "robots.example"],
  },
  {
    name: "a forged proxy behind the visitor does not count",
    trusted: ["10.0.0.0/8"],
    for: "6.6.6.6, 10.0.0.9, 1.1.1.1",
    is: ["1.1.1.1", "http", OWN],
  },
  {
    name: "two proxies that add",
    trusted: 2,
    for: "6.6.6.6, 1.1.1.1, 10.0.0.9",
    proto: "http, https, http",
    host: "evil.example, robots.example, inner.local",
    is: ["1.1.1.1", "https", "robots.example"],
  },
  {
    name: "two proxies of which the inner one passes on",
    trusted: ["10.0.0.0/8"],
    for: "1.1.1.1, 10.0.0.9",
    proto: "https",
    host: "robots.example",
    is: ["1.1.1.1", "https", "robots.example"],
  },
  {
    name: "a visitor who comes to the inner of two proxies gains nothing",
    trusted: ["10.0.0.1", "10.0.0.9"],
    for: "6.6.6.6, 1.1.1.1",
    proto: "https, http",
    is: ["1.1.1.1", "http", OWN],
  },
  {
    name: "an address that is none leads nowhere",
    trusted: 2,
    for: "1.1.1.1, unknown",
    is: [PROXY, "http", OWN],
  },
  {
    name: "a protocol that is none is plain HTTP",
    trusted: 1,
    for: "1.1.1.1",
    proto: "javascript",
    is: ["1.1.1.1", "http", OWN],
  },
  {
    name: "IPv4 in the clothes of IPv6",
    trusted: ["10.0.0.0/8"],
    from: "::ffff:10.0.0.1",
    for: "::ffff:1.1.1.1",
    is: ["1.1.1.1", "http", OWN],
  },
  {
    name: "IPv6",
    trusted: ["fd00::/8"],
    from: "fd00::1",
    for: "2001:db8::7",
    is: ["2001:db8::7", "http", OWN],
  },
];

describe("a visitor behind proxies", () => {
  it.each(cases)("$name", ({ trusted, from = PROXY, for: chain, proto, host, is }) => {
    const headers = {
      host: OWN,
      ...(chain !== undefined && { "x-forwarded-for": chain }),
      ...(proto !== undefined && { "x-forwarded-proto": proto }),
      ...(host !== undefined && { "x-forwarded-host": host }),
    };
    const request = { headers, socket: { remoteAddress: from } } as unknown as IncomingMessage;
    const visitor = visitorReader(trusted)(request);
    expect([visitor.address, visitor.protocol, visitor.host]).toEqual(is);
  });
});
