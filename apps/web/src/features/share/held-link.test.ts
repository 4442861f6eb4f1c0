import { describe, expect, it } from "vitest";
import {
  createWorkspaceStore,
  setMaze,
  setProgram,
} from "../../model/workspace/workspace-store.ts";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { holdAgain, holdLink, type LinkBar } from "./held-link.ts";

/** An address bar that retains the state of its entry, as a browser does across a reload. */
function addressBar(): LinkBar & { address: () => string } {
  const location = { pathname: "/", search: "?lang=de", hash: "" };
  const entry: { state: unknown } = { state: null };
  return {
    location,
    history: {
      get state() {
        return entry.state;
      },
      replaceState: (state: unknown, _: string, url?: string | URL | null) => {
        entry.state = state;
        location.hash = new URL(String(url), "https://corridor.example").hash;
      },
    },
    address: () => location.pathname + location.search + location.hash,
  };
}

describe("the link in the address bar", () => {
  it.each([
    { held: "maze", change: "program", stays: true },
    { held: "maze", change: "maze", stays: false },
    { held: "program", change: "program", stays: false },
    { held: "program", change: "maze", stays: false },
  ] as const)("of a $held stays when the $change changes: $stays", ({ held, change, stays }) => {
    const workspace = createWorkspaceStore(firstMaze, firstProgram);
    const bar = addressBar();
    holdLink(workspace, bar, "m1abc", held);
    expect(bar.address()).toBe("/?lang=de#m1abc");
    if (change === "maze") setMaze(workspace, { ...firstMaze, name: "Other" });
    else setProgram(workspace, { ...firstProgram, name: "Other" });
    expect(bar.address()).toBe(stays ? "/?lang=de#m1abc" : "/?lang=de");
  });

  it("is known after a reload, and goes with the first change then", () => {
    const bar = addressBar();
    holdLink(createWorkspaceStore(firstMaze, firstProgram), bar, "m1abc", "maze");
    const workspace = createWorkspaceStore(firstMaze, firstProgram);
    expect(holdAgain(workspace, bar)).toBe(true);
    setMaze(workspace, { ...firstMaze, name: "Other" });
    expect(bar.address()).toBe("/?lang=de");
    expect(holdAgain(workspace, bar)).toBe(false);
  });

  it("leaves a newer address alone", () => {
    const workspace = createWorkspaceStore(firstMaze, firstProgram);
    const bar = addressBar();
    holdLink(workspace, bar, "m1abc", "maze");
    bar.history.replaceState(null, "", "#mission/one-line");
    setMaze(workspace, { ...firstMaze, name: "Other" });
    expect(bar.location.hash).toBe("#mission/one-line");
    expect(holdAgain(workspace, bar)).toBe(false);
  });
});
