/** Finds Python, and creates virtual environments for the Python packages that the tests need. */
import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { withFileLock } from "./file-lock.ts";
import { inPath, run, tryInstall } from "./programs.ts";

const ROOT = join(import.meta.dirname, "..");
const PACKAGE = join(ROOT, "packages/client-python");
const REQUIREMENTS = join(PACKAGE, "tests/requirements.txt");
const ENVIRONMENTS = join(ROOT, "node_modules/.cache");
/** File in each environment that stores the requirements it was created for. */
const STAMP = "created-for.txt";

/**
 * A Python tool cannot be installed: Python or venv is missing, or no package index is reachable.
 */
export class NotInstallableError extends Error {
  override readonly name = "NotInstallableError";
}

/** The command that runs the tests of the Python package. */
export const pythonTests: readonly string[] = [pythonOf("python"), "-m", "pytest", PACKAGE];

/** @throws Error with installation instructions, if Python is missing and cannot be installed */
export function requirePython(): void {
  if (inPath("python3").length === 0) tryInstall("python3", "python3-venv");
  if (inPath("python3").length === 0) {
    throw new Error("The tests drive the page from a Python script: install Python 3.9 or newer.");
  }
}

/** Provides an environment with pytest and mypy. @throws Error as `requireEnvironment` does */
export function requirePythonTools(): void {
  requirePython();
  requireEnvironment("python", REQUIREMENTS);
}

/**
 * Provides a virtual environment. Recreates it when the requirements or the Python version change.
 * @param name the environment's folder in node_modules/.cache
 * @param requirements path of the pip requirements file
 * @param minMinor the oldest minor version of Python 3 that the requirements support
 * @returns the path of the environment's Python
 * @throws NotInstallableError with what is missing and how to install it
 * @throws Error if the package index is reachable and pip fails
 */
export function requireEnvironment(name: string, requirements: string, minMinor = 9): string {
  const folder = join(ENVIRONMENTS, name);
  const python = pythonOf(name);
  const stamp = join(folder, STAMP);
  const expected = `${readFileSync(requirements, "utf8")}\n${pythonVersion()}`;
  const isCurrent = (): boolean => existsSync(stamp) && readFileSync(stamp, "utf8") === expected;
  if (isCurrent()) return python;
  if (Number(/^Python 3\.(\d+)/.exec(pythonVersion())?.[1] ?? 0) < minMinor) {
    throw new NotInstallableError(`The tests need Python 3.${minMinor} or newer (${name}).`);
  }
  // Test files run beside each other, and some share an environment.
  return withFileLock(`${folder}.lock`, () => {
    if (!isCurrent()) buildEnvironment(folder, python, requirements);
    writeFileSync(stamp, expected);
    return python;
  });
}

/** @throws Error as `requireEnvironment` does */
function buildEnvironment(folder: string, python: string, requirements: string): void {
  rmSync(folder, { recursive: true, force: true });
  if (!createEnvironment(folder) && !(tryInstall("python3-venv") && createEnvironment(folder))) {
    if (hasVenv())
      throw new Error("Python could not create an environment for the tests (see above).");
    throw new NotInstallableError(
      "Python cannot create an environment for the tests: install its module venv (on Debian and Ubuntu: apt-get install python3-venv).",
    );
  }
  if (!pip(python, "install", "--requirement", requirements)) {
    if (hasIndex(python)) {
      throw new Error(`pip could not install the packages in ${requirements} (see above).`);
    }
    throw new NotInstallableError(
      "pip could not reach a package index (see above). The tests need PyPI, or your own index (set PIP_INDEX_URL).",
    );
  }
}

function pip(python: string, ...args: string[]): boolean {
  return run(python, ["-m", "pip", "--quiet", "--disable-pip-version-check", ...args]);
}

/** Whether a package index is reachable, tested by downloading pip, which every index has. */
function hasIndex(python: string): boolean {
  const folder = mkdtempSync(join(tmpdir(), "corridor-pip-"));
  const isAvailable = pip(
    python,
    "download",
    "--retries",
    "1",
    "--no-deps",
    "--dest",
    folder,
    "pip",
  );
  rmSync(folder, { recursive: true });
  return isAvailable;
}

function hasVenv(): boolean {
  return run("python3", ["-c", "import ensurepip, venv"]);
}

function pythonOf(name: string): string {
  const own = process.platform === "win32" ? "Scripts/python.exe" : "bin/python";
  return join(ENVIRONMENTS, name, own);
}

function pythonVersion(): string {
  return spawnSync("python3", ["--version"], { encoding: "utf8" }).stdout;
}

function createEnvironment(folder: string): boolean {
  return run("python3", ["-m", "venv", "--clear", folder]);
}

if (import.meta.main) {
  try {
    requirePythonTools();
    const [command = "", ...args] = [...pythonTests, ...process.argv.slice(2)];
    process.exitCode = run(command, args) ? 0 : 1;
  } catch (error) {
    process.stderr.write(`${error instanceof Error ? error.message : String(error)}\n`);
    process.exitCode = 1;
  }
}
