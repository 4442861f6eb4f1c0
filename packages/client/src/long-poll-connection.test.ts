import { expect, it, onTestFinished } from "vitest";
import { LongPollConnection } from "./long-poll-connection.ts";
import type { HttpRequest } from "./platform.ts";
import { RobotClient } from "./robot-client.ts";
import { FakePlatform } from "./testing/fake-platform.ts";
import { ADDRESS } from "./testing/messages.ts";
import { WatchConnection } from "./watch-connection.ts";

const turn = (): Promise<void> => new Promise((resolve) => setImmediate(resolve));

interface Sent {
  first: number;
  messages: { type: string; command?: { age?: number } }[];
}

type Fetched = () => { status: number; body: string; retryAfter?: string };

/** A network that blocks WebSockets, in front of a relay that sends its welcome. */
class LongPollNetwork extends FakePlatform {
  /** posted messages, by attempt */
  readonly posts: Sent[] = [];
  readonly postedAt: number[] = [];
  /** number of the next posts that fail */
  failures = 0;
  /** times of fetches */
  readonly fetchedAt: number[] = [];
  /** the response to a fetch after the welcome; null: it waits */
  fetched: Fetched | null = null;
  /** Aborts the waiting fetch. */
  cutFetch: () => void = () => undefined;
  #isWelcomed = false;

  readonly request = (request: HttpRequest) => ({
    response: this.#respond(request),
    cancel: () => undefined,
  });

