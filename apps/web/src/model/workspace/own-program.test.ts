import { emptyProgram, programPresets, setNumber } from "@corridor/program";
import { describe, expect, it } from "vitest";
import { firstProject } from "../projects/first-visit.ts";
import { en } from "../../text/en/index.ts";
import { createI18n, showLanguage } from "../../text/i18n.ts";
import { createWorkspaceStore, redo, setProgram, undo } from "./workspace-store.ts";
import { isOwnProgram, namedAfterEdit, programForMaze } from "./own-program.ts";

const words = createI18n(en);

describe("a program of the student's own", () => {
  it("is none where it is empty, whatever its name", () => {
    expect(isOwnProgram(emptyProgram(), words)).toBe(false);
    expect(isOwnProgram(emptyProgram("Mine"), words)).toBe(false);
  });

  it("is not the example of the first visit, in any language", async () => {
    const other = createI18n(en);
    expect(isOwnProgram(firstProject(other).program, other)).toBe(false);
    await showLanguage(other, "de");
    expect(isOwnProgram(firstProject(other).program, other)).toBe(false);
  });

  it("is not the example or a preset that was named before the language changed", async () => {
    const other = createI18n(en);
    await showLanguage(other, "de");
    const { program } = firstProject(other);
    const backAndForth = {
      ...emptyProgram(other.t("program.preset.back-and-forth.name")),
      rules: programPresets.find(({ id }) => id === "back-and-forth")?.program.rules ?? [],
    };
    await showLanguage(other, "fr");
    expect(isOwnProgram(program, other)).toBe(false);
    expect(isOwnProgram(backAndForth, other)).toBe(false);
    expect(isOwnProgram(firstProject(words).program, other)).toBe(false);
  });

  it.each(programPresets)("is not $id as it is loaded", ({ id, program }) => {
    expect(isOwnProgram(program, words)).toBe(false);
    const name = words.t(`program.preset.${id}.name`);
    expect(isOwnProgram({ ...program, name }, words)).toBe(false);
  });

  it.each(programPresets)("is one with the lines of $id under a name of its own", ({ program }) => {
    expect(isOwnProgram({ ...program, name: "" }, words)).toBe(true);
    expect(isOwnProgram({ ...program, name: "Mine" }, words)).toBe(true);
  });

  it("is one once a number of a preset was changed", () => {
    const { program } = firstProject(words);
    const edit = setNumber(program, 0, 70);
    if (!edit.ok) throw new Error(edit.code);
    expect(isOwnProgram(edit.program, words)).toBe(true);
  });

  it("is one without lines in which the robot turns round", () => {
    expect(isOwnProgram({ ...emptyProgram(), default: "turn 180" }, words)).toBe(true);
  });

  it("stays with another maze; anything else makes room for an empty program", () => {
    expect(programForMaze({ ...firstProject(words).program, name: "Mine" }, words)).toBeNull();
    expect(programForMaze(firstProject(words).program, words)).toEqual(emptyProgram());
    expect(programForMaze(emptyProgram("Mine"), words)).toEqual(emptyProgram("Mine"));
  });
});

describe("the name of a preset program whose lines are changed", () => {
  const changed = (name: string) => {
    const program = { ...firstProject(words).program, name };
    const edit = setNumber(program, 0, 70);
    if (!edit.ok) throw new Error(edit.code);
    const workspace = createWorkspaceStore(firstProject(words).maze, program, (before, after) =>
      namedAfterEdit(before, after, words),
    );
    setProgram(workspace, edit.program);
    return { workspace, name: () => workspace.getState().program.name };
  };

  it.each(["Example: right wall", "Right wall"])(
    "is no longer %s, and undo gives it back",
    (was) => {
      const { workspace, name } = changed(was);
      expect(name()).toBe("My program");
      undo(workspace);
      expect(name()).toBe(was);
      redo(workspace);
      expect(name()).toBe("My program");
    },
  );

  it.each(["Mine", ""])("stays where the student has named it %j", (was) => {
    expect(changed(was).name()).toBe(was);
  });

  it("stays if a student's own lines have the name of a preset", () => {
    const { workspace, name } = changed("Right wall");
    const own = workspace.getState().program;
    setProgram(workspace, { ...own, name: "Right wall" });
    setProgram(workspace, { ...own, name: "Right wall", default: "reverse" });
    expect(name()).toBe("Right wall");
  });
});
