import { describe, expect, it } from "vitest";
import { firstProject } from "./first-visit.ts";
import { createRunStore } from "../run/run-store.ts";
import { createWorkspaceStore, setProgram, undo } from "../workspace/workspace-store.ts";
import { en } from "../../text/en/index.ts";
import { createI18n, showLanguage } from "../../text/i18n.ts";
import { followLanguage } from "./follow-language.ts";

// cspell:ignore Rechte Beispiel

function page() {
  const words = createI18n(en);
  const { maze, program } = firstProject(words);
  const workspace = createWorkspaceStore(maze, program);
  const run = createRunStore();
  followLanguage({ workspace, run }, words);
  return { words, workspace, run, program };
}

describe("the name of a preset program after the language changed", () => {
  it("is in the new language, and undo still reverts the edit before", async () => {
    const { words, workspace, program } = page();
    const rightWall = { ...program, name: "Right wall" };
    setProgram(workspace, rightWall);
    await showLanguage(words, "de");
    expect(workspace.getState().program.name).toBe("Rechte Wand");
    undo(workspace);
    expect(workspace.getState().program).toEqual(program);
  });

  it("labels the example as one in the new language", async () => {
    const { words, workspace } = page();
    await showLanguage(words, "de");
    expect(workspace.getState().program.name).toBe("Beispiel: rechte Wand");
    await showLanguage(words, "ja");
    expect(workspace.getState().program.name).toBe("例：右の壁");
  });

  it("stays while there is a run, which would record the new one as an edit", async () => {
    const { words, workspace, run, program } = page();
    run.setState({ nowTick: 60 });
    await showLanguage(words, "de");
    expect(workspace.getState().program).toBe(program);
  });

  it("stays where the student gave it", async () => {
    const { words, workspace, program } = page();
    setProgram(workspace, { ...program, name: "Mine" });
    await showLanguage(words, "de");
    expect(workspace.getState().program.name).toBe("Mine");
  });
});
