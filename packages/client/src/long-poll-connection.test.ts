import { expect, it, onTestFinished } from "vitest";
import { HttpsLine } from "./long-poll-connection.ts";
import type { HttpRequest } from "./platform.ts";
import { RobotClient } from "./robot-client.ts";
import { FakePlatform } from "./testing/fake-platform.ts";
import { ADDRESS } from "./testing/messages.ts";
import { WatchLink } from "./watch-link.ts";

const turn = (): Promise<void> => new Promise((resolve) => setImmediate(resolve));

interface Sent {
  first: number;
  messages: { type: string; command?: { age?: number } }[];
}

type Fetched = () => { status: number; body: string };

/** A net that lets no WebSocket through, in front of a relay that says welcome. */
class OnlyHttps extends FakePlatform {
  /** posts of messages, as they were made */
  readonly posts: Sent[] = [];
  readonly postedAt: number[] = [];
  /** how many of the next posts fail */
  toFail = 0;
  /** when messages were asked for */
  readonly fetchedAt: number[] = [];
  /** what becomes of a request for messages after the welcome; null: it waits */
  fetched: Fetched | null = null;
  /** Cuts the request that waits for messages. */
  cutFetch: () => void = () => undefined;
  #isWelcomed = false;

  readonly ask = (request: HttpRequest) => ({
    answer: this.#answer(request),
    cancel: () => undefined,
  });

  async #answer({ method, url, body }: HttpRequest) {
    if (url.endsWith("/long-poll"))
      return { status: 201, body: '{"line":"con_AAAAAAAAAAAAAAAAAAAAAA"}' };
    if (method === "POST") {
      const sent = JSON.parse(body ?? "") as Sent;
      this.posts.push(sent);
      this.postedAt.push(this.clock.now());
      if (this.toFail-- > 0) throw new Error("cut");
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

it("a script that was sent away is told so by HTTPS as well, and does not come again", async () => {
  const platform = new OnlyHttps();
  let asked = 0;
  const refusing = Object.assign(platform, {
    ask: () => {
      asked += 1;
      const body = '{"type":"/problems/blocked"}';
      return { answer: Promise.resolve({ status: 403, body }), cancel: () => undefined };
    },
  });
  const connecting = RobotClient.connect(ADDRESS, { platform: refusing });
  const refused = connecting.catch((error: unknown) => error);
  platform.socket.cut(1006);
  await platform.passInTurns(500);
  expect(await refused).toMatchObject({ code: "blocked" });
  await platform.passInTurns(500);
  expect(asked).toBe(1);
});

const cut: Fetched = () => {
  throw new Error("cut");
};
const busy: Fetched = () => ({ status: 503, body: "" });

/** A line that was open, and whose request for messages has just been cut. */
async function cutLine(fetched = cut, luck = 0.999) {
  const platform = new OnlyHttps();
  const url = "https://robots.example.org/api/v1/robots/k3J9x2aB/long-poll";
  const line = new HttpsLine(url, platform, {
    opened: () => line.send('{"type":"hello"}'),
    received: () => undefined,
    closed: () => undefined,
  });
  onTestFinished(() => line.close());
  await platform.passInTurns(100);
  Object.assign(platform, { fetched, luck });
  platform.fetchedAt.length = 0;
  platform.cutFetch();
  await turn();
  return { platform, line };
}

/** ms until messages are asked for, once a net is back that was away for so long. */
async function resumedMs(awayMs: number, luckOf: (tries: number) => number): Promise<number> {
  const { platform } = await cutLine(cut, luckOf(0));
  const tries = (): number => platform.fetchedAt.length;
  for (let ms = 0; ms < awayMs; ms += 10) {
    platform.luck = luckOf(tries() + 1);
    await platform.passInTurns(10);
  }
  const before = tries();
  const back = platform.clock.now();
  platform.fetched = null;
  while (tries() === before && platform.clock.now() < 20_000) await platform.passInTurns(10);
  return (platform.fetchedAt.at(-1) ?? Infinity) - back;
}

it.each([1, 2, 3, 4, 5, 6])(
  "messages are asked for within twice the time that the net was away, after %i short pauses and a long one",
  async (short) => {
    const luckOf = (n: number): number => (n < short ? 0.1 : 0.999);
    expect(await resumedMs(1_000, luckOf)).toBeLessThanOrEqual(2_000);
  },
);

it("messages are asked for soon after a post has shown that the net is back", async () => {
  const { platform, line } = await cutLine();
  await platform.passInTurns(1_000);
  platform.fetched = null;
  const before = platform.fetchedAt.length;
  line.send("{}");
  await platform.passInTurns(300);
  expect(platform.posts).toHaveLength(1);
  expect(platform.fetchedAt).toHaveLength(before + 1);
});

it("a post is made again soon after messages that came have shown that the net is back", async () => {
  const { platform, line } = await cutLine();
  platform.toFail = Infinity;
  line.send("{}");
  await platform.passInTurns(1_500);
  platform.toFail = 0;
  const before = platform.posts.length;
  platform.fetched = () => {
    platform.fetched = null;
    return { status: 200, body: '{"first":2,"messages":[],"closed":null}' };
  };
  line.hurry();
  await platform.passInTurns(500);
  expect(platform.posts).toHaveLength(before + 1);
});

it.each([
  { name: "a net that cuts what asks for messages", fetched: cut, atMost: 9 },
  { name: "a service that has no time for them", fetched: busy, atMost: 4 },
])("$name is not asked faster because it takes posts", async ({ fetched, atMost }) => {
  const { platform, line } = await cutLine(fetched);
  for (let n = 0; n < 20; n++) {
    line.send("{}");
    await platform.passInTurns(100);
  }
  expect(platform.posts.length).toBeGreaterThan(10);
  expect(platform.fetchedAt.length).toBeLessThanOrEqual(atMost);
});

it("a line that is to be opened before its pause is over asks for messages soon", async () => {
  const platform = new OnlyHttps();
  const link = new WatchLink({
    origin: "https://robots.example.org",
    id: "k3J9x2aB",
    key: "wch_0123456789abcdefghijkl",
    onSnapshot: () => undefined,
    onMaze: () => undefined,
    onStatus: () => undefined,
    platform,
  });
  onTestFinished(() => link.close());
  platform.socket.cut(1006);
  await platform.passInTurns(100);
  platform.luck = 0.999;
  platform.fetched = cut;
  platform.cutFetch();
  await platform.passInTurns(1_000);
  platform.fetched = null;
  const before = platform.fetchedAt.length;
  link.open();
  await platform.passInTurns(300);
  expect(platform.fetchedAt).toHaveLength(before + 1);
});

it("a command that is posted again by HTTPS tells how old it is by then", async () => {
  const platform = new OnlyHttps();
  const connecting = RobotClient.connect(ADDRESS, { platform });
  platform.socket.cut(1006);
  await platform.passInTurns(100);
  const script = await connecting;
  platform.toFail = 2;
  script.left90().catch(() => undefined);
  await platform.passInTurns(1_000);
  const [first, second, third] = platform.posts.map(({ messages }) => messages[0]?.command);
  // The smallest round trip, which is in the age of each.
  const { age: way = 0 } = first ?? {};
  expect(way).toBeLessThan(100);
  const [begun = NaN, again = NaN, last = NaN] = platform.postedAt;
  expect([second?.age, third?.age]).toEqual([way + again - begun, way + last - begun]);
  // After two pauses of half of 250 ms, by this platform's luck.
  expect(last - begun).toBeGreaterThanOrEqual(250);
  script.close();
});
