/** Clients that send many messages before the store has confirmed their key. */
import { createServer } from "node:http";
import { closeReasons, helloSchema, MAX_FRAME_BYTES } from "@corridor/protocol";
import { expect, it, onTestFinished } from "vitest";
import { FakeClock } from "../../platform/testing/fake-clock.ts";
import { listen, portOf } from "../../platform/http/listening.ts";
import { RequestGuard } from "../../platform/http/request-guard.ts";
import { silentLog } from "../../testing/test-relay.ts";
import { TestSocket } from "../../testing/test-socket.ts";
import { WebSocketGateway } from "./websocket-gateway.ts";

const nothing = (): void => undefined;

/** A socket whose hello has been sent to a store that responds once `respond` is called. */
async function waitingSocket() {
  const { promise: response, resolve: respond } = Promise.withResolvers<void>();
  let received = 0;
  const gateway = new WebSocketGateway({
    endpoint: {
      name: "robots",
      helloSchema,
      maxMessageBytes: MAX_FRAME_BYTES,
      connectionsPerAddress: 1,
      unauthorised: { reason: closeReasons.notAuthorised },
      checkId: () => null,
      admit: async () => {
        await response;
        return {
          requested: nothing,
          start: (connection) => ({
            received: () => {
              received += 1;
              connection.send(JSON.stringify({ type: "received", received }));
              return undefined;
            },
            heartbeat: nothing,
            closed: nothing,
          }),
        };
      },
      closingOf: () => null,
    },
    clock: new FakeClock(),
    log: silentLog,
    guard: new RequestGuard({ publicOrigin: null, allowedHosts: null, trustedProxies: 0 }),
    metrics: { refused: nothing, socketClosed: nothing, gatewayMessage: nothing },
  });
  const server = createServer().on("upgrade", (...upgrade) => gateway.upgrade(...upgrade));
  await listen(server, 0, "127.0.0.1");
  onTestFinished(() => {
    gateway.destroyAll();
    server.close();
  });
  const origin = `http://127.0.0.1:${portOf(server)}`;
  const socket = await TestSocket.at({ origin }, `/robots/${"A".repeat(22)}/socket`);
  socket.send({ type: "hello", version: 1, role: "drive", key: `drv_${"A".repeat(22)}` });
  return { socket, respond };
}

it("receives what a client sends while its key is checked", async () => {
  const { socket, respond } = await waitingSocket();
  for (let n = 0; n < 31; n++) socket.sendRaw("message");
  respond();
  for (let n = 1; n <= 31; n++)
    expect(await socket.next("received")).toMatchObject({ received: n });
});

it.each([
  { name: "32 messages", count: 32, bytes: 10 },
  { name: "128 KiB", count: 9, bytes: 16 * 1024 },
])("closes a client that sends more than $name while its key is checked", async (sent) => {
  const { socket } = await waitingSocket();
  for (let n = 0; n < sent.count; n++) socket.sendRaw("x".repeat(sent.bytes));
  expect(await socket.closed).toMatchObject({
    code: 4401,
    reason: "Too many messages before the key was checked. Wait for the response.",
  });
});
