import { mazePresets } from "@corridor/maze";
import { emptyProgram, programPresets } from "@corridor/program";
import type { ReactNode } from "react";
import { describe, expect, it, vi } from "vitest";
import { createClassStore } from "../../model/classes/class-store.ts";
import { CurrentProject } from "../../model/projects/current-project.ts";
import { ProjectService } from "../../model/projects/project-service.ts";
import { ProjectStorage } from "../../model/projects/project-storage.ts";
import { readProject } from "../../model/projects/read-project.ts";
import { createScreenStore } from "../../model/screen/screen-store.ts";
import { MemoryStorage } from "../../model/storage/testing/memory-storage.ts";
import { createWorkspaceStore } from "../../model/workspace/workspace-store.ts";
import { en } from "../../text/en/index.ts";
import { createI18n } from "../../text/i18n.ts";
import type { TextFile } from "../../ui/incoming-files.ts";
import { openFiles } from "./open-files.ts";

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

/** A page with one project that opens files. */
function openDuring(pause: ReactNode, ...files: TextFile[]) {
  let count = 0;
  const newId = () => `id-${(count += 1)}`;
  const device = new MemoryStorage();
  const store = new ProjectStorage(device, () => readProject);
  const current = new CurrentProject(
    { store, tab: new MemoryStorage(), now: () => count, newId },
    before.maze,
    before.program,
  );
  const workspace = createWorkspaceStore(before.maze, before.program);
  const screen = createScreenStore();
  const classes = createClassStore();
  classes.setState({ pause });
  const ports = { workspace, screen, simulator: { send: () => undefined }, words };
  const projects = new ProjectService({
    ...ports,
    store,
    current,
    tasks: { hasTask: () => false, copyTask: () => undefined },
    later: () => undefined,
  });
  const services = { screen, workspace, projects, classes, simulator: ports.simulator };
  const reports = openFiles(services as unknown as Parameters<typeof openFiles>[0], words, files);
  const shown = () => {
    const { maze, program } = workspace.getState();
    return { maze, program };
  };
  return { reports, shown, screen, projects };
}

function open(...files: TextFile[]) {
  return openDuring(null, ...files);
}

const words = createI18n(en);

describe("opening files", () => {
  it("opens nothing while the teacher has paused the class", async () => {
    const { reports, shown } = openDuring("paused", file("a.json", mazeOne));
    expect(await reports).toEqual([]);
    expect(shown()).toEqual(before);
  });

  it.each([
    // The previous program is a preset, so no program of a student is lost.
    {
      are: "a maze",
      files: [file("a.json", mazeOne)],
      opened: { maze: mazeOne, program: emptyProgram() },
    },
    {
      are: "a program",
      files: [file("b.json", programOne)],
      opened: { maze: mazeTwo, program: programOne },
    },
    {
      are: "a maze and a program",
      files: [file("b.json", programOne), file("a.json", mazeOne)],
      opened: { maze: mazeOne, program: programOne },
    },
  ])("makes a project of $are, and leads back", async ({ files, opened }) => {
    const { reports, shown, screen, projects } = open(...files);
    const own = projects.currentId();
    expect(await reports).toEqual([]);
    expect(shown()).toEqual(opened);
    expect(projects.currentId()).not.toBe(own);
    const [message] = screen.getState().messages;
    message?.action?.run();
    expect(shown()).toEqual(before);
    expect(projects.currentId()).toBe(own);
    expect(screen.getState().messages).toEqual([]);
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
    const { reports, shown, projects } = open(...files);
    expect((await reports).map((each) => each.file)).toEqual(bad);
    expect(shown()).toEqual(before);
    expect(projects.list()).toEqual([]);
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
    const { reports, shown } = open({ ...file(name, "\uFFFDPNG"), type });
    const [report] = await reports;
    expect(report?.file).toBe(name);
    expect(report).toMatchObject({ problems: [{ found: "a picture" }], isTextWrong: false });
    expect(shown()).toEqual(before);
  });
});
