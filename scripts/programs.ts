/** Finds, installs and runs programs of this machine. */
import { spawnSync } from "node:child_process";
import { existsSync } from "node:fs";
import { delimiter, join } from "node:path";

/** @returns the files of this name on the search path */
export function inPath(name: string): string[] {
  const folders = (process.env["PATH"] ?? "").split(delimiter);
  return folders.map((folder) => join(folder, name)).filter((path) => existsSync(path));
}

/** Installs Debian packages; only as root, so without a password prompt. @returns whether it did */
export function tryInstall(...names: string[]): boolean {
  if (process.getuid?.() !== 0 || inPath("apt-get").length === 0) return false;
  return run("apt-get", ["update"]) && run("apt-get", ["install", "-y", ...names]);
}

/** Runs a program, prints its command and output. @returns whether it exited with code 0 */
export function run(command: string, args: string[]): boolean {
  process.stdout.write(`> ${command} ${args.join(" ")}\n`);
  return spawnSync(command, args, { stdio: "inherit" }).status === 0;
}
