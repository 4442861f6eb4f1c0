import { expect, it } from "vitest";
import { FakeClock } from "../platform/testing/fake-clock.ts";
import { CreditedFeed } from "./credited-feed.ts";

function feedOf() {
  const clock = new FakeClock();
  const sent: string[] = [];
  const pace = { ms: 500 };
  const feed = new CreditedFeed<string>({
    clock,
    intervalMs: () => pace.ms,
    merge: (waiting, newer) => waiting + newer,
    send: (seq, content) => sent.push(`${seq} ${content}`),
  });
  return { clock, sent, pace, feed };
}

it("sends the first content at once, and merges what follows within the interval", async () => {
  const { clock, sent, feed } = feedOf();
  for (const content of ["a", "b", "c"]) feed.offer(content);
  expect(sent).toEqual(["1 a"]);
  await clock.pass(500);
  expect(sent).toEqual(["1 a", "2 bc"]);
});

it("sends nothing to a reader that has not acknowledged two messages", async () => {
  const { clock, sent, feed } = feedOf();
  for (const content of ["a", "b", "c", "d"]) {
    feed.offer(content);
    await clock.pass(500);
  }
  expect(sent).toEqual(["1 a", "2 b"]);
  feed.seen(1);
  expect(sent).toEqual(["1 a", "2 b", "3 cd"]);
});

it("gives no credit for messages that it has not sent", async () => {
  const { clock, sent, feed } = feedOf();
  feed.seen(99);
  for (const content of ["a", "b", "c"]) {
    feed.offer(content);
    await clock.pass(500);
  }
  expect(sent).toEqual(["1 a", "2 b"]);
});

it("sends earlier when the interval becomes shorter", async () => {
  const { clock, sent, pace, feed } = feedOf();
  for (const content of ["a", "b"]) feed.offer(content);
  await clock.pass(250);
  pace.ms = 200;
  feed.intervalChanged();
  expect(sent).toEqual(["1 a", "2 b"]);
});

it("sends nothing after its end", async () => {
  const { clock, sent, feed } = feedOf();
  for (const content of ["a", "b"]) feed.offer(content);
  feed.close();
  await clock.pass(500);
  feed.offer("c");
  expect(sent).toEqual(["1 a"]);
});
