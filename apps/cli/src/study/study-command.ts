/** `corridor report`: the figures of a study from its tables. */
import { parseArgs } from "node:util";
import { describeProblem, type ReadResult } from "@corridor/protocol";
import { joinStudies, readStudyCsv, reportOf, studyCsv, type Study } from "@corridor/report";
import { exitCodes, type Command } from "../command.ts";
import { InputError } from "../input-error.ts";
import { readFile } from "../read-files.ts";
import { reportText } from "./report-text.ts";

const HELP = `Usage: corridor report FILE... [--mistakes QUESTION=STUDENTS ...] [--csv]

Prints times, lines, success rates and the answers to the survey of a class.

A FILE is a CSV table of one of three forms:
  student,task,seconds,lines,...       one row per student and task; answers have rows without a task
  right_wall_seconds,...               times in seconds, one row per student
  control_flow,navigation,...          answers from 1 (no help) to 5 (very helpful), one row per student

Options:
  --mistakes QUESTION=STUDENTS  number of students who made a mistake that belongs to a question;
                                can be repeated
  --csv                         print one table with one row per student and task instead

${exitCodes("success", null)}`;

interface Arguments {
  files: readonly string[];
  mistakes: ReadonlyMap<string, number>;
  csv: boolean;
}

export const command: Command = {
  help: HELP,
  run: (args, { print }) => {
    const { files, mistakes, csv } = readArguments(args);
    const study = readStudies(files);
    const report = reportOf(study, mistakes);
    const ids = report.questions.map(({ id }) => id);
    const unknown = [...mistakes.keys()].filter((id) => !ids.includes(id));
    const tooMany = [...mistakes].filter(([, students]) => students > report.students);
    const problems = [
      ...unknown.map((id) => `--mistakes: found ${id}, expected one of ${ids.join(", ")}`),
      ...tooMany.map(
        ([id, students]) =>
          `--mistakes: found ${id}=${students}, expected at most ${report.students}`,
      ),
    ];
    if (problems.length > 0) throw new InputError(problems);
    print(csv ? studyCsv(study) : reportText(report));
    return 0;
  },
};

function readArguments(args: readonly string[]): Arguments {
  const { values, positionals } = parse(args);
  const problems: string[] = [];
  if (positionals.length === 0)
    problems.push("FILE: found nothing, expected one or more CSV files");
  const mistakes = new Map<string, number>();
  for (const text of values.mistakes) {
    const [, id = "", students] = /^([a-z][a-z0-9_]*)=(\d{1,4})$/.exec(text) ?? [];
    if (id === "") {
      problems.push(`--mistakes: found ${JSON.stringify(text)}, expected such as navigation=3`);
    } else mistakes.set(id, Number(students));
  }
  if (problems.length > 0) throw new InputError(problems);
  return { files: positionals, mistakes, csv: values.csv };
}

function parse(args: readonly string[]) {
  try {
    return parseArgs({
      args: [...args],
      options: {
        mistakes: { type: "string", multiple: true, default: [] },
        csv: { type: "boolean", default: false },
      },
      allowPositionals: true,
      strict: true,
    });
  } catch (error) {
    const found = error instanceof Error ? error.message : "Invalid options";
    throw new InputError([`${found.replace(/\.?$/, ".")} The options are --mistakes, --csv.`]);
  }
}

/** @throws InputError with every problem of every file */
function readStudies(files: readonly string[]): Study {
  const read = files.map((file) => ({ file, result: readFile(file, readStudyCsv) }));
  const lines = read.flatMap(({ file, result }) => problemLines(file, result));
  if (lines.length > 0) throw new InputError(lines);
  const joined = joinStudies(read.flatMap(({ result }) => (result.ok ? [result.value] : [])));
  if (!joined.ok) throw new InputError(problemLines(files.join(", "), joined));
  return joined.value;
}

function problemLines(file: string, result: ReadResult<Study>): string[] {
  return result.ok ? [] : result.problems.map((each) => `${file}: ${describeProblem(each)}`);
}
