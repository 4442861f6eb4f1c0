import { join } from "node:path";
import { pino } from "pino";
import { expect, it, onTestFinished, vi } from "vitest";
import { SqliteDocumentStore } from "../store/sqlite/sqlite-document-store.ts";
import { FakeClock, settled } from "../platform/testing/fake-clock.ts";
import { maze, program } from "../platform/testing/sample-documents.ts";
import { testFolder } from "../testing/test-relay.ts";
import { DocumentService } from "./document-service.ts";

const DAY_MS = 24 * 60 * 60 * 1000;

it("deletes a document 180 days after its last use, and no other", async () => {
  const clock = new FakeClock();
  const store = new SqliteDocumentStore(join(testFolder(), "corridor.sqlite"));
  const service = new DocumentService(store, clock, pino({ level: "silent" }));
  onTestFinished(() => service.close());
  const { id: used } = await service.add(maze, "here", "http://host");
  const { id: unused } = await service.add(program, "here", "http://host");
  await clock.pass(170 * DAY_MS);
  expect(JSON.parse(await service.read(used, "there"))).toEqual(maze);
  await clock.pass(11 * DAY_MS);
  await expect(service.read(unused, "there")).rejects.toMatchObject({ kind: "no-document" });
  await clock.pass(1_000);
  expect(JSON.parse(await service.read(used, "there"))).toEqual(maze);
  await clock.pass(179 * DAY_MS);
  expect(JSON.parse(await service.read(used, "there"))).toEqual(maze);
  await clock.pass(181 * DAY_MS);
  await expect(service.read(used, "there")).rejects.toMatchObject({ kind: "no-document" });
});

it("deletes nothing after it is closed, even if it closes during a deletion", async () => {
  const clock = new FakeClock();
  const store = new SqliteDocumentStore(join(testFolder(), "corridor.sqlite"));
  const service = new DocumentService(store, clock, pino({ level: "silent" }));
  const { promise, resolve } = Promise.withResolvers<number>();
  const remove = vi.spyOn(store, "removeUnused").mockReturnValue(promise);
  await clock.pass(0);
  await service.close();
  resolve(0);
  await settled();
  await clock.pass(DAY_MS);
  expect(remove).toHaveBeenCalledTimes(1);
});
