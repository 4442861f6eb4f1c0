/**
 * Opens what the reader gives: files from the picker or dropped onto the page, or a text from the
 * clipboard. They open as a new work beside the reader's own; if anything is wrong with any of them,
 * nothing is opened and all that is wrong is told.
 */
import type { FieldProblem } from "@corridor/protocol";
import type { i18n } from "i18next";
import type { Services } from "../../app/services.ts";
import { dismiss, tell } from "../../stores/screen-store.ts";
import { readDocument, titleOf, type OpenedDocument } from "./read-document.ts";

/** As much of a File as is needed. */
export interface TextFile {
  name: string;
  /** bytes */
  size: number;
  text: () => Promise<string>;
}

/** What is wrong with one file. */
export interface FileReport {
  file: string;
  problems: readonly FieldProblem[];
}

/** Far above the largest document that can be read, which is small beside what a wrong choice may be. */
const MAX_BYTES = 1_000_000;

type Opener = Pick<Services, "works" | "workspace" | "simulator" | "screen">;

/** @returns nothing when they were opened; else what is wrong, by file */
export async function openFiles(
  services: Opener,
  words: Pick<i18n, "t" | "language">,
  files: readonly TextFile[],
): Promise<readonly FileReport[]> {
  const reports: FileReport[] = [];
  const opened: OpenedDocument[] = [];
  for (const file of files) {
    const result = await readFile(file, words);
    if (result.ok) opened.push(result.value);
    else reports.push({ file: file.name, problems: result.problems });
  }
  const mazes = opened.flatMap((each) => (each.kind === "maze" ? [each.maze] : []));
  const programs = opened.flatMap((each) => (each.kind === "program" ? [each.program] : []));
  if (mazes.length > 1 || programs.length > 1) {
    reports.push({
      file: files.map(({ name }) => name).join(", "),
      problems: [
        {
          path: "",
          found: [
            words.t("files.mazes", { count: mazes.length }),
            words.t("files.programs", { count: programs.length }),
          ].join(", "),
          expected: words.t("files.oneOfEach"),
        },
      ],
    });
  }
  if (reports.length > 0) return reports;
  const [maze] = mazes;
  const [program] = programs;
  if (maze === undefined && program === undefined) return [];

  const back = services.works.begin(
    maze ?? services.workspace.getState().maze,
    // A maze alone is to be solved with whatever program the reader has.
    program ?? null,
  );
  services.simulator.send({ type: "reset" });
  const names = {
    maze: maze?.name || words.t("works.unnamed"),
    program: program?.name || words.t("files.unnamedProgram"),
  };
  const kind = maze === undefined ? "program" : program === undefined ? "maze" : "both";
  const id = tell(services.screen, {
    tone: "info",
    text: words.t(`files.opened.${kind}`, names),
    action: {
      label: words.t("works.back"),
      run: () => {
        dismiss(services.screen, id);
        back();
        services.simulator.send({ type: "reset" });
      },
    },
  });
  return [];
}

async function readFile(
  file: TextFile,
  words: Pick<i18n, "t" | "language">,
): Promise<ReturnType<typeof readDocument>> {
  if (file.size > MAX_BYTES) {
    const size = new Intl.NumberFormat(words.language, { maximumFractionDigits: 1 });
    const found = words.t("files.megabytes", { size: size.format(file.size / 1_000_000) });
    return refuse(found, words.t("files.atMost", { size: size.format(1) }));
  }
  let text: string;
  try {
    text = await file.text();
  } catch {
    // A folder, or a file that was moved or locked in the meantime.
    return refuse(words.t("files.unreadable"), words.t("files.readable"));
  }
  return readDocument(text, titleOf(file.name));
}

function refuse(found: string, expected: string): { ok: false; problems: FieldProblem[] } {
  return { ok: false, problems: [{ path: "", found, expected }] };
}
