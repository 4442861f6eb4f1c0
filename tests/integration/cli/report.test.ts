/** Reports on a class with real files: once in a real process, then in this process. */
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { afterAll, describe, expect, it } from "vitest";
import { corridorHere } from "../../support/cli/run-here.ts";

const folder = mkdtempSync(join(tmpdir(), "corridor-report-"));
afterAll(() => rmSync(folder, { recursive: true }));

const paper = (name: string) =>
  fileURLToPath(new URL(`../../../packages/report/src/testing/${name}`, import.meta.url));
const paperFiles = [paper("table-10-times.csv"), paper("table-9-survey.csv")];

function file(name: string, text: string): string {
  const path = join(folder, name);
  writeFileSync(path, text);
  return path;
}

describe("corridor report", () => {
  it("prints the numbers of the study of 2013 from its files", () => {
    const mistakes = ["control_flow=1", "navigation=3", "correctness=3"];
    const main = fileURLToPath(new URL("../../../apps/cli/src/main.ts", import.meta.url));
    const args = [...paperFiles, ...mistakes.flatMap((each) => ["--mistakes", each])];
    const { status, stdout: output } = spawnSync(process.execPath, [main, "report", ...args], {
      encoding: "utf8",
    });
    expect(status).toBe(0);
    for (const line of [
      /^28 students$/m,
      /^right_wall +28 of 28 \(100 %\) +5:17 +4:30 +3:53 +0:30 +14:00 +2 lines \(5 in the paper\)$/m,
      /^farthest_distance +28 of 28 \(100 %\) +3:48 +3:53 +2:15 +0:45 +9:30 +3 lines \(7 in the paper\)$/m,
      /^farthest_distance: table 6 of the paper prints 3:38\. Its text and its data give 3:48\.$/m,
      /^control_flow +0 +3 +5 +9 +11 +0 +4\.0 +1 of 28 \(3\.6 %\)$/m,
      /^navigation +0 +1 +4 +9 +14 +0 +4\.3 +3 of 28 \(10\.7 %\)$/m,
      /^correctness +1 +2 +5 +11 +9 +0 +3\.9 +3 of 28 \(10\.7 %\)$/m,
      /^interaction +0 +1 +6 +9 +12 +0 +4\.1 +-$/m,
    ]) {
      expect(output).toMatch(line);
    }
  });

  it("prints a table that it reads again with the same result", async () => {
    const table = file("all.csv", (await corridorHere("report", ...paperFiles, "--csv")).out);
    const { code, out } = await corridorHere("report", table);
    expect(code).toBe(0);
    expect(out).toBe((await corridorHere("report", ...paperFiles)).out);
  });

  it("prints no mean of one student", async () => {
    const table = file("one.csv", "student,task,seconds,lines\nJuniper,1,60,2\n");
    const { out } = await corridorHere("report", table);
    expect(out).toMatch(/^1 student: too few for a mean$/m);
    expect(out).toMatch(/^1 +1 of 1 \(100 %\) +too few +too few +too few +1:00 +1:00 +too few$/m);
  });

  it("counts all students in every task, and says who opened it", async () => {
    const rows = ["Juniper,1,60,2", "Comet,1,,0", "Comet,2,,4", "Pixel,,,"];
    const text = ["student,task,seconds,attempts", ...rows].join("\n");
    const { out } = await corridorHere("report", file("two.csv", text));
    for (const line of [
      /^1 +1 of 3 \(33 %\) +too few/m,
      /^2 +0 of 3 \(0 %\) +too few/m,
      /^1 +2 of 3 +1 +- /m,
      /^2 +1 of 3 +too few +- /m,
    ]) {
      expect(out).toMatch(line);
    }
  });

  it.each([
    { name: "no file", args: [], says: ["FILE: found nothing, expected one or more CSV files"] },
    {
      name: "two invalid files",
      args: [file("text.csv", "hello world\n"), "missing.csv"],
      says: [
        "text.csv: row 1: found the columns hello world, expected columns student and task",
        "missing.csv: document: found no file of this name",
      ],
    },
    {
      name: "a mistake without a number",
      args: [...paperFiles, "--mistakes", "navigation"],
      says: ['--mistakes: found "navigation", expected such as navigation=3'],
    },
    {
      name: "an unknown question, and more mistakes than students",
      args: [...paperFiles, "--mistakes", "speed=1", "--mistakes", "navigation=29"],
      says: [
        "--mistakes: found speed, expected one of control_flow,",
        "--mistakes: found navigation=29, expected at most 28",
      ],
    },
    { name: "an unknown option", args: ["--json"], says: ["Unknown option '--json'"] },
  ])("explains invalid input: $name", async ({ args, says }) => {
    const { code, errors } = await corridorHere("report", ...args);
    expect(code).toBe(2);
    const problems = errors.trimEnd().split("\n");
    expect(problems).toHaveLength(says.length);
    for (const [index, start] of says.entries()) expect(problems[index]).toContain(start);
  });
});
