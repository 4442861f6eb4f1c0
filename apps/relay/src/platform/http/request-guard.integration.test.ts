import { request } from "node:http";
import { problemSchema, registrationSchema } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { limits } from "../limits/limits.ts";
import { sendBare } from "../testing/bare-http.ts";
import { FakeClock } from "../testing/fake-clock.ts";
import { startTestRelay, type TestRelay } from "../../testing/test-relay.ts";

type Headers = Record<string, string>;

/**
 * Sends a raw request with any Host header. @param headers an object, or a flat list of names and
 * values
 */
function ask(
  relay: TestRelay,
  path: string,
  { method = "GET", headers = {} }: { method?: string; headers?: Headers | string[] } = {},
): Promise<{ status: number; text: string }> {
  return new Promise((resolve, reject) => {
    const outgoing = request(relay.origin + path, { method, headers, agent: false });
    outgoing.once("error", reject);
    outgoing.once("upgrade", (answer, socket) => {
      socket.destroy();
      resolve({ status: answer.statusCode ?? 0, text: "" });
    });
    outgoing.once("response", (answer) => {
      let text = "";
      answer.on("data", (data: Buffer) => (text += data.toString()));
      answer.once("end", () => resolve({ status: answer.statusCode ?? 0, text }));
    });
    outgoing.end();
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

describe("a service with a list of allowed hosts", () => {
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
  ])('responds to Host "$host" with $status', async ({ host, status }) => {
    const relay = await startTestRelay({ config });
    const answer = await ask(relay, register.path, { method: "POST", headers: { Host: host } });
    expect(answer.status).toBe(status);
    if (status !== 421) return;
    const problem = problemSchema.parse(JSON.parse(answer.text));
    expect(problem).toMatchObject({ type: "/problems/wrong-host", status: 421 });
    expect(problem.detail).toContain("ALLOWED_HOSTS");
  });

  it("rejects WebSockets for other hosts", async () => {
    const relay = await startTestRelay({ config });
    const own = await ask(relay, SOCKET, { headers: upgrade({ Host: "robots.example" }) });
    expect(own.status).toBe(101);
    const other = await ask(relay, SOCKET, { headers: upgrade({ Host: "evil.example" }) });
    expect(other.status).toBe(421);
    expect(problemSchema.parse(JSON.parse(other.text)).type).toBe("/problems/wrong-host");
  });

  it("serves health checks under any host", async () => {
    const relay = await startTestRelay({ config });
    for (const path of ["/healthz", "/readyz"]) {
      expect((await ask(relay, path, { headers: { Host: "10.1.2.3:8080" } })).status).toBe(200);
    }
  });

  it("ignores X-Forwarded-Host without a trusted proxy", async () => {
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
  ])("responds with 400: %s, %s", async (first, second) => {
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

describe("a request without exactly one Host header", () => {
  const paths = ["/", "/docs", "/openapi.json", "/api/v1/robots", "/healthz", "/readyz"];

  it.each([
    { name: "none", lines: "" },
    { name: "two", lines: "Host: a\r\nHost: b\r\n" },
  ])("is answered with 400 on every path: $name", async ({ lines }) => {
    const relay = await startTestRelay({ config: { metricsPort: 0 } });
    const statusOf = async (origin: string, path: string): Promise<string> => {
      const answer = await sendBare(
        origin,
        `GET ${path} HTTP/1.1\r\n${lines}Connection: close\r\n\r\n`,
      );
      return `${path} ${answer.status}`;
    };
    const answers = await Promise.all(paths.map((path) => statusOf(relay.origin, path)));
    answers.push(await statusOf(`http://127.0.0.1:${relay.metricsPort}`, "/metrics"));
    expect(answers).toEqual([...paths, "/metrics"].map((path) => `${path} 400`));
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
    {
      name: "in a trusted network",
      trustedProxies: ["127.0.0.0/8"],
      origin: "https://robots.example",
    },
    { name: "within the trusted number", trustedProxies: 1, origin: "https://robots.example" },
    { name: "that is not configured", trustedProxies: 0, origin: "http://relay.local" },
    { name: "in another network", trustedProxies: ["10.0.0.0/8"], origin: "http://relay.local" },
  ])(
    "for a proxy $name, robot addresses have the origin $origin",
    async ({ trustedProxies, origin }) => {
      const relay = await startTestRelay({ config: { trustedProxies } });
      const answer = await ask(relay, register.path, { method: "POST", headers: forwarded });
      const robot = registrationSchema.parse(JSON.parse(answer.text));
      expect(robot.address).toBe(`${origin}/r/${robot.id}#${robot.driverKey}`);
      const page = upgrade({ ...forwarded, Origin: origin });
      expect((await ask(relay, SOCKET, { headers: page })).status).toBe(101);
      const stranger = upgrade({ ...forwarded, Origin: "https://evil.example" });
      expect((await ask(relay, SOCKET, { headers: stranger })).status).toBe(403);
    },
  );

  it("limits registrations by client address, and ignores forged addresses", async () => {
    const statusesFor = async (
      trustedProxies: number,
      from: (n: number) => string,
    ): Promise<number[]> => {
      const relay = await startTestRelay({ config: { trustedProxies }, clock: new FakeClock() });
      const statuses = [];
      for (let n = 0; n <= limits.registrationRate.burst; n++) {
        const headers = { "X-Forwarded-For": from(n) };
        statuses.push((await ask(relay, register.path, { method: "POST", headers })).status);
      }
      return [...new Set(statuses)];
    };
    const forgedAddress = (n: number): string => `203.0.113.${n % 256}`;
    expect(await statusesFor(0, forgedAddress)).toEqual([201, 429]);
    expect(await statusesFor(1, forgedAddress)).toEqual([201]);
    expect(await statusesFor(1, (n) => `${forgedAddress(n)}, 198.51.100.1`)).toEqual([201, 429]);
  });
});