  async #respond({ method, url, body }: HttpRequest) {
    if (url.endsWith("/long-poll"))
      return { status: 201, body: '{"key":"con_AAAAAAAAAAAAAAAAAAAAAA"}' };
    if (method === "POST") {
      const sent = JSON.parse(body ?? "") as Sent;
      this.posts.push(sent);
      this.postedAt.push(this.clock.now());
      if (this.failures-- > 0) throw new Error("cut");
      return { status: 200, body: `{"taken":${sent.first + sent.messages.length - 1}}` };
    }
    this.fetchedAt.push(this.clock.now());
    if (this.#isWelcomed && this.fetched !== null) return this.fetched();
    if (this.#isWelcomed)
      return new Promise<never>((_resolve, reject) => {
        this.cutFetch = () => reject(new Error("cut"));
      });
    this.#isWelcomed = true;
    const welcome = { type: "welcome", version: 1, stream: "k3J9x2aB", n: 0, snapshot: null };
    return { status: 200, body: JSON.stringify({ first: 1, messages: [welcome], closed: null }) };
  }

  async passInTurns(ms: number): Promise<void> {
    for (let n = 0; n < ms; n += 10) {
      this.pass(10);
      await turn();
    }
  }
}

it("a blocked script receives an error by long polling as well, and does not reconnect", async () => {
  const platform = new LongPollNetwork();
  let requests = 0;
  const refusing = Object.assign(platform, {
    request: () => {
      requests += 1;
      const body = '{"type":"/problems/blocked"}';
      return { response: Promise.resolve({ status: 403, body }), cancel: () => undefined };
    },
  });
  const connecting = RobotClient.connect(ADDRESS, { platform: refusing });
  const refused = connecting.catch((error: unknown) => error);
  platform.socket.cut(1006);
  await platform.passInTurns(500);
  expect(await refused).toMatchObject({ code: "blocked" });
  await platform.passInTurns(500);
  expect(requests).toBe(1);
});

const cut: Fetched = () => {
  throw new Error("cut");
};
const busy: Fetched = () => ({ status: 503, body: "" });

/** An open connection whose fetch has just been aborted. */
async function interruptedConnection(fetched = cut, luck = 0.999) {
  const platform = new LongPollNetwork();
  const url = "https://robots.example.org/api/v1/robots/k3J9x2aB/long-poll";
  const connection = new LongPollConnection(url, platform, {
    opened: () => connection.send('{"type":"hello"}'),
    received: () => undefined,
    closed: () => undefined,
  });
  onTestFinished(() => connection.close());
  await platform.passInTurns(100);
  Object.assign(platform, { fetched, luck });
  platform.fetchedAt.length = 0;
  platform.cutFetch();
  await turn();
  return { platform, connection };
}

/** ms from the end of an outage to the next fetch. */
async function resumedMs(outageMs: number, luckOf: (attempts: number) => number): Promise<number> {
  const { platform } = await interruptedConnection(cut, luckOf(0));
  const attempts = (): number => platform.fetchedAt.length;
  for (let ms = 0; ms < outageMs; ms += 10) {
    platform.luck = luckOf(attempts() + 1);
    await platform.passInTurns(10);
  }
  const before = attempts();
  const back = platform.clock.now();
  platform.fetched = null;
  while (attempts() === before && platform.clock.now() < 20_000) await platform.passInTurns(10);
  return (platform.fetchedAt.at(-1) ?? Infinity) - back;
}

it.each([1, 2, 3, 4, 5, 6])(
  "fetches resume within twice the length of an outage, after %i short delays and a long one",
  async (short) => {
    const luckOf = (n: number): number => (n < short ? 0.1 : 0.999);
    expect(await resumedMs(1_000, luckOf)).toBeLessThanOrEqual(2_000);
  },
);

it("fetches wait for the seconds of Retry-After, and resume soon after them", async () => {
  const overloaded = () => ({ status: 503, body: "", retryAfter: "3" });
  const { platform } = await interruptedConnection(overloaded);
  await platform.passInTurns(300);
  const before = platform.fetchedAt.length;
  await platform.passInTurns(2_900);
  expect(platform.fetchedAt).toHaveLength(before);
  await platform.passInTurns(600);
  expect(platform.fetchedAt).toHaveLength(before + 1);
});

it("fetches resume soon after a post has succeeded", async () => {
  const { platform, connection } = await interruptedConnection();
  await platform.passInTurns(1_000);
  platform.fetched = null;
  const before = platform.fetchedAt.length;
  connection.send("{}");
  await platform.passInTurns(300);
  expect(platform.posts).toHaveLength(1);
  expect(platform.fetchedAt).toHaveLength(before + 1);
});

it("posts resume soon after a fetch has succeeded", async () => {
  const { platform, connection } = await interruptedConnection();
  platform.failures = Infinity;
  connection.send("{}");
  await platform.passInTurns(1_500);
  platform.failures = 0;
  const before = platform.posts.length;
  platform.fetched = () => {
    platform.fetched = null;
    return { status: 200, body: '{"first":2,"messages":[],"closed":null}' };
  };
  connection.hurry();
  await platform.passInTurns(500);
  expect(platform.posts).toHaveLength(before + 1);
});

it.each([
  { name: "a network that aborts fetches", fetched: cut, atMost: 9 },
  { name: "a busy service", fetched: busy, atMost: 4 },
])("$name receives no more fetches because posts succeed", async ({ fetched, atMost }) => {
  const { platform, connection } = await interruptedConnection(fetched);
  for (let n = 0; n < 20; n++) {
    connection.send("{}");
    await platform.passInTurns(100);
  }
  expect(platform.posts.length).toBeGreaterThan(10);
  expect(platform.fetchedAt.length).toBeLessThanOrEqual(atMost);
});

it("a connection that is opened again during a delay fetches soon", async () => {
  const platform = new LongPollNetwork();
  const connection = new WatchConnection({
    origin: "https://robots.example.org",
    id: "k3J9x2aB",
    key: "wch_0123456789abcdefghijkl",
    onSnapshot: () => undefined,
    onMaze: () => undefined,
    onStatus: () => undefined,
    platform,
  });
  onTestFinished(() => connection.close());
  platform.socket.cut(1006);
  await platform.passInTurns(100);
  platform.luck = 0.999;
  platform.fetched = cut;
  platform.cutFetch();
  await platform.passInTurns(1_000);
  platform.fetched = null;
  const before = platform.fetchedAt.length;
  connection.open();
  await platform.passInTurns(300);
  expect(platform.fetchedAt).toHaveLength(before + 1);
});

it("a command that is posted again contains its current age", async () => {
  const platform = new LongPollNetwork();
  const connecting = RobotClient.connect(ADDRESS, { platform });
  platform.socket.cut(1006);
  await platform.passInTurns(100);
  const script = await connecting;
  platform.failures = 2;
  script.left90().catch(() => undefined);
  await platform.passInTurns(1_000);
  const [first, second, third] = platform.posts.map(({ messages }) => messages[0]?.command);
  // Each age includes the shortest round trip.
  const { age: roundTrip = 0 } = first ?? {};
  expect(roundTrip).toBeLessThan(100);
  const [start = NaN, again = NaN, last = NaN] = platform.postedAt;
  expect([second?.age, third?.age]).toEqual([roundTrip + again - start, roundTrip + last - start]);
  // After two delays of half of 250 ms.
  expect(last - start).toBeGreaterThanOrEqual(250);
  script.close();
});
