import { closeReasons, type ReadResult } from "@corridor/protocol";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { Connection, type ConnectionStatus } from "./connection.ts";
import type { Clock, HttpRequest, SendRequest } from "./platform.ts";
import { FakePlatform, type FakeSocket } from "./testing/fake-platform.ts";

interface Message {
  type: string;
  n?: number;
}

const WELCOME = { type: "welcome" };
const URLS = { websocket: "ws://relay/socket", "long-poll": "http://relay/long-poll" };

function decode(text: string): ReadResult<Message> {
  const value = JSON.parse(text) as Message;
  return value.type === "unknown" ? { ok: false, problems: [] } : { ok: true, value };
}

/** An opened connection. @param relay without it, there is no fallback for WebSockets */
function withConnection(relay?: (clock: Clock) => SendRequest) {
  const fake = new FakePlatform();
  const platform = relay === undefined ? fake : Object.assign(fake, { request: relay(fake.clock) });
  const received: Message[] = [];
  const statuses: ConnectionStatus[] = [];
  /** messages and statuses in order */
  const events: string[] = [];
  const connection = new Connection<Message>({
    urls: URLS,
    platform,
    firstMessages: () => ['{"type":"hello"}', '{"type":"resume"}'],
    decode,
    received: (message) => {
      received.push(message);
      events.push(message.type);
    },
    changed: (status) => {
      statuses.push(status);
      events.push(status.kind);
    },
  });
  connection.open();
  const welcome = (socket = platform.socket): void => {
    socket.open();
    socket.receive(WELCOME);
  };
  const openSockets = (): FakeSocket[] => platform.sockets.filter(({ isClosed }) => !isClosed);
  return { platform, connection, received, statuses, events, welcome, openSockets };
}

describe("a connection", () => {
  it("introduces itself first on each socket, and is connected from the welcome on", () => {
    const { platform, connection, events, welcome } = withConnection();
    expect(connection.isConnected).toBe(false);
    welcome();
    platform.socket.receive({ type: "news" });
    platform.socket.cut(1006);
    platform.pass(10_000);
    welcome();
    expect(events.join(" ")).toBe(
      "connecting welcome connected news lost connecting welcome connected",
    );
    for (const { sent } of platform.sockets) {
      expect(sent.map(({ type }) => type)).toEqual(["hello", "resume"]);
    }
    expect(connection.isConnected).toBe(true);
  });

  it("sends nothing before the welcome and after the end, not even later", () => {
    const { platform, connection, welcome } = withConnection();
    const send = (n: number) => connection.send(JSON.stringify({ type: "command", n }));
    send(1);
    platform.socket.open();
    send(2);
    platform.socket.receive(WELCOME);
    send(3);
    platform.socket.cut(1006);
    send(4);
    platform.pass(10_000);
    welcome();
    const numbers = platform.sockets.map(({ sent }) => sent.slice(2).map(({ n }) => n));
    expect(numbers).toEqual([[3], []]);
  });

  it("stays, and says nothing, when it receives a message of a newer relay", () => {
    const { platform, received, events, welcome } = withConnection();
    welcome();
    platform.socket.receive({ type: "unknown" });
    expect(received).toEqual([WELCOME]);
    expect(events.at(-1)).toBe("connected");
    platform.socket.receive({ type: "news" });
    expect(received.at(-1)).toEqual({ type: "news" });
  });

  it("ignores whatever a socket that it gave up does later", () => {
    const { platform, connection, received, events, welcome } = withConnection();
    // No welcome: the socket counts as lost.
    platform.pass(20_000);
    const [late] = platform.sockets;
    expect(platform.sockets.length).toBeGreaterThan(1);
    welcome();
    const before = [...events];
    late?.open();
    late?.receive({ type: "news" });
    late?.cut(closeReasons.over.code);
    expect(late?.sent).toEqual([]);
    expect(received).toEqual([WELCOME]);
    expect(events).toEqual(before);
    expect(connection.isConnected).toBe(true);
  });

  it.each(Object.entries(closeReasons))(
    "closed with the reason %s tries again exactly if that can help",
    (_name, reason) => {
      const { platform, connection, statuses, welcome } = withConnection();
      welcome();
      platform.socket.cut(reason.code);
      expect(statuses.at(-1)).toMatchObject({ kind: reason.retry ? "lost" : "over", reason });
      platform.pass(60_000);
      connection.open();
      expect(platform.sockets.length > 1).toBe(reason.retry);
    },
  );

  it("is lost after 45 s of silence, and not as long as anything arrives", () => {
    const { platform, events, welcome } = withConnection();
    welcome();
    for (let n = 0; n < 10; n++) {
      platform.pass(44_999);
      platform.socket.receive({ type: n % 2 === 0 ? "heartbeat" : "unknown" });
    }
    expect(events.at(-1)).not.toBe("lost");
    platform.pass(45_000);
    expect(events.at(-1)).toBe("lost");
    expect(platform.socket.isClosed).toBe(true);
  });

  it("connects at once when it is asked to, instead of waiting, and only once", () => {
    const { platform, connection, welcome } = withConnection();
    welcome();
    platform.luck = 0.999;
    platform.socket.cut(1006);
    connection.open();
    connection.open();
    expect(platform.sockets).toHaveLength(2);
    welcome();
    // The delay that it did not wait for is over.
    platform.pass(10_000);
    expect(platform.sockets).toHaveLength(2);
  });

  it("that was closed is silent until it is opened again", () => {
    const { platform, connection, events, welcome } = withConnection();
    welcome();
    connection.close();
    const before = [...events];
    platform.socket.receive({ type: "news" });
    platform.socket.cut(closeReasons.over.code);
    platform.pass(600_000);
    expect(events).toEqual(before);
    expect(platform.sockets).toHaveLength(1);
    connection.open();
    welcome();
    expect(events.slice(before.length)).toEqual(["connecting", "welcome", "connected"]);
  });
});

