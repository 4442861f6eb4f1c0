/** Clients that disconnect while the relay still authorises them. */
import { once } from "node:events";
import { createServer, type ServerResponse } from "node:http";
import { connect } from "node:net";
import express from "express";
import { expect, it, onTestFinished, vi } from "vitest";
import { settled } from "../../platform/testing/fake-clock.ts";
import { listen, portOf } from "../../platform/http/listening.ts";
import { withRobot } from "../../robots/testing/robot-at-relay.ts";
import { sensorRoutes } from "../rest/sensors/routes.ts";
import { eventRoutes } from "./routes.ts";

/** Sends a request, disconnects during authorisation, and lets the authorisation finish. */
async function depart(path: string) {
  const { clock, registry, registration, robot } = await withRobot();
  const { promise: gate, resolve: open } = Promise.withResolvers<void>();
  const authorise = registry.authorise.bind(registry);
  vi.spyOn(registry, "authorise").mockImplementation(async (...claim) => {
    await gate;
    return authorise(...claim);
  });
  const server = createServer(express().use(eventRoutes(registry, clock), sensorRoutes(registry)));
  onTestFinished(() => void server.close());
  await listen(server, 0, "127.0.0.1");
  const arrived = once(server, "request") as Promise<[unknown, ServerResponse]>;
  const socket = connect(portOf(server) ?? 0, "127.0.0.1");
  socket.write(
    `GET /robots/${registration.id}${path} HTTP/1.1\r\nHost: relay\r\n` +
      `Authorization: Bearer ${registration.driverKey}\r\n\r\n`,
  );
  const [, response] = await arrived;
  socket.destroy();
  await once(response, "close");
  open();
  await settled();
  return robot.readers.count;
}

it.each(["/events", "/sensors?wait=25"])(
  "a client that disconnects during authorisation of %s no longer counts as a reader",
  async (path) => {
    const count = await depart(path);
    expect(Object.values(count)).toEqual([0, 0, 0, 0]);
  },
);
