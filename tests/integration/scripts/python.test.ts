/** Tests that skip may do so only if a Python tool cannot be installed, not if it is broken. */
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { describe, expect, it, onTestFinished, vi } from "vitest";
import { run } from "../../../scripts/programs.ts";
import { NotInstallableError, requireEnvironment } from "../../../scripts/python.ts";

/** Python script that writes the wheel of an empty package named pip. */
const WHEEL = `
import sys, zipfile
with zipfile.ZipFile(sys.argv[1] + "/pip-99-py3-none-any.whl", "w") as wheel:
    wheel.writestr("pip-99.dist-info/METADATA", "Metadata-Version: 2.1\\nName: pip\\nVersion: 99\\n")
    wheel.writestr("pip-99.dist-info/WHEEL", "Wheel-Version: 1.0\\nTag: py3-none-any\\n")
    wheel.writestr("pip-99.dist-info/RECORD", "")
`;

function scratchFolder(): string {
  const folder = mkdtempSync(join(tmpdir(), "corridor-python-"));
  onTestFinished(() => rmSync(folder, { recursive: true }));
  return folder;
}

/** Requires a package that does not exist. @returns the error */
function installError(environment: Record<string, string>): unknown {
  for (const [name, value] of Object.entries(environment)) vi.stubEnv(name, value);
  onTestFinished(() => void vi.unstubAllEnvs());
  const name = "test-of-a-missing-package";
  const requirements = join(scratchFolder(), "requirements.txt");
  writeFileSync(requirements, "corridor-has-no-such-package==1.0\n");
  onTestFinished(() =>
    rmSync(join(import.meta.dirname, "../../../node_modules/.cache", name), { recursive: true }),
  );
  try {
    return requireEnvironment(name, requirements);
  } catch (error) {
    return error;
  }
}

describe("a Python tool", () => {
  it("is not installable when no package index is reachable", () => {
    const unreachable = "http://127.0.0.1:9/simple";
    const error = installError({
      PIP_INDEX_URL: unreachable,
      PIP_EXTRA_INDEX_URL: "",
      PIP_RETRIES: "0",
    });
    expect(error).toBeInstanceOf(NotInstallableError);
    expect(error).toMatchObject({ message: expect.stringContaining("PIP_INDEX_URL") as string });
  });

  it("is broken when a reachable index lacks a required package", () => {
    const index = scratchFolder();
    expect(run("python3", ["-c", WHEEL, index])).toBe(true);
    const error = installError({ PIP_NO_INDEX: "1", PIP_FIND_LINKS: index });
    expect(error).toBeInstanceOf(Error);
    expect(error).not.toBeInstanceOf(NotInstallableError);
    expect(error).toMatchObject({ message: expect.stringContaining("requirements.txt") as string });
  });
});