/** What relay, network and user do in any order. */
type Deed = "open" | "welcome" | "message" | "lose" | "end" | "connect" | "close" | "wait";
const anyDeeds = fc.array(
  fc.record({
    deed: fc.constantFrom<Deed>(
      ...(["open", "welcome", "message", "lose", "connect", "close", "wait", "end"] as const),
    ),
    /** which socket: the newest is the most frequent one */
    back: fc.constantFrom(0, 0, 0, 1, 2),
    ms: fc.integer({ min: 1, max: 60_000 }),
  }),
  { maxLength: 40 },
);

describe("whatever relay, network and user do, a connection", () => {
  it("has at most one socket, and reports what is true of it", () => {
    fc.assert(
      fc.property(anyDeeds, (deeds) => {
        const { platform, connection, statuses, openSockets } = withConnection();
        const ended = new Set<FakeSocket>();
        for (const { deed, back, ms } of deeds) {
          const socket = platform.sockets.at(-1 - back);
          if (deed === "wait") platform.pass(ms);
          else if (deed === "connect") connection.open();
          else if (deed === "close") connection.close();
          else if (socket === undefined || ended.has(socket)) continue;
          else if (deed === "open") socket.open();
          else if (deed === "welcome") socket.receive(WELCOME);
          else if (deed === "message") socket.receive({ type: "news" });
          else {
            ended.add(socket);
            socket.cut(deed === "lose" ? 1006 : closeReasons.over.code);
          }
          expect(openSockets().length).toBeLessThanOrEqual(1);
          const status = statuses.at(-1)?.kind;
          expect(connection.isConnected && status !== "connected").toBe(false);
          expect(status === "over" && openSockets().length > 0).toBe(false);
        }
        const kinds = statuses.map(({ kind }) => kind).join(" ");
        // Each welcome follows an attempt, and nothing follows the end.
        expect(kinds).not.toMatch(/(?<!connecting )connected|over ./);
      }),
      { numRuns: 300 },
    );
  });
});

/** A relay that is reachable by long polling. It sends its welcome, and then heartbeats. */
function longPollRelay(clock: Clock): SendRequest {
  let sent = 0;
  const respond = async ({ method, url }: HttpRequest) => {
    if (method === "POST" && url === URLS["long-poll"]) {
      return { status: 201, body: '{"key":"con_AAAAAAAAAAAAAAAAAAAAAA"}' };
    }
    if (method === "POST") return { status: 200, body: '{"taken":1}' };
    if (sent > 0) await new Promise<void>((resolve) => void clock.after(20_000, resolve));
    const message = sent === 0 ? WELCOME : { type: "heartbeat" };
    sent += 1;
    const messages = { first: sent, messages: [message], closed: null };
    return { status: 200, body: JSON.stringify(messages) };
  };
  return (request) => ({ response: respond(request), cancel: () => undefined });
}

describe("a connection in a network that blocks WebSockets", () => {
  async function blocked() {
    const page = withConnection(longPollRelay);
    /** Responses arrive between the seconds. */
    const pass = async (ms: number): Promise<void> => {
      for (let passed = 0; passed < ms; passed += 1_000) {
        page.platform.pass(1_000);
        await new Promise((resolve) => setImmediate(resolve));
      }
    };
    await pass(5_000);
    return { ...page, pass };
  }

  it("is there by long polling after 4 s, without being reported as lost", async () => {
    const { connection, events } = await blocked();
    expect(connection.transport).toBe("long-poll");
    expect(events).toEqual(["connecting", "connecting", "welcome", "connected"]);
  });

  it("is not interrupted by the search for a WebSocket, however often that fails", async () => {
    const { platform, connection, events, pass, openSockets } = await blocked();
    const changes = () => events.filter((event) => event !== "heartbeat");
    const before = changes();
    for (const n of [1, 2, 3]) {
      // The first search is after 15 s, and each one is rarer.
      await pass(15_000 * 2 ** (n - 1));
      expect(platform.sockets).toHaveLength(1 + n);
      expect(openSockets()).toEqual([platform.socket]);
      if (n % 2 === 0) platform.socket.cut(1006);
      else await pass(4_000);
      expect(openSockets()).toEqual([]);
    }
    expect(changes()).toEqual(before);
    expect([connection.isConnected, connection.transport]).toEqual([true, "long-poll"]);
  });

  it("returns to a WebSocket as soon as one opens", async () => {
    const { platform, connection, events, pass, welcome } = await blocked();
    await pass(15_000);
    const [, probe] = platform.sockets;
    probe?.open();
    expect(connection.transport).toBe("websocket");
    expect(probe?.isClosed).toBe(true);
    welcome();
    expect(events.slice(-3)).toEqual(["connecting", "welcome", "connected"]);
  });

  it("that was closed searches no longer", async () => {
    const { platform, connection, pass } = await blocked();
    connection.close();
    await pass(600_000);
    expect(platform.sockets).toHaveLength(1);
  });
});
