import { describe, expect, it } from "vitest";
import { createChallengeStore, noChallenge } from "../challenge/challenge-store.ts";
import { MissionAddress, missionHash, missionOfHash } from "./mission-address.ts";

/** A browser with a history. Going back or forward calls the listener. */
function openBrowser(hash = "") {
  const location = { pathname: "/", search: "?lang=de", hash };
  const entries = [`/?lang=de${hash}`];
  let moved = () => undefined as void;
  const put = (address: string) => {
    location.hash = address.includes("#") ? address.slice(address.indexOf("#")) : "";
  };
  const history: Pick<History, "pushState" | "replaceState"> = {
    pushState: (_data, _unused, address) => {
      entries.push(String(address));
      put(String(address));
    },
    replaceState: (_data, _unused, address) => {
      entries.splice(-1, 1, String(address));
      put(String(address));
    },
  };
  const challenge = createChallengeStore();
  let homes = 0;
  const address = new MissionAddress(
    challenge,
    { location, history, onMove: (listener) => (moved = listener) },
    () => {
      homes++;
      challenge.setState(noChallenge);
    },
  );
  return {
    entries,
    homes: () => homes,
    open: async (mission: string) => {
      address.opening();
      challenge.setState(noChallenge);
      challenge.setState({ mission });
      await Promise.resolve();
    },
    restore: async (mission: string) => {
      challenge.setState({ mission });
      await Promise.resolve();
    },
    close: async () => {
      challenge.setState(noChallenge);
      await Promise.resolve();
    },
    move: async (to: string) => {
      location.hash = to;
      moved();
      await Promise.resolve();
    },
  };
}

describe("the address of a mission", () => {
  it("is a fragment that names it", () => {
    expect(missionHash("side-opening")).toBe("#mission/side-opening");
    expect(missionOfHash("#mission/side-opening")).toBe("side-opening");
    expect(missionOfHash("#1AbC")).toBeNull();
    expect(missionOfHash("")).toBeNull();
  });

  it("stands in the address bar while the mission is open, one entry each", async () => {
    const page = openBrowser();
    await page.open("one-line");
    await page.open("own-line");
    await page.close();
    expect(page.entries).toEqual([
      "/?lang=de",
      "/?lang=de#mission/one-line",
      "/?lang=de#mission/own-line",
      "/?lang=de",
    ]);
  });

  it("is completed, without an entry, for a mission that a reload brings back", async () => {
    const page = openBrowser();
    await page.restore("one-line");
    expect(page.entries).toEqual(["/?lang=de#mission/one-line"]);
    await page.open("own-line");
    expect(page.entries).toHaveLength(2);
  });

  it("is not replaced while the page opens another mission that it names", async () => {
    const page = openBrowser("#mission/own-line");
    await page.restore("one-line");
    expect(page.entries).toEqual(["/?lang=de#mission/own-line"]);
    await page.open("own-line");
    expect(page.entries).toEqual(["/?lang=de#mission/own-line"]);
  });

  it("leaves a link alone that closes the mission", async () => {
    const page = openBrowser();
    await page.open("one-line");
    await page.move("#1AbC");
    await page.close();
    expect(page.entries).toHaveLength(2);
    expect(page.homes()).toBe(0);
  });

  it("goes home by the browser's Back, without a new entry", async () => {
    const page = openBrowser();
    await page.open("one-line");
    await page.move("");
    expect(page.homes()).toBe(1);
    expect(page.entries).toHaveLength(2);
    await page.move("");
    expect(page.homes()).toBe(1);
  });
});
