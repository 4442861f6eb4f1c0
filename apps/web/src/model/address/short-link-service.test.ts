import { mazePresets } from "@corridor/maze";
import { describe, expect, it } from "vitest";
import { MemoryStorage } from "../storage/testing/memory-storage.ts";
import { ShortLinkService, type Ask } from "./short-link-service.ts";

const maze = mazePresets[0]?.maze;
if (maze === undefined) throw new Error("a preset is gone");

/** A service that returns the same link with a new key each time, and records its requests. */
function fakeService() {
  const asked: string[] = [];
  let keys = 0;
  const ask: Ask = (url, { method = "GET", headers } = {}) => {
    const key = new Headers(headers).get("authorization") ?? "";
    asked.push(`${method} ${url} ${key}`.trim());
    if (method === "DELETE") return Promise.resolve(new Response(null, { status: 204 }));
    const id = "AAAAAAAAAAAA";
    const link = { id, address: `https://host/m/${id}`, deleteKey: `del_${++keys}` };
    return Promise.resolve(Response.json(link, { status: 201 }));
  };
  return { asked, ask };
}

describe("short links of this device", () => {
  it("are deleted with every key that the device was given, after a reload too", async () => {
    const device = new MemoryStorage();
    const { asked, ask } = fakeService();
    await new ShortLinkService(ask, device).make(maze);
    const service = new ShortLinkService(ask, device);
    expect(await service.make(maze)).toMatchObject({ address: "https://host/m/AAAAAAAAAAAA" });
    expect(await service.delete("AAAAAAAAAAAA")).toBe(true);
    expect(asked.slice(2)).toEqual([
      "DELETE /api/v1/mazes/AAAAAAAAAAAA Bearer del_1",
      "DELETE /api/v1/mazes/AAAAAAAAAAAA Bearer del_2",
    ]);
    expect(await new ShortLinkService(ask, device).delete("AAAAAAAAAAAA")).toBe(true);
    expect(asked).toHaveLength(4);
  });

  it("are created even if the device is full or its data is unreadable", async () => {
    const device = new MemoryStorage();
    device.setItem("corridor.shortLinks", '{"not":"a list"}');
    device.isFull = true;
    const { asked, ask } = fakeService();
    const service = new ShortLinkService(ask, device);
    expect(await service.make(maze)).not.toBeNull();
    expect(await service.delete("AAAAAAAAAAAA")).toBe(true);
    expect(asked).toHaveLength(2);
  });

  it.each([
    { what: "nothing answers", answer: () => Promise.reject(new TypeError("offline")) },
    { what: "files alone answer", answer: () => Promise.resolve(new Response("<html>")) },
    { what: "it is busy", answer: () => Promise.resolve(new Response("", { status: 429 })) },
  ])("are not available if $what", async ({ answer }) => {
    const service = new ShortLinkService(answer, new MemoryStorage());
    expect(await service.answers()).toBe(false);
    expect(await service.make(maze)).toBeNull();
  });
});
