/** Finds Python, and makes environments of their own for what tests need of it. */
import { spawnSync } from "node:child_process";
import { existsSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { inPath, run, tryInstall } from "./programs.ts";

const ROOT = join(import.meta.dirname, "..");
const PACKAGE = join(ROOT, "packages/client-python");
const REQUIREMENTS = join(PACKAGE, "tests/requirements.txt");
const ENVIRONMENTS = join(ROOT, "node_modules/.cache");
/** holds the requirements that an environment was made for */
const MARK = "made-for.txt";

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
 * @returns the path of its Python
 * @throws Error that says what is missing and how to get it
 */
export function requireEnvironment(name: string, requirements: string): string {
  const folder = join(ENVIRONMENTS, name);
  const python = programOf(name);
  const mark = join(folder, MARK);
  const wanted = `${readFileSync(requirements, "utf8")}\n${pythonVersion()}`;
  if (existsSync(mark) && readFileSync(mark, "utf8") === wanted) return python;
  rmSync(folder, { recursive: true, force: true });
  if (!makeEnvironment(folder) && !(tryInstall("python3-venv") && makeEnvironment(folder))) {
    throw new Error(
      "Python cannot make an environment for the tests: install its module venv (on Debian and Ubuntu: apt-get install python3-venv).",
    );
  }
  const install = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check"];
  if (!run(python, [...install, "--requirement", requirements])) {
    throw new Error(
      "pip could not install what the tests need (see above): it needs PyPI, or an index of your own (PIP_INDEX_URL).",
    );
  }
  writeFileSync(mark, wanted);
  return python;
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
