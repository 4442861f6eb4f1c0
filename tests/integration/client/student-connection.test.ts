/** A student of a class behind filters that break WebSockets, with a real relay. */
import { classViewSchema, closeReasons } from "@corridor/protocol";
import { describe, expect, it, onTestFinished } from "vitest";
import { ClassAtRelay } from "../../../apps/relay/src/testing/class-at-relay.ts";
import { StudentConnection } from "../../../packages/client/src/student-connection.ts";
import type { FilterMode } from "../../support/client/filter-proxy.ts";
import { startFilterProxy } from "../../support/client/start-filter-proxy.ts";
import { sharedRelayProcess } from "../../support/test-relay-process.ts";

/** long enough for the attempts before the fallback */
const PATIENT = { timeout: 30_000 };

const modes: FilterMode[] = ["none", "blocked", "buffering"];

const sharedRelay = sharedRelayProcess();

/** A class with one student, who has connected. */
async function inClass(mode: FilterMode) {
  const relay = await sharedRelay();
  const proxy = await startFilterProxy(relay.url, mode);
  const room = await ClassAtRelay.create({ origin: relay.url });
  const { key } = await room.join();
  const open = () => {
    const log: string[] = [];
    const connection = new StudentConnection({
      origin: proxy.origin,
      id: room.created.id,
      key,
      onMessage: ({ type }) => log.push(type),
      onStatus: (status) =>
        log.push(status.kind === "over" ? `over ${status.reason.code}` : status.kind),
    });
    onTestFinished(() => connection.close());
    return { connection, log };
  };
  const connect = async () => {
    const opened = open();
    await expect.poll(() => opened.log.at(-1), PATIENT).toBe("connected");
    return opened;
  };
  return { room, open, connect };
}

describe.each(modes)("a student behind a filter (%s)", (mode) => {
  it("connects, asks for help, and receives a pause", async () => {
    const { room, connect } = await inClass(mode);
    const { connection, log } = await connect();
    connection.send({ type: "help", wanted: true });
    const helpSince = async () => {
      const { students } = classViewSchema.parse(await (await room.direct("GET")).json());
      return students[0]?.helpSince;
    };
    await expect.poll(helpSince, PATIENT).toEqual(expect.any(String));
    await room.direct("PUT", "/pause", { seconds: 60 });
    await expect.poll(() => log.at(-1), PATIENT).toBe("pause");
  });

  it("ends when another tab takes over, and when the class ends", async () => {
    const { room, open, connect } = await inClass(mode);
    const first = await connect();
    const second = await connect();
    await expect.poll(() => first.log.at(-1), PATIENT).toBe(`over ${closeReasons.replaced.code}`);
    await room.direct("DELETE");
    const over = `over ${closeReasons.over.code}`;
    await expect.poll(() => second.log.at(-1), PATIENT).toBe(over);
    const late = open();
    await expect.poll(() => late.log.at(-1), PATIENT).toBe(over);
  });
});
