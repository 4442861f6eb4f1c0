import { once } from "node:events";
import { createServer, type RequestListener } from "node:http";
import { connect, type AddressInfo } from "node:net";
import { describe, expect, it, onTestFinished } from "vitest";
import { sendBare } from "../testing/bare-http.ts";
import { toldBy } from "../testing/doors.ts";
import { startTestRelay } from "../testing/test-relay.ts";
import { answerBrokenRequests } from "./broken-requests.ts";

/** A server of little patience. @returns its origin and what it refused */
async function impatientServer(application: RequestListener) {
  const refused: string[] = [];
  const server = createServer({ headersTimeout: 50, connectionsCheckingInterval: 10 });
  answerBrokenRequests(server, application, (kind) => void refused.push(kind));
  server.on("request", application);
  server.listen(0, "127.0.0.1");
  await once(server, "listening");
  onTestFinished(() => void server.close());
  return { origin: `http://127.0.0.1:${(server.address() as AddressInfo).port}`, refused };
}

describe("a request that no application could get", () => {
  it.each([
    { name: "no HTTP at all", bytes: "hello robot\r\n\r\n", answer: "400 bad-request" },
    {
      name: "no Host",
      bytes: "GET / HTTP/1.1\r\nConnection: close\r\n\r\n",
      answer: "400 bad-request",
    },
    {
      name: "a tunnel",
      bytes: "CONNECT school.example:443 HTTP/1.1\r\nHost: a\r\n\r\n",
      answer: "405 method-not-allowed",
    },
    {
      name: "two lengths",
      bytes:
        "POST / HTTP/1.1\r\nHost: a\r\nContent-Length: 1\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n",
      answer: "400 bad-request",
    },
    {
      name: "an expectation that nobody knows",
      bytes:
        "GET /api/v1/robots HTTP/1.1\r\nHost: a\r\nExpect: wonders\r\nConnection: close\r\n\r\n",
      answer: "405 method-not-allowed",
    },
  ])("is answered in words: $name", async ({ bytes, answer }) => {
    const relay = await startTestRelay();
    expect(toldBy(await sendBare(relay.origin, bytes))).toMatchObject({
      answer,
    });
  });

  it("is told how long it may take when its headers do not come to an end", async () => {
    const { origin, refused } = await impatientServer(() => undefined);
    const told = toldBy(await sendBare(origin, "GET / HTTP/1.1\r\nHost: a\r\n"));
    expect(told).toMatchObject({ answer: "408 too-slow", says: expect.stringContaining("10 s") });
    expect(refused).toEqual(["too-slow"]);
  });

  it("is cut off without a word where an answer is under way", async () => {
    const { origin } = await impatientServer((_request, response) => {
      response.writeHead(200, { "Content-Type": "text/event-stream" });
      response.write("data: 1\n\n");
    });
    const socket = connect(Number(new URL(origin).port), "127.0.0.1");
    let answer = "";
    socket.on("data", (data) => (answer += String(data)));
    socket.write("GET / HTTP/1.1\r\nHost: a\r\n\r\n");
    await once(socket, "data");
    socket.write("hello robot\r\n\r\n");
    await once(socket, "close");
    expect(answer.match(/HTTP\/1\.1/g)).toHaveLength(1);
  });
});
