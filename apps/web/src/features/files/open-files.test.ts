import { mazePresets } from "@corridor/maze";
import { emptyProgram, programPresets } from "@corridor/program";
import { describe, expect, it, vi } from "vitest";
import type { ProjectService } from "../../model/projects/project-service.ts";
import { createScreenStore } from "../../model/screen/screen-store.ts";
import { createWorkspaceStore } from "../../model/workspace/workspace-store.ts";
import { en } from "../../text/en/index.ts";
import { createI18n } from "../../text/i18n.ts";
import { openFiles, type TextFile } from "./open-files.ts";

const [mazeOne, mazeTwo] = mazePresets.map(({ maze }) => maze);
const [programOne, programTwo] = programPresets.map(({ program }) => program);
if (
  mazeOne === undefined ||
  mazeTwo === undefined ||
  programOne === undefined ||
  programTwo === undefined
) {
  throw new Error("a preset is gone");
}
const before = { maze: mazeTwo, program: programTwo };

function file(name: string, content: unknown): TextFile {
  const text = typeof content === "string" ? content : JSON.stringify(content);
  return { name, size: text.length, text: () => Promise.resolve(text) };
}

function open(...files: TextFile[]) {
  const screen = createScreenStore();
  const workspace = createWorkspaceStore(before.maze, before.program);
  const begin = vi.fn<ProjectService["begin"]>(() => () => undefined);
  const send = vi.fn<(message: unknown) => void>();
  const services = { screen, workspace, projects: { begin }, simulator: { send } };
  const reports = openFiles(services as unknown as Parameters<typeof openFiles>[0], words, files);
  return { reports, begin, screen };
}

const words = createI18n(en);

describe("opening files", () => {
  it.each([
    // The previous program is a preset, so no program of a student is lost.
    { are: "a maze", files: [file("a.json", mazeOne)], begun: [mazeOne, emptyProgram()] },
    { are: "a program", files: [file("b.json", programOne)], begun: [mazeTwo, programOne] },
    {
      are: "a maze and a program",
      files: [file("b.json", programOne), file("a.json", mazeOne)],
      begun: [mazeOne, programOne],
    },
  ])("makes a project of $are, and leads back", async ({ files, begun }) => {
    const { reports, begin, screen } = open(...files);
    expect(await reports).toEqual([]);
    expect(begin.mock.calls).toEqual([begun]);
    expect(screen.getState().messages).toHaveLength(1);
  });

  it.each([
    { are: "broken", files: [file("a.json", mazeOne), file("c.json", "{")], bad: ["c.json"] },
    {
      are: "two mazes",
      files: [file("a.json", mazeOne), file("c.json", mazeTwo)],
      bad: ["a.json, c.json"],
    },
    {
      are: "two programs",
      files: [file("a.json", programOne), file("c.json", programTwo)],
      bad: ["a.json, c.json"],
    },
    {
      are: "a folder",
      files: [{ name: "folder", size: 1, text: () => Promise.reject(new Error("a folder")) }],
      bad: ["folder"],
    },
  ])("opens nothing of files that are $are", async ({ files, bad }) => {
    const { reports, begin } = open(...files);
    expect((await reports).map((each) => each.file)).toEqual(bad);
    expect(begin).not.toHaveBeenCalled();
  });

  it("does not read what is too big, nor more files than belong together", async () => {
    const text = vi.fn<TextFile["text"]>(() => Promise.resolve(""));
    const [big] = await open({ name: "film.json", size: 12_345_678, text }).reports;
    expect(big?.problems).toEqual([{ path: "", found: "12.3 MB", expected: "at most 9 MB" }]);
    const many = Array.from({ length: 11 }, (_, at) => ({ name: `${at}`, size: 1, text }));
    expect((await open(...many).reports)[0]?.problems[0]?.found).toBe("11 files");
    expect(text).not.toHaveBeenCalled();
  });

  it.each([
    { are: "a screenshot from the clipboard", name: "Clipboard", type: "image/png" },
    { are: "a photo", name: "maze.JPG", type: "" },
    { are: "a drawing", name: "maze.svg", type: "image/svg+xml" },
  ])("refuses $are as a picture", async ({ name, type }) => {
    const { reports, begin } = open({ ...file(name, "\uFFFDPNG"), type });
    const [report] = await reports;
    expect(report?.file).toBe(name);
    expect(report).toMatchObject({ problems: [{ found: "a picture" }], isTextWrong: false });
    expect(begin).not.toHaveBeenCalled();
  });
});
