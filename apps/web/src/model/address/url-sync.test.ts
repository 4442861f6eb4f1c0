import { lessonOf, type ChallengeDocument } from "@corridor/challenge";
import { encodeLink, type LinkContent } from "@corridor/link";
import { emptyProgram } from "@corridor/program";
import type { RunDocument } from "@corridor/recording";
import { describe, expect, it, vi } from "vitest";
import { createScreenStore } from "../screen/screen-store.ts";
import { createWorkspaceStore, setMaze, setProgram } from "../workspace/workspace-store.ts";
import { en } from "../../text/en/index.ts";
import { createI18n } from "../../text/i18n.ts";
import { CurrentProject } from "../projects/current-project.ts";
import { programForMaze } from "../workspace/own-program.ts";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { readProject } from "../projects/read-project.ts";
import { MemoryStorage } from "../storage/testing/memory-storage.ts";
import { decodeSharedLink } from "./shared-link.ts";
import type { ShortLinkResult } from "./short-link.ts";
import { followAddress } from "./url-sync.ts";
import { ProjectService } from "../projects/project-service.ts";
import { ProjectStorage } from "../projects/project-storage.ts";

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
  loadLinks = () => Promise.resolve({ decodeSharedLink }),
) {
  const store = new ProjectStorage(device, () => readProject);
  const current = new CurrentProject(
    { store, tab, now: () => ++lastId, newId: () => `id-${++lastId}` },
    firstMaze,
    firstProgram,
  );
  const workspace = createWorkspaceStore(current.project.maze, current.project.program);
  const screen = createScreenStore();
  const words = createI18n(en);
  const later = () => undefined;
  const simulator = { send: () => undefined };
  const projects = new ProjectService({
    store,
    tasks: { hasTask: () => false, copyTask: () => undefined },
    current,
    workspace,
    screen,
    simulator,
    words,
    later,
  });
  const addresses: string[] = [];
  const emptied: string[] = [];
  const runs: string[] = [];
  const asked: string[] = [];
  const shelved = new Map<string, ShortLinkResult>();
  /** replaced addresses before the run was opened */
  const runAddresses: string[] = [];
  const challenges: [string, string | null][] = [];
  const missions: string[] = [];
  const refused: string[] = [];
  const go = (pathname: string, hash: string) =>
    followAddress({
      projects,
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
      openLesson: ({ tasks: [task] }, program) => {
        challenges.push([task?.name ?? "", program?.name ?? null]);
        return Promise.resolve(task?.name !== "Offline");
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
    projects.autosave.flush();
  };
  const shown = () => workspace.getState().maze.name;
  const message = () => screen.getState().messages[0];
  const names = () =>
    projects
      .list()
      .map(({ maze }) => maze.name)
      .toSorted();
  return {
    workspace,
    screen,
    projects,
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
  it("shows the maze beside the user's own project, and leads back", async () => {
    const page = openPage(new MemoryStorage());
    page.rename("Mine");
    await page.go("/", `#${fullLink}`);
    expect(page.shown()).toBe("Shared");
    expect(page.workspace.getState().program.name).toBe("Shared rules");
    expect(page.names()).toEqual(["Mine", "Shared"]);
    expect(page.message()?.text).toBe(
      "You opened a shared maze. Your own maze and program are saved.",
    );
    page.message()?.action?.run();
    expect(page.shown()).toBe("Mine");
    expect(page.screen.getState().messages).toEqual([]);
  });

  it("mentions no own project to a user who has none, however many links are opened", async () => {
    const page = openPage(new MemoryStorage());
    await page.go("/", `#${fullLink}`);
    await page.go("/", `#${mazeLink}`);
    const texts = page.screen.getState().messages.map(({ text }) => text);
    expect(new Set(texts)).toEqual(new Set(["You opened a shared maze."]));
    expect(page.message()?.action).toBeUndefined();
  });

  it("counts a shared maze that the user has changed as an own project", async () => {
    const page = openPage(new MemoryStorage());
    await page.go("/", `#${mazeLink}`);
    page.rename("Changed");
    await page.go("/", `#${fullLink}`);
    const message = page.message();
    expect(message?.text).toBe("You opened a shared maze. Your own maze and program are saved.");
    message?.action?.run();
    expect(page.shown()).toBe("Changed");
  });

  it("leads back to a maze that could not be stored", async () => {
    const device = new MemoryStorage();
    device.isFull = true;
    const page = openPage(device);
    page.rename("Unsaved");
    await page.go("/", `#${mazeLink}`);
    page.message()?.action?.run();
    expect(page.shown()).toBe("Unsaved");
  });

  it("opens with an empty program if the link has none and the user has only the example", async () => {
    const page = openPage(new MemoryStorage());
    await page.go("/", `#${mazeLink}`);
    expect(page.workspace.getState().program).toEqual(emptyProgram());
    // Opened again, it is the same project.
    await page.go("/", `#${mazeLink}`);
    expect(page.names()).toEqual(["Shared"]);
  });

  it("retains the program that the user has written if the link has none", async () => {
    const page = openPage(new MemoryStorage());
    const mine = { ...firstProgram, name: "Mine" };
    setProgram(page.workspace, mine);
    await page.go("/", `#${mazeLink}`);
    expect(page.workspace.getState().program).toBe(mine);
  });

  it("removes the link from the address, so that a reload retains the user's edits", async () => {
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
  ])("does not create more projects when a link $name is opened again", async ({ link }) => {
    const page = openPage(new MemoryStorage());
    page.rename("Mine");
    for (let time = 0; time < 3; time++) await page.go("/", `#${link}`);
    expect(page.names()).toEqual(["Mine", "Shared"]);
  });

  it("opens a fresh copy if the user has changed the first one", async () => {
    const page = openPage(new MemoryStorage());
    await page.go("/", `#${mazeLink}`);
    page.rename("Changed");
    await page.go("/", `#${mazeLink}`);
    expect(page.shown()).toBe("Shared");
    expect(page.names()).toEqual(["Changed", "Shared"]);
  });

  it("opens a program alone in a copy of the user's maze", async () => {
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
    // Not before the run is open: a reload meanwhile starts again.
    expect(page.runAddresses).toEqual([]);
    expect(page.addresses).toEqual(["/"]);
    expect(page.message()).toBeUndefined();
  });

  it("opens a challenge with its content, and mentions an own project only if there is one", async () => {
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
    await page.go("/", `#${linkOf({ lesson: lessonOf(challenge) })}`);
    expect(page.message()?.text).toBe("You opened a shared challenge.");
    page.rename("Mine");
    await page.go("/", `#${linkOf({ lesson: lessonOf(challenge), program: sharedProgram })}`);
    expect(page.message()?.text).toBe(
      "You opened a shared challenge. Your own maze and program are saved.",
    );
    expect(page.challenges).toEqual([
      ["Find the way", null],
      ["Find the way", "Shared rules"],
    ]);
    expect(page.addresses).toEqual(["/", "/"]);
    const [task] = lessonOf(challenge).tasks;
    if (task === undefined) throw new Error("no task");
    const lesson = { ...lessonOf(challenge), tasks: [{ ...task, name: "First" }, task] };
    await page.go("/", `#${linkOf({ lesson })}`);
    expect(page.challenges.at(-1)).toEqual(["First", null]);
    expect(page.message()?.text).toBe("lesson.openedBeside");
    // Completion codes are for teachers.
    const completion = { lesson: "0a1b2c3d4", task: 0, attempt: sharedProgram };
    await page.go("/", `#${linkOf({ completion })}`);
    expect(page.message()?.text).toContain("Corridor cannot open this link");
    page.addresses.length = 0;
    // A challenge that did not load is not reported as open, and a reload opens it.
    const messages = page.screen.getState().messages.length;
    await page.go("/", `#${linkOf({ lesson: lessonOf({ ...challenge, name: "Offline" }) })}`);
    expect(page.addresses).toEqual([]);
    expect(page.screen.getState().messages).toHaveLength(messages);
  });

  it("reports the error of a run that cannot be repeated", async () => {
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

  it("shows the maze beside the user's own project, and leads back", async () => {
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

  it("opens a program in the user's own maze", async () => {
    const page = openPage(new MemoryStorage());
    page.rename("Mine");
    page.shelved.set("AAAAAAAAAAAA", { ok: true, value: { program: sharedProgram } });
    await page.go(address, "");
    expect(page.shown()).toBe("Mine");
    expect(page.workspace.getState().program.name).toBe("Shared rules");
  });

  it("reports that it leads nowhere, retains the project and offers an empty maze", async () => {
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

  it("stays in the address if the service does not respond, and can be retried", async () => {
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

describe("deleting a project", () => {
  it("can be reverted", async () => {
    const page = openPage(new MemoryStorage());
    page.rename("Mine");
    await page.go("/", `#${mazeLink}`);
    const mine = page.projects.list().find(({ maze }) => maze.name === "Mine");
    if (mine === undefined) throw new Error("the project is not stored");
    page.projects.remove(mine);
    expect(page.names()).toEqual(["Shared"]);
    page.message()?.action?.run();
    expect(page.names()).toEqual(["Mine", "Shared"]);
  });
});

describe("a damaged project", () => {
  it("is reported once, with the wrong field", async () => {
    const device = new MemoryStorage();
    device.setItem("corridor.work.x", JSON.stringify({ maze: { ...firstMaze, version: 9 } }));
    const page = openPage(device);
    page.projects.list();
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

  it("reports that there is no such mission", async () => {
    const page = openPage(new MemoryStorage());
    await page.go("/", "#mission/no-such");
    expect(page.refused).toEqual(["#mission/no-such"]);
  });

  it("offers to retry if the lessons do not load", async () => {
    const page = openPage(new MemoryStorage());
    await page.go("/", "#mission/offline");
    expect(page.refused).toEqual([]);
    expect(page.message()?.action?.label).toBe("Try again");
  });
});
