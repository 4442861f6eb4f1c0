import { expect, it } from "vitest";
import { MemoryStorage } from "../storage/testing/memory-storage.ts";
import { hasClassKey, secondDeviceAddress, takeClassVisit } from "./class-address.ts";
import { OwnClasses } from "./own-classes.ts";

const NOW = Date.UTC(2026, 0, 1);
const id = "A".repeat(22);
const teacherKey = `tea_${"B".repeat(22)}`;
const screenKey = `scr_${"C".repeat(22)}`;

function device() {
  const storage = new MemoryStorage();
  const tab = new MemoryStorage();
  const classes = new OwnClasses(storage, () => NOW);
  const addresses: string[] = [];
  const visit = (hash: string, pathname = `/class/${id}`) =>
    takeClassVisit({
      location: { pathname, search: "", hash },
      classes,
      tab,
      replaceAddress: (address) => addresses.push(address),
      now: () => NOW,
    });
  return { classes, addresses, visit };
}

it("the key of a teacher leaves the address, and the device stores it", () => {
  const { visit, addresses, classes } = device();
  const room = { id, key: teacherKey, screenKey: null, label: "", startedAt: NOW, notes: {} };
  expect(visit(`#${teacherKey}`)).toEqual({ kind: "teach", room });
  expect(addresses).toEqual([`/class/${id}`]);
  expect(visit("")).toEqual({ kind: "teach", room });
  classes.remove(id);
  expect(visit("")).toEqual({ kind: "broken" });
});

it("a link does not change the label that the device has", () => {
  const { visit, classes } = device();
  classes.store({ id, key: teacherKey, screenKey, label: "8B", startedAt: NOW, notes: {} });
  expect(visit(`#${teacherKey}`)).toMatchObject({ room: { label: "8B", screenKey } });
});

it("a second device can open the big screen, too", () => {
  const { visit } = device();
  const address = secondDeviceAddress("https://a.example", { id, key: teacherKey, screenKey });
  expect(address).toBe(`https://a.example/class/${id}#${teacherKey}.${screenKey}`);
  const { hash } = new URL(address);
  expect(hasClassKey(hash)).toBe(true);
  expect(visit(hash)).toMatchObject({ room: { key: teacherKey, screenKey } });
  expect(visit("")).toMatchObject({ kind: "teach", room: { key: teacherKey, screenKey } });
});

it("a second device that has only the teacher's key gets the other one later", () => {
  const { visit } = device();
  const known = { id, key: teacherKey, screenKey: null };
  expect(secondDeviceAddress("https://a.example", known)).toMatch(/#tea_[^.]*$/);
  visit(`#${teacherKey}`);
  visit(`#${teacherKey}.${screenKey}`);
  expect(visit("")).toMatchObject({ room: { screenKey } });
});

it("a wrong link does not replace the key that the device has", () => {
  const { visit } = device();
  const wrong = `tea_${"D".repeat(22)}`;
  expect(visit(`#${teacherKey}`)).toMatchObject({ room: { key: teacherKey } });
  expect(visit(`#${wrong}`)).toMatchObject({ room: { key: wrong } });
  expect(visit("")).toMatchObject({ room: { key: teacherKey } });
});

it("the key of a big screen is stored in the tab", () => {
  const { visit, classes } = device();
  expect(visit(`#${screenKey}`)).toEqual({ kind: "show", id, key: screenKey });
  expect(visit("")).toEqual({ kind: "show", id, key: screenKey });
  expect(classes.list()).toEqual([]);
});

it.each([
  { hash: `#stu_${"B".repeat(22)}`, pathname: `/class/${id}` },
  { hash: `#${teacherKey}.${teacherKey}`, pathname: `/class/${id}` },
  { hash: `#${screenKey}.${teacherKey}`, pathname: `/class/${id}` },
  { hash: "#tea_short", pathname: `/class/${id}` },
  { hash: `#${teacherKey}`, pathname: "/class/short" },
])("$hash at $pathname opens nothing", ({ hash, pathname }) => {
  expect(device().visit(hash, pathname)).toEqual({ kind: "broken" });
});

it("the device lists running classes, newest first, and removes those that have ended", () => {
  const { classes } = device();
  const entry = { key: teacherKey, screenKey, label: "8B", notes: {} };
  classes.store({ ...entry, id: "1", startedAt: NOW - 3_600_000 });
  classes.store({ ...entry, id: "2", startedAt: NOW });
  classes.store({ ...entry, id: "3", startedAt: NOW - 13 * 3_600_000 });
  expect(classes.list().map((each) => each.id)).toEqual(["2", "1"]);
  expect(classes.read("3")).toBeNull();
});
