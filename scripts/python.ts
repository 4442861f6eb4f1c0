/** Finds Python, and makes environments of their own for what tests need of it. */
import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { inPath, run, tryInstall } from "./programs.ts";

const ROOT = join(import.meta.dirname, "..");
const PACKAGE = join(ROOT, "packages/client-python");
const REQUIREMENTS = join(PACKAGE, "tests/requirements.txt");
const ENVIRONMENTS = join(ROOT, "node_modules/.cache");
/** holds the requirements that an environment was made for */
const MARK = "made-for.txt";

/** This machine cannot have a Python tool: it lacks Python or venv, or no package index answers. */
export class NotInstallableError extends Error {
  override readonly name = "NotInstallableError";
}

/** The command that runs the tests of the Python package. */
export const pythonTests: readonly string[] = [programOf("python"), "-m", "pytest", PACKAGE];

/** @throws Error that says what to install, where there is no Python and none can be installed */
export function requirePython(): void {
  if (inPath("python3").length === 0) tryInstall("python3", "python3-venv");
  if (inPath("python3").length === 0) {
    throw new Error("The tests drive the page from a Python script: install Python 3.9 or newer.");
  }
}

/** Has an environment with pytest and mypy. @throws Error as `requireEnvironment` does */
export function requirePythonTools(): void {
  requirePython();
  requireEnvironment("python", REQUIREMENTS);
}

/**
 * Has an environment, made anew when the wanted versions or Python have changed.
 * @param requirements the file that names what is in it
 * @param minor the oldest version of Python 3 that can run it
 * @returns the path of its Python
 * @throws NotInstallableError that says what is missing and how to get it
 * @throws Error where pip has all that it needs, and fails
 */
export function requireEnvironment(name: string, requirements: string, minor = 9): string {
  const folder = join(ENVIRONMENTS, name);
  const python = programOf(name);
  const mark = join(folder, MARK);
  const wanted = `${readFileSync(requirements, "utf8")}\n${pythonVersion()}`;
  if (existsSync(mark) && readFileSync(mark, "utf8") === wanted) return python;
  if (Number(/^Python 3\.(\d+)/.exec(pythonVersion())?.[1] ?? 0) < minor) {
    throw new NotInstallableError(`The tests need Python 3.${minor} or newer (${name}).`);
  }
  rmSync(folder, { recursive: true, force: true });
  if (!makeEnvironment(folder) && !(tryInstall("python3-venv") && makeEnvironment(folder))) {
    if (hasVenv())
      throw new Error("Python could not make an environment for the tests (see above).");
    throw new NotInstallableError(
      "Python cannot make an environment for the tests: install its module venv (on Debian and Ubuntu: apt-get install python3-venv).",
    );
  }
  if (!pip(python, "install", "--requirement", requirements)) {
    if (hasIndex(python)) {
      throw new Error(`pip could not install what ${requirements} names (see above).`);
    }
    throw new NotInstallableError(
      "pip could not install what the tests need (see above): it needs PyPI, or an index of your own (PIP_INDEX_URL).",
    );
  }
  writeFileSync(mark, wanted);
  return python;
}

function pip(python: string, ...words: string[]): boolean {
  return run(python, ["-m", "pip", "--quiet", "--disable-pip-version-check", ...words]);
}

/** Whether a package index answers: every one has pip itself. */
function hasIndex(python: string): boolean {
  const folder = mkdtempSync(join(tmpdir(), "corridor-pip-"));
  const isThere = pip(python, "download", "--retries", "1", "--no-deps", "--dest", folder, "pip");
  rmSync(folder, { recursive: true });
  return isThere;
}

function hasVenv(): boolean {
  return run("python3", ["-c", "import ensurepip, venv"]);
}

function programOf(name: string): string {
  const own = process.platform === "win32" ? "Scripts/python.exe" : "bin/python";
  return join(ENVIRONMENTS, name, own);
}

function pythonVersion(): string {
  return spawnSync("python3", ["--version"], { encoding: "utf8" }).stdout;
}

function makeEnvironment(folder: string): boolean {
  return run("python3", ["-m", "venv", "--clear", folder]);
}

if (import.meta.main) {
  try {
    requirePythonTools();
    const [command = "", ...words] = [...pythonTests, ...process.argv.slice(2)];
    process.exitCode = run(command, words) ? 0 : 1;
  } catch (error) {
    process.stderr.write(`${error instanceof Error ? error.message : String(error)}\n`);
    process.exitCode = 1;
  }
}
