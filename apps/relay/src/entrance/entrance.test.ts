import { request } from "node:http";
import { problemSchema, registrationSchema } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { limits } from "../sessions/limits.ts";
import { FakeClock } from "../testing/fake-clock.ts";
import { startTestRelay, type TestRelay } from "../testing/test-relay.ts";

type Headers = Record<string, string>;

/** A bare request, whose Host may be any. @param headers also as names and values by turns */
function ask(
  relay: TestRelay,
  path: string,
  { method = "GET", headers = {} }: { method?: string; headers?: Headers | string[] } = {},
): Promise<{ status: number; text: string }> {
  return new Promise((resolve, reject) => {
    const asked = request(relay.origin + path, { method, headers, agent: false });
    asked.once("error", reject);
    asked.once("upgrade", (answer, socket) => {
      socket.destroy();
      resolve({ status: answer.statusCode ?? 0, text: "" });
    });
    asked.once("response", (answer) => {
      let text = "";
      answer.on("data", (data: Buffer) => (text += data.toString()));
      answer.once("end", () => resolve({ status: answer.statusCode ?? 0, text }));
    });
    asked.end();
  });
}

const upgrade = (headers: Headers): Headers => ({
  Connection: "Upgrade",
  Upgrade: "websocket",
  "Sec-WebSocket-Version": "13",
  "Sec-WebSocket-Key": "dGhlIHNhbXBsZSBub25jZQ==",
  ...headers,
});
const SOCKET = "/api/v1/robots/AAAAAAAAAAAAAAAAAAAAAA/socket";
const register = { path: "/api/v1/robots", method: "POST" };

describe("a service that knows its names", () => {
  const config = {
    allowedHosts: ["robots.example"],
    publicOrigin: "https://public.example",
    trustedProxies: 0,
  };

  it.each([
    { host: "robots.example", status: 201 },
    { host: "ROBOTS.example:8443", status: 201 },
    { host: "public.example", status: 201 },
    { host: "evil.example", status: 421 },
    { host: "robots.example.evil.example", status: 421 },
    { host: "robots.example@evil.example", status: 421 },
    { host: "127.0.0.1", status: 421 },
    { host: "", status: 421 },
  ])('answers Host "$host" with $status', async ({ host, status }) => {
    const relay = await startTestRelay({ config });
    const answer = await ask(relay, register.path, { method: "POST", headers: { Host: host } });
    expect(answer.status).toBe(status);
    if (status !== 421) return;
    const problem = problemSchema.parse(JSON.parse(answer.text));
    expect(problem).toMatchObject({ type: "/problems/wrong-host", status: 421 });
    expect(problem.detail).toContain("ALLOWED_HOSTS");
  });

  it("opens no WebSocket under another name", async () => {
    const relay = await startTestRelay({ config });
    const own = await ask(relay, SOCKET, { headers: upgrade({ Host: "robots.example" }) });
    expect(own.status).toBe(101);
    const other = await ask(relay, SOCKET, { headers: upgrade({ Host: "evil.example" }) });
    expect(other.status).toBe(421);
    expect(problemSchema.parse(JSON.parse(other.text)).type).toBe("/problems/wrong-host");
  });

  it("is asked for its health under any name", async () => {
    const relay = await startTestRelay({ config });
    for (const path of ["/healthz", "/readyz"]) {
      expect((await ask(relay, path, { headers: { Host: "10.1.2.3:8080" } })).status).toBe(200);
    }
  });

  it("does not take a name from a header that anybody can write", async () => {
    const relay = await startTestRelay({ config });
    const headers = { Host: "evil.example", "X-Forwarded-Host": "robots.example" };
    expect((await ask(relay, register.path, { method: "POST", headers })).status).toBe(421);
    expect((await ask(relay, SOCKET, { headers: upgrade(headers) })).status).toBe(421);
  });
});

describe("a request with two Host headers", () => {
  it.each([
    ["robots.example", "evil.example"],
    ["robots.example", "robots.example"],
  ])("is answered with 400: %s, %s", async (first, second) => {
    const relay = await startTestRelay();
    const headers = ["Host", first, "Host", second];
    const answer = await ask(relay, register.path, { method: "POST", headers });
    expect(answer.status).toBe(400);
    expect(problemSchema.parse(JSON.parse(answer.text)).detail).toContain("Send it once");
    const socket = await ask(relay, SOCKET, {
      headers: [...headers, ...Object.entries(upgrade({})).flat()],
    });
    expect(socket.status).toBe(400);
  });
});

describe("behind a proxy", () => {
  const forwarded = {
    Host: "relay.local",
    "X-Forwarded-For": "203.0.113.7",
    "X-Forwarded-Proto": "https",
    "X-Forwarded-Host": "robots.example",
  };

  it.each([
    { name: "that is trusted", trustedProxies: ["127.0.0.0/8"], origin: "https://robots.example" },
    { name: "that is counted", trustedProxies: 1, origin: "https://robots.example" },
    { name: "that nobody named", trustedProxies: 0, origin: "http://relay.local" },
    { name: "that is another", trustedProxies: ["10.0.0.0/8"], origin: "http://relay.local" },
  ])("$name, robots have addresses at $origin", async ({ trustedProxies, origin }) => {
    const relay = await startTestRelay({ config: { trustedProxies } });
    const answer = await ask(relay, register.path, { method: "POST", headers: forwarded });
    const robot = registrationSchema.parse(JSON.parse(answer.text));
    expect(robot.address).toBe(`${origin}/r/${robot.id}#${robot.driverKey}`);
    const page = upgrade({ ...forwarded, Origin: origin });
    expect((await ask(relay, SOCKET, { headers: page })).status).toBe(101);
    const stranger = upgrade({ ...forwarded, Origin: "https://evil.example" });
    expect((await ask(relay, SOCKET, { headers: stranger })).status).toBe(403);
  });

  it("counts registrations by visitor, and a forged visitor as the one who forges", async () => {
    const used = async (trustedProxies: number, from: (n: number) => string): Promise<number[]> => {
      const relay = await startTestRelay({ config: { trustedProxies }, clock: new FakeClock() });
      const statuses = [];
      for (let n = 0; n <= limits.registrationRate.burst; n++) {
        const headers = { "X-Forwarded-For": from(n) };
        statuses.push((await ask(relay, register.path, { method: "POST", headers })).status);
      }
      return [...new Set(statuses)];
    };
    const invented = (n: number): string => `203.0.113.${n % 256}`;
    expect(await used(0, invented)).toEqual([201, 429]);
    expect(await used(1, invented)).toEqual([201]);
    expect(await used(1, (n) => `${invented(n)}, 198.51.100.1`)).toEqual([201, 429]);
  });
});
