/** Runs Maven, for clients in Java that generators create from descriptions of a running relay. */
import { execFile } from "node:child_process";
import { promisify, stripVTControlCharacters } from "node:util";
import { inPath } from "../../scripts/programs.ts";
import { shortRunOptions } from "./java.ts";

const execute = promisify(execFile);

/** Java, Maven or what Maven downloads is missing here. The message is the reason to skip a test. */
class MavenMissingError extends Error {}

/** @throws MavenMissingError without Java or Maven */
function requireMaven(): void {
  const missing = ["java", "mvn"].find((program) => inPath(program).length === 0);
  if (missing !== undefined) throw new MavenMissingError(`there is no ${missing} here`);
}

/**
 * Compiles the project of a `pom.xml` and runs its main class.
 * @returns the standard output of Maven and of the program
 * @throws MavenMissingError if Maven cannot download its dependencies
 */
export async function runMaven(pom: string, properties: Record<string, string>): Promise<string> {
  const defined = Object.entries(properties).flatMap(([name, value]) => [
    "--define",
    `${name}=${value}`,
  ]);
  const options = ["--quiet", "--batch-mode", `--file=${pom}`];
  try {
    const goals = ["compile", "exec:java"];
    const { stdout } = await execute("mvn", [...options, ...goals, ...defined], {
      env: { ...process.env, MAVEN_OPTS: shortRunOptions.join(" ") },
      maxBuffer: 2 ** 26,
    });
    return stripVTControlCharacters(stdout);
  } catch (error) {
    const output = error instanceof Error && "stdout" in error ? String(error.stdout) : "";
    if (/Could not (?:resolve|transfer|find artifact)/.test(output)) {
      throw new MavenMissingError("Maven cannot download what the client needs here");
    }
    throw new Error(output, { cause: error });
  }
}

/** Skips a test without Java, Maven or downloads. */
export async function skipWithoutMaven(
  skip: (reason: string) => never,
  test: () => Promise<void>,
): Promise<void> {
  try {
    requireMaven();
    await test();
  } catch (error) {
    if (error instanceof MavenMissingError) skip(error.message);
    throw error;
  }
}
