/**
 * Programs as code, in every language, run as separate processes: at every decision the same line
 * and, bit for bit, the same pose as the program has in a simulation.
 */
import type { MazeDocument } from "@corridor/maze";
import { codeLanguages, emptyProgram, programCode, type CodeLanguage } from "@corridor/program";
import { paperPrograms, type PaperProgram } from "@corridor/program/testing";
import type { Pose, Registration } from "@corridor/protocol";
import { expect, it, onTestFinished } from "vitest";
import { SeededRandom } from "../../../apps/relay/src/testing/faults/seeded-random.ts";
import { FaultProxy } from "../../../e2e/faults/net/fault-proxy.ts";
import { registerRobot } from "../../../packages/client/src/register-robot.ts";
import { recordsAfter } from "../../support/client/command-records.ts";
import { startSimulatedPage } from "../../support/client/simulated-page.ts";
import { lineOf, ProgramPath } from "../../support/code-export/program-path.ts";
import { ProgramScript, thesisMazes } from "../../support/code-export/program-script.ts";
import { GOAL, missingProgram, runScript, runtimes } from "../../support/code-export/script-run.ts";
import { startRelayProcess } from "../../support/test-relay-process.ts";

/** 30 cells to the goal: 7.5 s at speed 4. */
const corridorMaze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "Long corridor",
  blocks: [".".repeat(32)],
  start: { column: 0, row: 0, heading: "east" },
  goals: [{ column: 31, row: 0 }],
};

/** Opens the page of a robot. @returns it when it is connected */
async function openPage(origin: string, registration: Registration, maze: MazeDocument) {
  const opened = startSimulatedPage(origin, registration, maze);
  await expect.poll(() => opened.robot.isConnected, { timeout: 30_000 }).toBe(true);
  return opened;
}

const addressOf = (origin: string, { id, driverKey }: Registration): string =>
  `${origin}/r/${id}#${driverKey}`;

/** Runs a program's script in every maze. @returns the last printed lines, and the lost connections */
async function compare(language: CodeLanguage, origin: string, { figure, program }: PaperProgram) {
  const registration = await registerRobot(origin, fetch);
  const script = await ProgramScript.write(language, addressOf(origin, registration), program);
  onTestFinished(() => script.close());
  const { page } = await openPage(origin, registration, thesisMazes.tree);
  page.setSpeed("max");
  const sentences: (string | null)[] = [];
  for (const maze of Object.values(thesisMazes)) {
    page.editMaze(maze);
    const { difference, sentence } = await script.compareIn(maze);
    expect(difference, `figure ${figure} in ${maze.name}`).toBeNull();
    sentences.push(sentence);
  }
  return { sentences, cuts: script.cuts };
}

it.for(codeLanguages)(
  "scripts in %s drive the paths of the programs of the thesis through lost connections",
  { timeout: 600_000 },
  async (language, { skip }) => {
    const missing = missingProgram(language);
    if (missing !== undefined) {
      process.stderr.write(
        `code-export.test.ts: skipped ${language}, ${missing} is not installed\n`,
      );
    }
    skip(missing !== undefined);
    const relay = await startRelayProcess();
    // Scripts mostly wait, so they run at the same time.
    const programs = await Promise.all(
      paperPrograms.map((program) => compare(language, relay.url, program)),
    );
    expect(programs.flatMap(({ sentences }) => sentences)).toContain(GOAL);
    expect(programs.reduce((sum, { cuts }) => sum + cuts, 0)).toBeGreaterThan(10);
  },
);

it(
  "a script that was silent for so long that the robot stopped continues on the path",
  { timeout: 120_000 },
  async () => {
    const { url: origin, port } = await startRelayProcess();
    const registration = await registerRobot(origin, fetch);
    const address = addressOf(origin, registration);
    const { robot, page } = await openPage(origin, registration, corridorMaze);
    page.setSpeed(4);
    const random = new SeededRandom(1);
    const network = await FaultProxy.start({ target: () => port, random });
    onTestFinished(() => network.close());
    const program = emptyProgram();
    const code = programCode(program, "python", address.replace(origin, network.origin));
    if (!code.ok) throw new Error("no code");
    const running = runScript([...(await runtimes.python.start("-c")), code.text]);
    await expect.poll(() => robot.isMoving, { timeout: 30_000 }).toBe(true);
    network.breakFor(4_500);
    const { lines, end } = await running;
    expect(end).toEqual({ sentence: GOAL, code: 0 });
    const records = await recordsAfter(address, 0);
    expect(records.map(({ state }) => state)).toEqual(["completed", "cancelled", "completed"]);
    const decisions = lines.map((label, at) => ({
      line: lineOf(label),
      pose: records[at]?.pose as Pose,
    }));
    expect(new ProgramPath(corridorMaze, program).firstDifference(decisions)).toBeNull();
  },
);
