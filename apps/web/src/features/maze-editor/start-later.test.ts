import { expect, it } from "vitest";
import { startLater } from "./start-later.ts";

/** Something that loads when the test lets it. */
function start() {
  const loaded = Promise.withResolvers<void>();
  const story: string[] = [];
  const stop = startLater(
    async () => {
      await loaded.promise;
      story.push("started");
      return () => story.push("ended");
    },
    () => story.push("failed"),
  );
  const settle = () => new Promise((resolve) => setTimeout(resolve, 0));
  return { story, load: loaded.resolve, fail: loaded.reject, stop, settle };
}

it("what loads on demand can be ended after it has started", async () => {
  const { story, load, stop, settle } = start();
  load();
  await settle();
  expect(story).toEqual(["started"]);
  stop();
  await settle();
  expect(story).toEqual(["started", "ended"]);
});

it("what loads on demand can be ended before it has started, and ends then", async () => {
  const { story, load, stop, settle } = start();
  stop();
  await settle();
  expect(story).toEqual([]);
  load();
  await settle();
  expect(story).toEqual(["started", "ended"]);
});

it("what does not load, because there is no network, is reported and left out", async () => {
  const { story, fail, stop, settle } = start();
  fail(new TypeError("Failed to fetch dynamically imported module"));
  // A rejection that nothing handles fails the test.
  await settle();
  stop();
  await settle();
  expect(story).toEqual(["failed"]);
});

it("what does not load after it has ended is not reported", async () => {
  const { story, fail, stop, settle } = start();
  stop();
  fail(new TypeError("Failed to fetch dynamically imported module"));
  await settle();
  expect(story).toEqual([]);
});
