/**
 * Opens files from the picker, dropped files, or text from the clipboard. They open as a new
 * project beside the user's own. If any file has a problem, no file opens, and the problems are
 * reported.
 */
import { isBinaryMaze, readBinaryMaze, type MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { FieldProblem } from "@corridor/protocol";
import type { i18n } from "i18next";
import type { Services } from "../../model/services.ts";
import { dismiss, showMessage } from "../../model/screen/screen-store.ts";
import { joinList } from "../../text/joined.ts";
import { isPaused } from "../../model/classes/class-store.ts";
import { programForMaze } from "../../model/workspace/own-program.ts";
import { openRun } from "../../model/projects/open-run.ts";
import type { TextFile } from "../../ui/incoming-files.ts";
import { readDocument, titleOf, type OpenedDocument } from "./read-document.ts";

/** The problems of one file. */
export interface FileReport {
  file: string;
  problems: readonly FieldProblem[];
  /**
   * whether the text of the file is wrong, so that editing it helps; not for pictures or too many
   * files
   */
  isTextWrong: boolean;
}

/** The longest run fits. A larger file, such as a film that was chosen by mistake, is not read. */
const MAX_BYTES = 9_000_000;
/** Size of a binary maze. */
const BINARY_BYTES = 256;
/** More files than this are not read at all. */
const MAX_FILES = 10;

type Opener = Pick<
  Services,
  "projects" | "workspace" | "simulator" | "screen" | "lessons" | "classes" | "camera"
>;

/** @returns an empty list if the files were opened; otherwise the problems, by file */
export async function openFiles(
  services: Opener,
  words: Pick<i18n, "t" | "language" | "loadNamespaces">,
  files: readonly TextFile[],
): Promise<readonly FileReport[]> {
  if (isPaused(services.classes)) return [];
  if (files.length > MAX_FILES) {
    const found = words.t("files.files", { count: files.length });
    return [tooMuch(files.slice(0, MAX_FILES), found, words)];
  }
  const reports: FileReport[] = [];
  const opened: OpenedDocument[] = [];
  for (const file of files) {
    const result = await readFile(file, words);
    if (result.ok) opened.push(result.value);
    else {
      const { problems, isTextWrong } = result;
      reports.push({ file: file.name, problems, isTextWrong });
    }
  }
  const mazes = opened.flatMap((each) => (each.kind === "maze" ? [each.maze] : []));
  const programs = opened.flatMap((each) => (each.kind === "program" ? [each.program] : []));
  const runs = opened.flatMap((each) => (each.kind === "run" ? [each.run] : []));
  const lessons = opened.flatMap((each) => (each.kind === "lesson" ? [each.lesson] : []));
  // A run contains its own maze and program, a lesson its own mazes and programs.
  const isWhole = runs.length > 0 || lessons.length > 0;
  const isTooMuch = isWhole ? opened.length > 1 : mazes.length > 1 || programs.length > 1;
  if (isTooMuch) {
    const found = [
      words.t("files.mazes", { count: mazes.length }),
      words.t("files.programs", { count: programs.length }),
      words.t("files.runs", { count: runs.length }),
      words.t("files.lessons", { count: lessons.length }),
    ];
    reports.push(tooMuch(files, joinList(words.t, found), words));
  }
  if (reports.length > 0) return reports;
  const [run] = runs;
  if (run !== undefined) {
    const problems = await openRun(services, words, run);
    return problems.length === 0
      ? []
      : [{ file: files[0]?.name ?? "", problems, isTextWrong: true }];
  }
  const [lesson] = lessons;
  if (lesson === undefined) openDocuments(services, words, mazes[0], programs[0]);
  else if (await services.lessons.openShared(lesson, null)) {
    showMessage(services.screen, { tone: "info", text: words.t("missions:lesson.openedBeside") });
  }
  const contest = opened.find((each) => each.kind === "maze" && each.isContest);
  if (contest?.kind === "maze") {
    const { showCheck } = await import("./contest/show-check.ts");
    await showCheck(services, words, contest.maze);
  }
  return [];
}

function tooMuch(files: readonly TextFile[], found: string, words: Pick<i18n, "t">): FileReport {
  const expected = words.t("files.oneOfEach");
  return {
    file: joinList(
      words.t,
      files.map(({ name }) => name),
    ),
    problems: [{ path: "", found, expected }],
    isTextWrong: false,
  };
}

/** Opens a maze, a program or both as a new project, with a message that leads back. */
function openDocuments(
  services: Opener,
  words: Pick<i18n, "t">,
  maze: MazeDocument | undefined,
  program: ProgramDocument | undefined,
): void {
  if (maze === undefined && program === undefined) return;

  const open = services.workspace.getState();
  // A maze alone is there to be solved: it opens with the user's own program, or with an empty one.
  const opened = program ?? programForMaze(open.program, words);
  const back = services.projects.begin(maze ?? open.maze, opened);
  const names = {
    maze: maze?.name || words.t("projects.unnamed"),
    program: program?.name || words.t("files.unnamedProgram"),
  };
  const kind = maze === undefined ? "program" : program === undefined ? "maze" : "both";
  const id = showMessage(services.screen, {
    tone: "info",
    text:
      kind === "maze" && opened !== null
        ? words.t(`presets.${maze?.goals.length === 0 ? "chosenNoGoal" : "chosenEmpty"}`, {
            name: names.maze,
          })
        : words.t(`files.opened.${kind}`, names),
    action: {
      label: words.t("projects.back"),
      run: () => {
        dismiss(services.screen, id);
        back();
      },
    },
  });
}

type ReadFile = { ok: true; value: OpenedDocument } | ({ ok: false } & Omit<FileReport, "file">);

async function readFile(file: TextFile, words: Pick<i18n, "t" | "language">): Promise<ReadFile> {
  if (isPicture(file)) return refuse(words.t("files.aPicture"), words.t("files.noPicture"));
  if (file.size > MAX_BYTES) {
    const size = new Intl.NumberFormat(words.language, {
      maximumFractionDigits: 1,
      numberingSystem: "latn",
    });
    const found = words.t("files.megabytes", { size: size.format(file.size / 1_000_000) });
    return refuse(found, words.t("files.atMost", { size: size.format(MAX_BYTES / 1_000_000) }));
  }
  let text: string;
  try {
    if (file.size === BINARY_BYTES && file.arrayBuffer !== undefined) {
      const bytes = new Uint8Array(await file.arrayBuffer());
      if (isBinaryMaze(bytes)) return readBinary(bytes, titleOf(file.name));
    }
    text = await file.text();
  } catch {
    // A folder, or a file that was moved or locked in the meantime.
    return refuse(words.t("files.unreadable"), words.t("files.readable"));
  }
  const read = readDocument(text, titleOf(file.name));
  return read.ok ? read : { ...read, isTextWrong: true };
}

function readBinary(bytes: Uint8Array, name: string): ReadFile {
  const read = readBinaryMaze(bytes, name);
  return read.ok
    ? { ok: true, value: { kind: "maze", maze: read.value, isContest: true } }
    : { ...read, isTextWrong: true };
}

/** Detects a picture, such as a photo or a screenshot of a maze, by its type or its name. */
function isPicture({ name, type = "" }: TextFile): boolean {
  return type.startsWith("image/") || /\.(png|jpe?g|gif|webp|bmp|svg|heic|avif)$/i.test(name);
}

function refuse(found: string, expected: string): ReadFile {
  return { ok: false, problems: [{ path: "", found, expected }], isTextWrong: false };
}
