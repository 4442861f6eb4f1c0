/** Requirements for every store: the maze of a robot. */
import { describe, expect, it } from "vitest";
import { ID, type OpenStore, robotIn } from "./robot-in-store.ts";

export function mazeCases(name: string, open: () => Promise<OpenStore>): void {
  const withRobot = () => robotIn(open);

  describe(`${name}: the maze of a robot`, () => {
    it("is the last one stored, also after a restart", async () => {
      const { store, reopen } = await withRobot();
      expect(await store.maze(ID)).toBeNull();
      expect(await store.storeMaze(ID, '{"name":"first"}')).toBe(true);
      expect(await store.storeMaze(ID, '{"name":"\u8ff7\u8def \u{1f9ed}"}')).toBe(true);
      expect(await (await reopen()).maze(ID)).toBe('{"name":"\u8ff7\u8def \u{1f9ed}"}');
    });

    it("is stored for known robots only", async () => {
      const { store } = await withRobot();
      expect(await store.storeMaze("B".repeat(22), "{}")).toBe(false);
      expect(await store.maze("B".repeat(22))).toBeNull();
      expect(await store.find("B".repeat(22))).toBeNull();
    });

    it("is deleted from the disk with the robot", async () => {
      const { store, holds } = await withRobot();
      const text = "a-maze-to-be-deleted ".repeat(2_000);
      await store.storeMaze(ID, text);
      await store.storeMaze(ID, `other-${text}`);
      expect(await holds("a-maze-to-be-deleted")).toBe(true);
      await store.remove(ID);
      expect(await store.maze(ID)).toBeNull();
      expect(await holds("a-maze-to-be-deleted")).toBe(false);
    });

    it("is deleted with an expired robot", async () => {
      const { store, holds } = await withRobot();
      await store.storeMaze(ID, "a-maze-to-be-deleted");
      await store.removeExpired({ lastUsedAt: 9_000, createdAt: 9_000 });
      expect(await holds("a-maze-to-be-deleted")).toBe(false);
    });
  });
}
