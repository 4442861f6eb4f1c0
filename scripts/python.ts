/** Finds Python, and makes an environment of its own for what the tests of the Python package need. */
import { spawnSync } from "node:child_process";
import { existsSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { inPath, run, tryInstall } from "./programs.ts";

const ROOT = join(import.meta.dirname, "..");
const PACKAGE = join(ROOT, "packages/client-python");
const REQUIREMENTS = join(PACKAGE, "tests/requirements.txt");
const ENVIRONMENT = join(ROOT, "node_modules/.cache/python");
/** holds the requirements that the environment was made for */
const MARK = join(ENVIRONMENT, "made-for.txt");
const OWN_PYTHON = join(
  ENVIRONMENT,
  process.platform === "win32" ? "Scripts/python.exe" : "bin/python",
);

/** The command that runs the tests of the Python package. */
export const pythonTests: readonly string[] = [OWN_PYTHON, "-m", "pytest", PACKAGE];

/** @throws Error that says what to install, where there is no Python and none can be installed */
export function requirePython(): void {
  if (inPath("python3").length === 0) tryInstall("python3", "python3-venv");
  if (inPath("python3").length === 0) {
    throw new Error("The tests drive the page from a Python script: install Python 3.9 or newer.");
  }
}

/**
 * Has an environment with pytest and mypy, made anew when the wanted versions or Python have changed.
 * @throws Error that says what is missing and how to get it
 */
export function requirePythonTools(): void {
  requirePython();
  const wanted = `${readFileSync(REQUIREMENTS, "utf8")}\n${pythonVersion()}`;
  if (existsSync(MARK) && readFileSync(MARK, "utf8") === wanted) return;
  rmSync(ENVIRONMENT, { recursive: true, force: true });
  if (!makeEnvironment() && !(tryInstall("python3-venv") && makeEnvironment())) {
    throw new Error(
      "Python cannot make an environment for the tests: install its module venv (on Debian and Ubuntu: apt-get install python3-venv).",
    );
  }
  const install = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check"];
  if (!run(OWN_PYTHON, [...install, "--requirement", REQUIREMENTS])) {
    throw new Error(
      "pip could not install pytest (see above): it needs PyPI, or an index of your own (PIP_INDEX_URL).",
    );
  }
  writeFileSync(MARK, wanted);
}

function pythonVersion(): string {
  return spawnSync("python3", ["--version"], { encoding: "utf8" }).stdout;
}

function makeEnvironment(): boolean {
  return run("python3", ["-m", "venv", "--clear", ENVIRONMENT]);
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
