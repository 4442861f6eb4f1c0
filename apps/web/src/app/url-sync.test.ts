import type { ChallengeDocument } from "@corridor/challenge";
import { decodeLink, encodeLink, type LinkContent } from "@corridor/link";
import { emptyProgram } from "@corridor/program";
import type { RunDocument } from "@corridor/recording";
import { describe, expect, it, vi } from "vitest";
import { createScreenStore } from "../stores/screen-store.ts";
import { createWorkspaceStore, setMaze, setProgram } from "../stores/workspace-store.ts";
import { en } from "../text/en/index.ts";
import { createI18n } from "../text/i18n.ts";
import { CurrentWork } from "./current-work.ts";
import { programForMaze } from "../features/program/own-program.ts";
import { firstMaze, firstProgram } from "../worker/first-work.ts";
import { readWork } from "./read-work.ts";
import { MemoryStorage } from "./testing/memory-storage.ts";
import type { ShortLinkResult } from "./short-link.ts";
import { followAddress } from "./url-sync.ts";
import { WorksService } from "./works-service.ts";
import { WorkShelf } from "./works.ts";

const sharedMaze = { ...firstMaze, name: "Shared" };
const sharedProgram = { ...firstProgram, name: "Shared rules" };

function linkOf(content: LinkContent): string {
  const result = encodeLink(content);
  if (!result.ok) throw new Error(`no link: ${result.code}`);
  return result.text;
}

const mazeLink = linkOf({ maze: sharedMaze });
const fullLink = linkOf({ maze: sharedMaze, program: sharedProgram });

let lastId = 0;

function openPage(
  device: MemoryStorage,
  tab = new MemoryStorage(),
  loadLinks = () => Promise.resolve({ decodeLink }),
) {
  const shelf = new WorkShelf(device, () => readWork);
  const current = new CurrentWork(
    { shelf, tab, now: () => ++lastId, newId: () => `id-${++lastId}` },
    firstMaze,
    firstProgram,
  );
  const workspace = createWorkspaceStore(current.work.maze, current.work.program);
  const screen = createScreenStore();
  const words = createI18n(en);
  const later = () => undefined;
  const simulator = { send: () => undefined };
  const works = new WorksService({ shelf, current, workspace, screen, simulator, words, later });
  const addresses: string[] = [];
  const emptied: string[] = [];
  const runs: string[] = [];
  const asked: string[] = [];
  const shelved = new Map<string, ShortLinkResult>();
  /** what the address was replaced by before the run was there */
  const runAddresses: string[] = [];
  const challenges: [string, string | null][] = [];
  const missions: string[] = [];
  const refused: string[] = [];
  const go = (pathname: string, hash: string) =>
    followAddress({
      works,
      loadLinks,
      readShortLink: (id) => {
        asked.push(id);
        const result = shelved.get(id);
        return result === undefined
          ? Promise.reject(new Error("offline"))
          : Promise.resolve(result);
      },
      screen,
      words,
      maze: () => workspace.getState().maze,
      programForMaze: () => programForMaze(workspace.getState().program, words),
      location: { pathname, search: "", hash },
      replaceAddress: (address) => addresses.push(address),
      openEmptyMaze: () => emptied.push("empty"),
      openRun: (run) => {
        runs.push(run.name);
        runAddresses.push(...addresses);
        return Promise.resolve(run.ticks === 0 ? [{ path: "", found: "a", expected: "b" }] : []);
      },
      openChallenge: (challenge, program) => {
        challenges.push([challenge.name, program?.name ?? null]);
        return Promise.resolve(challenge.name !== "Offline");
      },
      openMission: (id) => {
        missions.push(id);
        if (id === "offline") return Promise.reject(new Error("offline"));
        return Promise.resolve(id === "side-opening");
      },
      refuseMission: () => refused.push(hash),
    });
  const rename = (name: string) => {
    setMaze(workspace, { ...workspace.getState().maze, name });
    works.autosave.flush();
  };
  const shown = () => workspace.getState().maze.name;
  const message = () => screen.getState().messages[0];
  const names = () =>
    works
      .list()
      .map(({ maze }) => maze.name)
      .toSorted();
  return {
    workspace,
    screen,
    works,
    addresses,
    emptied,
    runs,
    runAddresses,
    asked,
    shelved,
    challenges,
    missions,
    refused,
    go,
    rename,
    shown,
    message,
    names,
    tab,
  };
}

