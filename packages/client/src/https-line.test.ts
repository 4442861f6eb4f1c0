import { expect, it } from "vitest";
import type { HttpRequest } from "./platform.ts";
import { RobotClient } from "./robot-client.ts";
import { FakePlatform } from "./testing/fake-platform.ts";
import { ADDRESS } from "./testing/messages.ts";

const turn = (): Promise<void> => new Promise((resolve) => setImmediate(resolve));

interface Sent {
  first: number;
  messages: { type: string; command?: { age?: number } }[];
}

/** A net that lets no WebSocket through, in front of a relay that says welcome. */
class OnlyHttps extends FakePlatform {
  /** posts of messages, as they were made */
  readonly posts: Sent[] = [];
  /** how many of the next posts fail */
  toFail = 0;
  #isWelcomed = false;

  readonly ask = (request: HttpRequest) => ({
    answer: this.#answer(request),
    cancel: () => undefined,
  });

  async #answer({ method, url, body }: HttpRequest) {
    if (url.endsWith("/line"))
      return { status: 201, body: '{"line":"lin_AAAAAAAAAAAAAAAAAAAAAA"}' };
    if (method === "POST") {
      const sent = JSON.parse(body ?? "") as Sent;
      this.posts.push(sent);
      if (this.toFail-- > 0) throw new Error("cut");
      return { status: 200, body: `{"taken":${sent.first + sent.messages.length - 1}}` };
    }
    if (this.#isWelcomed) return new Promise<never>(() => undefined);
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
      const body = '{"type":"/problems/sent-away"}';
      return { answer: Promise.resolve({ status: 403, body }), cancel: () => undefined };
    },
  });
  const connecting = RobotClient.connect(ADDRESS, { platform: refusing });
  const refused = connecting.catch((error: unknown) => error);
  platform.socket.cut(1006);
  await platform.passInTurns(500);
  expect(await refused).toMatchObject({ code: "sent-away" });
  await platform.passInTurns(500);
  expect(asked).toBe(1);
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
  expect(first).not.toHaveProperty("age");
  // After pauses of half of 250 and of 500 ms, by this platform's luck.
  expect(second?.age).toBeGreaterThanOrEqual(125);
  expect(third?.age).toBeGreaterThanOrEqual(375);
  script.close();
});
