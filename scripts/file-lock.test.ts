import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { expect, it, onTestFinished } from "vitest";
import { withFileLock } from "./file-lock.ts";

function lockFile(): string {
  const folder = mkdtempSync(join(tmpdir(), "corridor-lock-"));
  onTestFinished(() => rmSync(folder, { recursive: true }));
  return join(folder, "cache", "environment.lock");
}

it("is held during the work, also where the work fails", () => {
  const file = lockFile();
  expect(withFileLock(file, () => readFileSync(file, "utf8"))).toBe(String(process.pid));
  expect(existsSync(file)).toBe(false);
  const fail = (): never => {
    throw new Error("no space");
  };
  expect(() => withFileLock(file, fail)).toThrow("no space");
  expect(existsSync(file)).toBe(false);
});

it("is taken from a process that ended", () => {
  const file = lockFile();
  withFileLock(file, () => undefined);
  // No system has processes with this number.
  writeFileSync(file, "2147483647");
  expect(withFileLock(file, () => "done")).toBe("done");
});
