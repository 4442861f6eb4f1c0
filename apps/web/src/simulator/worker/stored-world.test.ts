/** On a device without IndexedDB, as Node.js is; restored-world.spec.ts tests the others. */
import { expect, it } from "vitest";
import { firstMaze, firstProgram } from "../protocol/first-project.ts";
import { RunLoop } from "./run-loop.ts";
import { StoredWorld } from "./stored-world.ts";

function open() {
  const loop = new RunLoop(firstMaze, firstProgram, () => 0);
  const keys: (string | null)[] = [];
  const world = new StoredWorld({
    run: () => loop,
    journal: () => null,
    onClaimed: () => undefined,
    sendKey: (key) => keys.push(key),
    now: () => 0,
  });
  return { loop, keys, world };
}

it("delays an ending until the tab knows that a reload restores nothing", async () => {
  const { keys, world } = open();
  let isSaved = false;
  const saving = world.save().then(() => (isSaved = true));
  await expect.poll(() => keys).toEqual([null]);
  expect(isSaved).toBe(false);
  world.keyNoted(true);
  await saving;
});

it("stores nothing before the robot is driven or its documents are edited", async () => {
  const { loop, keys, world } = open();
  // Otherwise nothing would be stored because the repository loads slowly.
  await import("./open-world-repository.ts");
  const update = async (): Promise<void> => {
    world.update(true);
    await new Promise((resolve) => setTimeout(resolve, 0));
  };
  for (let time = 0; time < 10; time++) await update();
  expect(keys).toEqual([]);
  loop.setDriver("me");
  await expect
    .poll(async () => {
      await update();
      return keys;
    })
    .toEqual([null]);
});
