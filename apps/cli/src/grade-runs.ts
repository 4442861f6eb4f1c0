/** Grades programs in maze files. Prints results in the order of the files. */
import { runOnAllCores, startWorkers, terminate } from "./all-cores.ts";
import type { GradeArguments } from "./arguments.ts";
import type { GradedRun } from "./report.ts";

/** @returns the lines to print @throws InputError if the files are invalid */
export async function gradeRuns(parsed: GradeArguments, entry: URL): Promise<string[]> {
  const { programs: programFiles, mazes: mazeFiles, limits, csv, why } = parsed;
  const units = programFiles.length * mazeFiles.length;
  // Dynamic imports follow, so that the workers load their modules concurrently with this thread.
  const workers = startWorkers("runs", { units, seconds: units * limits.seconds }, entry);
  try {
    const { readFiles } = await import("./read-files.ts");
    const { jsonLine, runTable, summaryLine } = await import("./report.ts");
    const { unitsOfRuns } = await import("./run-units.ts");
    const documents = readFiles({ mazes: mazeFiles, programs: programFiles });
    const graded = await runOnAllCores(workers, { ...documents, limits, why }, unitsOfRuns);
    const runs = graded
      .toSorted((a, b) => a.program - b.program || a.maze - b.maze)
      .map(({ program, maze, ...run }): GradedRun => ({
        program: programFiles[program] ?? "",
        maze: mazeFiles[maze] ?? "",
        ...run,
      }));
    if (csv) return runTable(runs);
    const lines = runs.map(({ program, maze, result, diagnosis }) =>
      jsonLine(result, { program, maze }, why ? { diagnosis } : {}),
    );
    return [...lines, summaryLine(runs)];
  } finally {
    await terminate(workers);
  }
}
