import { describe, expect, it } from "vitest";
import { createChallengeStore, noChallenge, type TaskPlace } from "../challenge/challenge-store.ts";
import { threeTasks } from "../challenge/testing/three-tasks.ts";
import { LessonAddress } from "./lesson-address.ts";

interface Entry {
  address: string;
  state: unknown;
}

/** A browser with a history. Going back or forward calls the listener. */
function openBrowser(hash = "") {
  const location = { pathname: "/", search: "?lang=de", hash };
  const entries: Entry[] = [{ address: `/?lang=de${hash}`, state: null }];
  let at = 0;
  let moved = () => undefined as void;
  const show = (next: number) => {
    at = next;
    const address = entries[at]?.address ?? "";
    location.hash = address.includes("#") ? address.slice(address.indexOf("#")) : "";
  };
  const history = {
    get state() {
      return entries[at]?.state;
    },
    pushState: (state: unknown, _: string, address?: string | URL | null) => {
      entries.splice(at + 1, Infinity, { address: String(address), state });
      show(at + 1);
    },
    replaceState: (state: unknown, _: string, address?: string | URL | null) => {
      entries.splice(at, 1, { address: String(address), state });
      show(at);
    },
  };
  const challenge = createChallengeStore();
  let homes = 0;
  const stored = new Set(["a"]);
  const showTask = ({ lesson, index }: TaskPlace) =>
    challenge.setState({ ...noChallenge, lesson: threeTasks, lessonId: lesson, index });
  const address = new LessonAddress(
    challenge,
    { location, history, onMove: (listener) => (moved = listener) },
    {
      goHome: () => {
        homes++;
        challenge.setState(noChallenge);
      },
      openTaskAt: (place) => {
        if (!stored.has(place.lesson)) return false;
        showTask(place);
        return true;
      },
    },
  );
  return {
    get entries() {
      return entries.map((entry) => entry.address);
    },
    homes: () => homes,
    shown: () => challenge.getState().index,
    deleteLesson: () => stored.clear(),
    open: async (mission: string) => {
      address.opening();
      challenge.setState(noChallenge);
      challenge.setState({ mission });
      await Promise.resolve();
    },
    openTask: async (index: number) => {
      address.opening();
      showTask({ lesson: "a", index });
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
    /** Types another fragment. */
    move: async (to: string) => {
      history.pushState(null, "", `/?lang=de${to}`);
      moved();
      await Promise.resolve();
    },
    go: async (by: -1 | 1) => {
      show(at + by);
      moved();
      await Promise.resolve();
    },
  };
}

describe("the address of a mission", () => {
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
    expect(page.entries.at(-1)).toBe("/?lang=de#1AbC");
    expect(page.homes()).toBe(0);
  });

  it("goes home by the browser's Back, without a new entry", async () => {
    const page = openBrowser();
    await page.open("one-line");
    await page.go(-1);
    expect(page.homes()).toBe(1);
    expect(page.entries).toHaveLength(2);
    await page.move("");
    expect(page.homes()).toBe(1);
  });
});

describe("a task of a lesson in the history", () => {
  it("is an entry of its own, so that Back leads to the task before", async () => {
    const page = openBrowser();
    await page.openTask(0);
    await page.openTask(2);
    expect(page.entries).toEqual(["/?lang=de", "/?lang=de", "/?lang=de"]);
    await page.go(-1);
    expect(page.shown()).toBe(0);
    await page.go(1);
    expect(page.shown()).toBe(2);
    expect(page.homes()).toBe(0);
    expect(page.entries).toHaveLength(3);
  });

  it("leads home from the first one", async () => {
    const page = openBrowser();
    await page.openTask(0);
    await page.go(-1);
    expect(page.homes()).toBe(1);
  });

  it("joins the entry of its link, which the page removes from the address", async () => {
    const page = openBrowser("#1AbC");
    await page.openTask(0);
    expect(page.entries).toEqual(["/?lang=de#1AbC"]);
  });

  it("leads home if this device does not store the lesson any more", async () => {
    const page = openBrowser();
    await page.openTask(0);
    await page.openTask(1);
    page.deleteLesson();
    await page.go(-1);
    expect(page.homes()).toBe(1);
  });
});
