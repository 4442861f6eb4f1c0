/** Programs on this machine, and how to get them. */
import { spawnSync } from "node:child_process";
import { existsSync } from "node:fs";
import { delimiter, join } from "node:path";

/** The files of this name on the search path. */
export function inPath(name: string): string[] {
  const folders = (process.env["PATH"] ?? "").split(delimiter);
  return folders.map((folder) => join(folder, name)).filter((path) => existsSync(path));
}

/** Installs packages of Debian where that can be done without asking. @returns whether it did */
export function tryInstall(...names: string[]): boolean {
  if (process.getuid?.() !== 0 || inPath("apt-get").length === 0) return false;
  return run("apt-get", ["update"]) && run("apt-get", ["install", "-y", ...names]);
}

/** Runs a program for all to see. @returns whether it ended well */
export function run(command: string, words: string[]): boolean {
  process.stdout.write(`> ${command} ${words.join(" ")}\n`);
  return spawnSync(command, words, { stdio: "inherit" }).status === 0;
}
