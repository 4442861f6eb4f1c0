import { expect, it } from "vitest";
import { startLater } from "./start-later.ts";

/** Something that loads when the test lets it. */
function start() {
  const loaded = Promise.withResolvers<void>();
  const story: string[] = [];
  const stop = startLater(async () => {
    await loaded.promise;
    story.push("started");
    return () => story.push("ended");
  });
  const settle = () => new Promise((resolve) => setTimeout(resolve, 0));
  return { story, load: loaded.resolve, stop, settle };
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
