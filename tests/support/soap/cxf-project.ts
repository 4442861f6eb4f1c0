/** A Maven project in which Apache CXF generates a client in Java: that of the documentation. */
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { onTestFinished } from "vitest";
import { runMaven } from "../maven.ts";

const page = fileURLToPath(
  new URL("../../../apps/relay/src/site/docs/pages/quickstart.md", import.meta.url),
);

/**
 * Runs a class of the default package with the generated client.
 * @param name of the class
 * @param source its text
 * @param properties of Maven, with `wsdl`
 * @returns what it prints
 */
export async function runWithCxf(
  name: string,
  source: string,
  properties: Record<string, string>,
): Promise<string> {
  const [, pom] = /^```xml\n(<project .*?)^```$/ms.exec(readFileSync(page, "utf8")) ?? [];
  if (pom === undefined) throw new Error("the documentation contains no pom.xml");
  const folder = mkdtempSync(join(tmpdir(), "corridor-cxf-"));
  onTestFinished(() => rmSync(folder, { recursive: true, force: true }));
  const sources = join(folder, "src/main/java");
  mkdirSync(sources, { recursive: true });
  writeFileSync(join(sources, `${name}.java`), source);
  writeFileSync(join(folder, "pom.xml"), pom);
  return runMaven(join(folder, "pom.xml"), { "exec.mainClass": name, ...properties });
}
