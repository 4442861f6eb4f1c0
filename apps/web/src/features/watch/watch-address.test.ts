import { describe, expect, it } from "vitest";
import { MemoryStorage } from "../../model/storage/testing/memory-storage.ts";
import { takeVisit } from "./watch-address.ts";

const ID = "A-_4567890123456789012";
const KEY = `wch_${"B".repeat(22)}`;

function opening(pathname: string, hash: string, tab = new MemoryStorage(), search = "") {
  const addresses: string[] = [];
  const replaceAddress = (address: string): void => void addresses.push(address);
  return {
    visit: takeVisit({ location: { pathname, search, hash }, tab, replaceAddress }),
    addresses,
    tab,
  };
}

describe("a robot's address in a browser", () => {
  it("with a watch key shows the robot and hides the key", () => {
    const { visit, addresses } = opening(`/r/${ID}`, `#${KEY}`, undefined, "?lang=de");
    expect(visit).toEqual({ kind: "watch", robot: { id: ID, key: KEY } });
    expect(addresses).toEqual([`/r/${ID}?lang=de`]);
  });

  it("goes on after a reload, in this tab and for this robot alone", () => {
    const { tab } = opening(`/r/${ID}`, `#${KEY}`);
    expect(opening(`/r/${ID}`, "", tab).visit).toEqual({
      kind: "watch",
      robot: { id: ID, key: KEY },
    });
    expect(opening(`/r/${"C".repeat(22)}`, "", tab).visit).toEqual({ kind: "broken" });
    expect(opening(`/r/${ID}`, "").visit).toEqual({ kind: "broken" });
  });

  it("with a key for scripts opens nothing, hides the key and does not store it", () => {
    const { visit, addresses, tab } = opening(`/r/${ID}`, `#drv_${"B".repeat(22)}`);
    expect(visit).toEqual({ kind: "script" });
    expect(addresses).toEqual([`/r/${ID}`]);
    expect(opening(`/r/${ID}`, "", tab).visit).toEqual({ kind: "broken" });
  });

  it.each([
    { name: "a key that is cut off", path: `/r/${ID}`, hash: "#wch_BBBB" },
    { name: "a key with more behind it", path: `/r/${ID}`, hash: `#${KEY}BBBB` },
    { name: "an owner's key", path: `/r/${ID}`, hash: `#own_${"B".repeat(22)}` },
    { name: "an id that is cut off", path: "/r/AAAA", hash: `#${KEY}` },
    { name: "no id", path: "/r/", hash: `#${KEY}` },
    { name: "a script in it", path: `/r/${ID}`, hash: "#<script>alert(1)</script>" },
  ])("is not whole: $name", ({ path, hash }) => {
    const { visit, addresses } = opening(path, hash);
    expect(visit).toEqual({ kind: "broken" });
    expect(addresses).toEqual([path]);
  });
});