describe("opening a shared link", () => {
  it("shows the maze beside the reader's own work, and leads back", async () => {
    const page = openPage(new MemoryStorage());
    page.rename("Mine");
    await page.go("/", `#${fullLink}`);
    expect(page.shown()).toBe("Shared");
    expect(page.workspace.getState().program.name).toBe("Shared rules");
    expect(page.names()).toEqual(["Mine", "Shared"]);
    expect(page.message()?.text).toBe("You opened a shared maze. Your own work is saved.");
    page.message()?.action?.run();
    expect(page.shown()).toBe("Mine");
    expect(page.screen.getState().messages).toEqual([]);
  });

  it("speaks of no own work to a reader who has none, however many links are opened", async () => {
    const page = openPage(new MemoryStorage());
    await page.go("/", `#${fullLink}`);
    await page.go("/", `#${mazeLink}`);
    const texts = page.screen.getState().messages.map(({ text }) => text);
    expect(new Set(texts)).toEqual(new Set(["You opened a shared maze."]));
    expect(page.message()?.action).toBeUndefined();
  });

  it("counts a shared maze that the reader has changed as own work", async () => {
    const page = openPage(new MemoryStorage());
    await page.go("/", `#${mazeLink}`);
    page.rename("Changed");
    await page.go("/", `#${fullLink}`);
    const message = page.message();
    expect(message?.text).toBe("You opened a shared maze. Your own work is saved.");
    message?.action?.run();
    expect(page.shown()).toBe("Changed");
  });

  it("leads back to a maze that could not be saved", async () => {
    const device = new MemoryStorage();
    device.isFull = true;
    const page = openPage(device);
    page.rename("Unsaved");
    await page.go("/", `#${mazeLink}`);
    page.message()?.action?.run();
    expect(page.shown()).toBe("Unsaved");
  });

  it("opens with an empty program when the link has none and the reader has only the example", async () => {
    const page = openPage(new MemoryStorage());
    await page.go("/", `#${mazeLink}`);
    expect(page.workspace.getState().program).toEqual(emptyProgram());
    // Opened once more it is the same work.
    await page.go("/", `#${mazeLink}`);
    expect(page.names()).toEqual(["Shared"]);
  });

  it("keeps the program that the reader has written when the link has none", async () => {
    const page = openPage(new MemoryStorage());
    const mine = { ...firstProgram, name: "Mine" };
    setProgram(page.workspace, mine);
    await page.go("/", `#${mazeLink}`);
    expect(page.workspace.getState().program).toBe(mine);
  });

  it("takes the link out of the address, so that a reload keeps the reader's edits", async () => {
    const device = new MemoryStorage();
    const page = openPage(device);
    await page.go("/", `#${mazeLink}`);
    expect(page.addresses).toEqual(["/"]);
    page.rename("Shared, my way");
    expect(openPage(device, page.tab).shown()).toBe("Shared, my way");
  });

  it.each([
    { name: "of a maze", link: mazeLink },
    { name: "of a maze and a program", link: fullLink },
  ])("does not pile up works when a link $name is opened again", async ({ link }) => {
    const page = openPage(new MemoryStorage());
    page.rename("Mine");
    for (let time = 0; time < 3; time++) await page.go("/", `#${link}`);
    expect(page.names()).toEqual(["Mine", "Shared"]);
  });

  it("opens a fresh copy when the reader has changed the first one", async () => {
    const page = openPage(new MemoryStorage());
    await page.go("/", `#${mazeLink}`);
    page.rename("Changed");
    await page.go("/", `#${mazeLink}`);
    expect(page.shown()).toBe("Shared");
    expect(page.names()).toEqual(["Changed", "Shared"]);
  });

  it("opens a program alone in a copy of the reader's maze", async () => {
    const page = openPage(new MemoryStorage());
    page.rename("Mine");
    await page.go("/", `#${linkOf({ program: sharedProgram })}`);
    expect(page.shown()).toBe("Mine");
    expect(page.workspace.getState().program.name).toBe("Shared rules");
    expect(page.names()).toEqual(["Mine", "Mine"]);
  });

  it.each([
    { name: "cut off", link: fullLink.slice(0, -8), text: "A part of this link is missing." },
    { name: "changed", link: `${fullLink.slice(0, -1)}~`, text: "This link was changed" },
    {
      name: "of another version",
      link: `9${fullLink.slice(1)}`,
      text: "Corridor cannot open this link",
    },
    { name: "too long", link: "1".repeat(9_000), text: "This link is too long" },
  ])(
    "keeps what it had when the link is $name, and offers an empty maze",
    async ({ link, text }) => {
      const page = openPage(new MemoryStorage());
      page.rename("Mine");
      await page.go("/", `#${link}`);
      expect(page.shown()).toBe("Mine");
      expect(page.names()).toEqual(["Mine"]);
      expect(page.message()?.tone).toBe("bad");
      expect(page.message()?.text).toContain(text);
      page.message()?.action?.run();
      expect(page.emptied).toEqual(["empty"]);
    },
  );

  it.each(["", "#"])("does nothing for an address with the fragment '%s'", async (hash) => {
    const page = openPage(new MemoryStorage());
    await page.go("/", hash);
    expect(page.addresses).toEqual([]);
    expect(page.message()).toBeUndefined();
  });
});

