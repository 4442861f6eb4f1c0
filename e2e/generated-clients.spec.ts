/** Clients that well-known generators create from `/openapi.json` of a running relay. */
import { spawnSync } from "node:child_process";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { delimiter, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { NotInstallableError, requireEnvironment } from "../scripts/python.ts";
import { expect, test } from "./fixtures.ts";

const HERE = fileURLToPath(new URL("generated-clients/", import.meta.url));
const require = createRequire(import.meta.url);

interface OpenApiDocument {
  paths: Record<string, Record<string, { operationId?: string }>>;
}

let folder = "";
test.beforeEach(async () => {
  folder = await mkdtemp(join(tmpdir(), "corridor-clients-"));
});
test.afterEach(() => rm(folder, { recursive: true }));

async function operationsAt(relay: string): Promise<string[]> {
  const { paths } = (await (await fetch(`${relay}/openapi.json`)).json()) as OpenApiDocument;
  const operations = Object.values(paths).flatMap((path) => Object.values(path));
  return operations.flatMap(({ operationId }) => operationId ?? []).sort();
}

function run(command: string, args: string[], environment: NodeJS.ProcessEnv = {}) {
  const options = { encoding: "utf8", env: { ...process.env, ...environment } } as const;
  const { status, stdout, stderr } = spawnSync(command, args, options);
  return { status, stdout, output: stdout + stderr };
}

test("openapi-python-client generates a client without a warning, and every operation imports", async ({
  relay,
}) => {
  test.setTimeout(300_000);
  const python = pythonOrSkip();
  const client = join(folder, "corridor_client");
  const options = ["--url", `${relay}/openapi.json`, "--output-path", client, "--meta", "none"];
  const generated = run(python, ["-m", "openapi_python_client", "generate", ...options], {
    COLUMNS: "500",
    // It runs a formatter from the same folder.
    PATH: `${dirname(python)}${delimiter}${process.env["PATH"]}`,
    NO_COLOR: "1",
  });
  expect(generated.output.trim()).toBe(`Generating ${client}`);
  expect(generated.status).toBe(0);
  const imported = run(python, [join(HERE, "import_all.py"), client]);
  expect(imported.output).not.toContain("Error");
  const snakeCase = (name: string) => name.replaceAll(/[A-Z]/g, (c) => `_${c.toLowerCase()}`);
  const operations = await operationsAt(relay);
  expect(imported.stdout.trim().split("\n").sort()).toEqual(operations.map(snakeCase).sort());
});

test("openapi-typescript generates types without a warning, and every operation compiles", async ({
  relay,
}) => {
  test.setTimeout(120_000);
  const types = join(folder, "corridor.ts");
  const command = join(require.resolve("openapi-typescript/package.json"), "../bin/cli.js");
  const generated = run(process.execPath, [command, `${relay}/openapi.json`, "--output", types]);
  expect(generated.output).not.toMatch(/warn|error|⚠|✘/i);
  expect(generated.status).toBe(0);
  const operations = await operationsAt(relay);
  const uses = operations.map((name) => `  operations["${name}"]["responses"],`).join("\n");
  await writeFile(
    join(folder, "use.ts"),
    `import type { components, operations } from "./corridor.ts";
export type All = [
${uses}
];
export const order: components["schemas"]["Order"] = { action: "move", distance: 100 };
// @ts-expect-error: a move needs a distance
export const wrong: components["schemas"]["Order"] = { action: "move" };
`,
  );
  const compiler = require.resolve("typescript/bin/tsc");
  const checked = run(process.execPath, [
    compiler,
    "--noEmit",
    "--strict",
    "--allowImportingTsExtensions",
    "--module",
    "preserve",
    join(folder, "use.ts"),
  ]);
  expect(checked.output).toBe("");
});

/** The Python environment with the generator. Skips the test where it cannot be installed. */
function pythonOrSkip(): string {
  try {
    return requireEnvironment("openapi-python-client", join(HERE, "requirements.txt"), 11);
  } catch (error) {
    if (error instanceof NotInstallableError) test.skip(true, error.message);
    throw error;
  }
}
