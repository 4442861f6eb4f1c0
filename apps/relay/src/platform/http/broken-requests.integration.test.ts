import { once } from "node:events";
import { createServer, type RequestListener } from "node:http";
import { connect, type AddressInfo } from "node:net";
import { describe, expect, it, onTestFinished } from "vitest";
import { sendBare } from "../testing/bare-http.ts";
import { outcomeOf } from "../../testing/endpoints.ts";
import { startTestRelay } from "../../testing/test-relay.ts";
import { answerBrokenRequests } from "./broken-requests.ts";

/** Starts a server with short timeouts. @returns its origin and the problems it reported */
async function startServer(application: RequestListener) {
  const refused: string[] = [];
  const server = createServer({ headersTimeout: 50, connectionsCheckingInterval: 10 });
  answerBrokenRequests(server, application, (kind) => void refused.push(kind));
  server.on("request", application);
  server.listen(0, "127.0.0.1");
  await once(server, "listening");
  onTestFinished(() => void server.close());
  return { origin: `http://127.0.0.1:${(server.address() as AddressInfo).port}`, refused };
}

describe("a request that the application cannot handle", () => {
  it.each([
    { name: "not HTTP", bytes: "hello robot\r\n\r\n", answer: "400 bad-request" },
    {
      name: "without Host",
      bytes: "GET / HTTP/1.1\r\nConnection: close\r\n\r\n",
      answer: "400 bad-request",
    },
    {
      name: "CONNECT",
      bytes: "CONNECT school.example:443 HTTP/1.1\r\nHost: a\r\n\r\n",
      answer: "405 method-not-allowed",
    },
    {
      name: "with two Content-Length headers",
      bytes:
        "POST / HTTP/1.1\r\nHost: a\r\nContent-Length: 1\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n",
      answer: "400 bad-request",
    },
    {
      name: "with an unknown expectation",
      bytes:
        "GET /api/v1/robots HTTP/1.1\r\nHost: a\r\nExpect: wonders\r\nConnection: close\r\n\r\n",
      answer: "405 method-not-allowed",
    },
  ])("receives an explanation: $name", async ({ bytes, answer }) => {
    const relay = await startTestRelay();
    expect(outcomeOf(await sendBare(relay.origin, bytes))).toMatchObject({
      answer,
    });
  });

  it("receives the time limit if its headers are incomplete", async () => {
    const { origin, refused } = await startServer(() => undefined);
    const response = outcomeOf(await sendBare(origin, "GET / HTTP/1.1\r\nHost: a\r\n"));
    expect(response).toMatchObject({
      answer: "408 too-slow",
      says: expect.stringContaining("10 s"),
    });
    expect(refused).toEqual(["too-slow"]);
  });

  it("is dropped without a response if one has already started", async () => {
    const { origin } = await startServer((_request, response) => {
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