describe("opening the link of a run", () => {
  const run: RunDocument = {
    format: "corridor/run",
    version: 1,
    name: "Tuesday",
    maze: sharedMaze,
    program: sharedProgram,
    seed: 0,
    ticks: 600,
    inputs: [],
    digest: "0123456789abcdef",
  };

  it("opens the run and cleans the address", async () => {
    const page = openPage(new MemoryStorage());
    await page.go("/", `#${linkOf({ run })}`);
    expect(page.runs).toEqual(["Tuesday"]);
    // Not before it is there: a reload meanwhile begins again.
    expect(page.runAddresses).toEqual([]);
    expect(page.addresses).toEqual(["/"]);
    expect(page.message()).toBeUndefined();
  });

  it("opens a challenge with what it brought, and speaks of own work only where there is some", async () => {
    const challenge: ChallengeDocument = {
      format: "corridor/challenge",
      version: 1,
      name: "Find the way",
      words: { task: "Reach the goal.", short: "Reach the goal", hints: [] },
      mazes: [sharedMaze],
      program: null,
      goal: { kind: "reach" },
      allowed: {
        drivers: ["program"],
        lines: 3,
        conditions: null,
        actions: null,
        edits: ["lines"],
        maze: false,
      },
      checks: { bumps: 0, seconds: 60 },
      par: null,
    };
    const page = openPage(new MemoryStorage());
    await page.go("/", `#${linkOf({ challenge })}`);
    expect(page.message()?.text).toBe("You opened a shared challenge.");
    page.rename("Mine");
    await page.go("/", `#${linkOf({ challenge, program: sharedProgram })}`);
    expect(page.message()?.text).toBe("You opened a shared challenge. Your own work is saved.");
    expect(page.challenges).toEqual([
      ["Find the way", null],
      ["Find the way", "Shared rules"],
    ]);
    expect(page.addresses).toEqual(["/", "/"]);
    // One whose files did not come is not said to be open, and a reload opens it.
    const messages = page.screen.getState().messages.length;
    await page.go("/", `#${linkOf({ challenge: { ...challenge, name: "Offline" } })}`);
    expect(page.addresses).toEqual(["/", "/"]);
    expect(page.screen.getState().messages).toHaveLength(messages);
  });

  it("says what is wrong with a run that cannot be repeated", async () => {
    const page = openPage(new MemoryStorage());
    await page.go("/", `#${linkOf({ run: { ...run, ticks: 0 } })}`);
    expect(page.message()).toMatchObject({
      tone: "bad",
      text: "This run cannot be opened: found a, expected b. Ask for a new link.",
    });
  });
});

