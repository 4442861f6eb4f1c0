/** Packs a built package and runs commands in an empty folder outside of the repository. */
import { spawnSync } from "node:child_process";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { delimiter, join } from "node:path";
import { fileURLToPath } from "node:url";
import { expect } from "playwright/test";

const ROOT = fileURLToPath(new URL("../../", import.meta.url));
/** The environment of a user, without the programs of the repository. */
export const userEnvironment = {
  ...process.env,
  PATH: (process.env["PATH"] ?? "")
    .split(delimiter)
    .filter((folder) => !folder.startsWith(ROOT))
    .join(delimiter),
  FORCE_COLOR: "0",
};

export interface Output {
  code: number | null;
  stdout: string;
  stderr: string;
}

export interface Packed {
  /** file name of the package */
  tarball: string;
  /** the files in it */
  files: string[];
}

export class EmptyFolder {
  readonly path: string;

  private constructor(path: string) {
    this.path = path;
  }

  static async create(): Promise<EmptyFolder> {
    return new EmptyFolder(await mkdtemp(join(tmpdir(), "corridor-installed-")));
  }

  async remove(): Promise<void> {
    await rm(this.path, { recursive: true });
  }

  async write(name: string, text: string): Promise<void> {
    await writeFile(join(this.path, name), text);
  }

  /** Runs a command, which must succeed. @returns its standard output */
  run(command: string, ...args: string[]): string {
    const { code, stdout, stderr } = this.try(command, ...args);
    expect(code, `${command} ${args.join(" ")}\n${stdout}${stderr}`).toBe(0);
    return stdout;
  }

  try(command: string, ...args: string[]): Output {
    const { status, stdout, stderr } = spawnSync(command, args, {
      cwd: this.path,
      encoding: "utf8",
      env: userEnvironment,
    });
    return { code: status, stdout, stderr };
  }

  /** Packs a built package. */
  pack(built: string): Packed {
    const [packed] = JSON.parse(this.run("npm", "pack", "--json", built));
    return {
      tarball: packed.filename,
      files: packed.files.map(({ path }: { path: string }) => path),
    };
  }

  /** Packs and installs a built package. */
  async install(built: string): Promise<Packed> {
    await this.write("package.json", "{}");
    const packed = this.pack(built);
    this.run("npm", "install", "--no-audit", "--no-fund", packed.tarball);
    return packed;
  }
}
