import { resolveObjectURL } from "node:buffer";
import { mazePresets, readMaze, readTextMaze } from "@corridor/maze";
import { programPresets, readProgram } from "@corridor/program";
import { beforeEach, expect, it, vi } from "vitest";
import { saveDocument, saveFile, saveTextMaze } from "./save-file.ts";

interface Download {
  name: string;
  /** reads the file, as a browser does once the user has chosen a folder; null if it is gone */
  read: () => Promise<string | null>;
}

/** A browser: its downloads are the links that were clicked. */
function stubBrowser(): Download[] {
  const downloads: Download[] = [];
  const createElement = () => {
    const link = {
      href: "",
      download: "",
      click: () => {
        const { href, download: name } = link;
        const read = async () => (await resolveObjectURL(href)?.text()) ?? null;
        downloads.push({ name, read });
      },
    };
    return link;
  };
  vi.stubGlobal("document", { createElement });
  return downloads;
}

beforeEach(() => {
  vi.useFakeTimers();
  return () => {
    vi.useRealTimers();
    vi.unstubAllGlobals();
  };
});

const [{ maze } = { maze: null }] = mazePresets;
const [{ program } = { program: null }] = programPresets;
if (maze === null || program === null) throw new Error("a preset is gone");

it.each([
  {
    what: "a maze",
    save: () => saveDocument({ ...maze, name: "Long way" }, "maze"),
    file: "long-way.maze.json",
    read: readMaze,
    document: { ...maze, name: "Long way" },
  },
  {
    what: "a program",
    save: () => saveDocument({ ...program, name: "" }, "program"),
    file: "program.program.json",
    read: readProgram,
    document: { ...program, name: "" },
  },
  {
    what: "a maze drawn as text",
    save: () => saveTextMaze({ ...maze, name: "Long way" }),
    file: "long-way.txt",
    read: (text: string) => readTextMaze(text, "Long way"),
    document: { ...maze, name: "Long way" },
  },
])("saves $what as a file that can be opened again", async ({ save, file, read, document }) => {
  const downloads = stubBrowser();
  save();
  expect(downloads.map(({ name }) => name)).toEqual([file]);
  const text = await downloads[0]?.read();
  expect(read(text ?? "")).toEqual({ ok: true, value: document });
});

it("saves a run without white space, because its size limit applies to the compact text", async () => {
  const downloads = stubBrowser();
  saveDocument({ name: "Best run", inputs: [{ tick: 1 }] } as { name: string }, "run");
  expect(downloads[0]?.name).toBe("best-run.run.json");
  expect(await downloads[0]?.read()).toBe('{"name":"Best run","inputs":[{"tick":1}]}');
});

it("gives the user half a minute to choose a folder, and then frees the memory", async () => {
  const downloads = stubBrowser();
  saveFile(new Blob(["a drawing"]), "maze.txt");
  const [download] = downloads;
  vi.advanceTimersByTime(30_000);
  expect(await download?.read()).toBe("a drawing");
  vi.advanceTimersByTime(60_000);
  expect(await download?.read()).toBeNull();
});