describe("opening a short link", () => {
  const address = "/m/AAAAAAAAAAAA";

  it("shows the maze beside the reader's own work, and leads back", async () => {
    const page = openPage(new MemoryStorage());
    page.rename("Mine");
    page.shelved.set("AAAAAAAAAAAA", { ok: true, value: { maze: sharedMaze } });
    await page.go(address, "");
    expect(page.asked).toEqual(["AAAAAAAAAAAA"]);
    expect(page.shown()).toBe("Shared");
    expect(page.names()).toEqual(["Mine", "Shared"]);
    expect(page.addresses).toEqual(["/"]);
    page.message()?.action?.run();
    expect(page.shown()).toBe("Mine");
  });

  it("brings a program to the reader's own maze", async () => {
    const page = openPage(new MemoryStorage());
    page.rename("Mine");
    page.shelved.set("AAAAAAAAAAAA", { ok: true, value: { program: sharedProgram } });
    await page.go(address, "");
    expect(page.shown()).toBe("Mine");
    expect(page.workspace.getState().program.name).toBe("Shared rules");
  });

  it("says that it leads nowhere, keeps the work and offers an empty maze", async () => {
    const page = openPage(new MemoryStorage());
    page.rename("Mine");
    page.shelved.set("AAAAAAAAAAAA", { ok: false, sentence: "share.shortLink.gone" });
    await page.go(address, "");
    expect(page.message()?.text).toContain("not opened for 180 days");
    expect(page.shown()).toBe("Mine");
    expect(page.addresses).toEqual(["/"]);
    page.message()?.action?.run();
    expect(page.emptied).toEqual(["empty"]);
  });

  it("stays in the address where the service does not answer, and can be tried again", async () => {
    const page = openPage(new MemoryStorage());
    await page.go(address, "");
    expect(page.addresses).toEqual([]);
    page.shelved.set("AAAAAAAAAAAA", { ok: true, value: { maze: sharedMaze } });
    page.message()?.action?.run();
    await vi.waitFor(() => expect(page.shown()).toBe("Shared"));
    expect(page.asked).toHaveLength(2);
  });

  it("stays in the address while too many wrong codes come from the network", async () => {
    const page = openPage(new MemoryStorage());
    page.shelved.set("BCDF", { ok: false, sentence: "share.shortLink.wait" });
    await page.go("/m/BCDF", "");
    expect(page.message()?.text).toContain("Too many wrong short links");
    expect(page.addresses).toEqual([]);
    page.shelved.set("BCDF", { ok: true, value: { maze: sharedMaze } });
    page.message()?.action?.run();
    await vi.waitFor(() => expect(page.shown()).toBe("Shared"));
  });

  it("opens with a slash after the code as well", async () => {
    const page = openPage(new MemoryStorage());
    await page.go("/m/BCDF/", "");
    expect(page.asked).toEqual(["BCDF"]);
  });
});

describe("deleting a work", () => {
  it("can be taken back", async () => {
    const page = openPage(new MemoryStorage());
    page.rename("Mine");
    await page.go("/", `#${mazeLink}`);
    const mine = page.works.list().find(({ maze }) => maze.name === "Mine");
    if (mine === undefined) throw new Error("the work is not on the shelf");
    page.works.remove(mine);
    expect(page.names()).toEqual(["Shared"]);
    page.message()?.action?.run();
    expect(page.names()).toEqual(["Mine", "Shared"]);
  });
});

describe("a damaged work", () => {
  it("is told once, with the field that is wrong", async () => {
    const device = new MemoryStorage();
    device.setItem("corridor.work.x", JSON.stringify({ maze: { ...firstMaze, version: 9 } }));
    const page = openPage(device);
    page.works.list();
    const texts = page.screen.getState().messages.map(({ text }) => text);
    expect(texts).toHaveLength(1);
    expect(texts[0]).toContain("maze.version: found 9");
  });
});

describe("opening the address of a mission", () => {
  it("opens it, and the address stays", async () => {
    const page = openPage(new MemoryStorage());
    await page.go("/", "#mission/side-opening");
    expect(page.missions).toEqual(["side-opening"]);
    expect([page.addresses, page.refused]).toEqual([[], []]);
  });

  it("says so where there is no such mission", async () => {
    const page = openPage(new MemoryStorage());
    await page.go("/", "#mission/no-such");
    expect(page.refused).toEqual(["#mission/no-such"]);
  });

  it("offers another try where the lessons do not load", async () => {
    const page = openPage(new MemoryStorage());
    await page.go("/", "#mission/offline");
    expect(page.refused).toEqual([]);
    expect(page.message()?.action?.label).toBe("Try again");
  });
});
