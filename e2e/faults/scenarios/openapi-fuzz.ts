/**
 * Valid and invalid requests that schemathesis generates from `/openapi.json`: every response is as
 * described.
 */
import { spawnSync } from "node:child_process";
import { fileURLToPath } from "node:url";
import { requireEnvironment, requirePython } from "../../../scripts/python.ts";
import { RelayProcess } from "../../../tests/support/relay-process.ts";
import type { Scenario, ScenarioContext } from "../scenario.ts";
import { TestBed } from "../test-bed.ts";

const HERE = fileURLToPath(new URL("../openapi/", import.meta.url));
const ROBOTS = 12;
const CASES = { short: 10_000, long: 100_000 };
/**
 * valid and invalid examples of each call in a round; a round has some hundred more for field
 * bounds
 */
const EXAMPLES = 30;
const ROUND_MS = 300_000;

export const openApiFuzz: Scenario = {
  title: "OpenAPI fuzz",
  describe: (isLong) =>
    `schemathesis sends ${(isLong ? CASES.long : CASES.short).toLocaleString("en")} requests to ${ROBOTS} robots with their pages, each from another address`,
  run: async (context) => {
    requirePython();
    const python = requireEnvironment("schemathesis", `${HERE}requirements.txt`);
    const relay = await RelayProcess.start({ environment: { TRUSTED_PROXIES: "1" } });
    context.onCleanup(() => relay.stop());
    const testBed = new TestBed(context);
    await testBed.register(relay.url, ROBOTS);
    const pages = await testBed.startPages();
    for (const robot of testBed.robots) testBed.open(robot, pages, relay.url, "both");
    await testBed.waitUntilConnected();
    const robots = JSON.stringify(testBed.robots.map(({ session }) => session));
    const count = context.isLong ? CASES.long : CASES.short;
    let cases = 0;
    let findings = 0;
    for (let round = 0; cases < count && findings === 0; round++) {
      const found = fuzz(python, relay.url, robots, context.seed + round, context);
      cases += found.cases;
      findings += found.findings;
    }
    return [
      { label: "cases", measured: cases, bound: { atLeast: count }, unit: "requests" },
      { label: "findings", measured: findings, bound: { atMost: 0 }, unit: "" },
      {
        label: "failed requests in the relay's log",
        measured: relay.log.split('"request failed"').length - 1,
        bound: { atMost: 0 },
        unit: "",
      },
    ];
  },
};

/** Runs one round and prints its findings. @throws Error when it did not finish */
function fuzz(python: string, url: string, robots: string, seed: number, context: ScenarioContext) {
  const options = `--max-examples ${EXAMPLES} --seed ${seed} --continue-on-failure --generation-database none --warnings off --no-color`;
  const run = ["run", `${url}/openapi.json`, ...options.split(" ")];
  const { stdout, stderr } = spawnSync(python, ["-m", "schemathesis.cli", ...run], {
    cwd: context.folder,
    encoding: "utf8",
    timeout: ROUND_MS,
    env: {
      ...process.env,
      PYTHONPATH: HERE,
      PYTHONDONTWRITEBYTECODE: "1",
      SCHEMATHESIS_HOOKS: "hooks",
      CORRIDOR_URL: url,
      CORRIDOR_ROBOTS: robots,
      CORRIDOR_SEED: String(seed),
    },
  });
  const summary = /Test cases:\s+(\d+) generated, (?:(\d+) found|\d+ passed)/.exec(stdout);
  if (summary === null) throw new Error(`schemathesis did not end: ${stdout}${stderr}`);
  const findings = Number(summary[2] ?? 0) + (stdout.includes(" ERRORS ") ? 1 : 0);
  if (findings > 0) context.log(stdout);
  context.log(`seed ${seed}: ${summary[0].replaceAll(/\s+/g, " ")}`);
  return { cases: Number(summary[1]), findings };
}
