import { expect, it } from "vitest";
import { MemoryStorage } from "../storage/testing/memory-storage.ts";
import { MAX_NOTE, OwnClasses } from "./own-classes.ts";

const id = "A".repeat(22);
const room = { id, key: "tea_B", screenKey: null, label: "", startedAt: 0, notes: {} };

function newDevice() {
  const storage = new MemoryStorage();
  const classes = new OwnClasses(storage, () => 0);
  classes.store(room);
  return { storage, classes };
}

it("a note stays when the teacher renames the class, and an empty one is deleted", () => {
  const { classes } = newDevice();
  classes.setNote(id, 7, "Juniper is Ada");
  classes.setNote(id, 8, "x".repeat(MAX_NOTE + 1));
  classes.change(id, { label: "8B" });
  const notes = { 7: "Juniper is Ada", 8: "x".repeat(MAX_NOTE) };
  expect(classes.read(id)).toEqual({ ...room, label: "8B", notes });
  classes.setNote(id, 8, "");
  expect(classes.read(id)?.notes).toEqual({ 7: "Juniper is Ada" });
});

it("nothing of a class is left after its end, also if the teacher types then", () => {
  const { storage, classes } = newDevice();
  classes.setNote(id, 7, "Juniper is Ada");
  classes.remove(id);
  classes.setNote(id, 7, "Juniper is Bo");
  classes.change(id, { label: "8B" });
  expect(classes.read(id)).toBeNull();
  expect(storage.length).toBe(0);
});

it.each([{ notes: 5 }, { notes: null }, { notes: { 7: 5 } }, {}])(
  "an entry without readable notes has none: %o",
  (change) => {
    const { storage, classes } = newDevice();
    storage.setItem(`corridor.classroom.${id}`, JSON.stringify({ key: "tea_B", ...change }));
    expect(classes.read(id)?.notes).toEqual({});
  },
);
