/**
 * Requests that schemathesis makes up from `/openapi.json`, right and wrong ones: every answer is
 * as described.
 */
import { spawnSync } from "node:child_process";
import { fileURLToPath } from "node:url";
import { requireEnvironment, requirePython } from "../../../scripts/python.ts";
import { RelayProcess } from "../../support/relay-process.ts";
import type { Row, Terms } from "../row.ts";
import { Scene } from "../scene.ts";

const HERE = fileURLToPath(new URL("../openapi/", import.meta.url));
const ROBOTS = 12;
const CASES = { short: 10_000, long: 100_000 };
/**
 * of each call in a round, right and wrong ones; a round has some hundred cases more for every
 * bound of a field
 */
const EXAMPLES = 30;
const ROUND_MS = 300_000;

export const openApiFuzz: Row = {
  title: "OpenAPI fuzz",
  does: (isLong) =>
    `${(isLong ? CASES.long : CASES.short).toLocaleString("en")} requests by schemathesis to ${ROBOTS} robots with their pages, each from another address`,
  run: async (terms) => {
    requirePython();
    const python = requireEnvironment("schemathesis", `${HERE}requirements.txt`);
    const relay = await RelayProcess.start({ environment: { TRUSTED_PROXIES: "1" } });
    terms.after(() => relay.stop());
    const scene = new Scene(terms);
    await scene.register(relay.url, ROBOTS);
    const pages = await scene.startPages();
    for (const robot of scene.robots) scene.open(robot, pages, relay.url, "both");
    await scene.allConnected();
    const robots = JSON.stringify(scene.robots.map(({ session }) => session));
    const wanted = terms.isLong ? CASES.long : CASES.short;
    let cases = 0;
    let findings = 0;
    for (let round = 0; cases < wanted && findings === 0; round++) {
      const found = fuzz(python, relay.url, robots, terms.seed + round, terms);
      cases += found.cases;
      findings += found.findings;
    }
    return [
      { label: "cases", measured: cases, bound: { atLeast: wanted }, unit: "requests" },
      { label: "findings", measured: findings, bound: { atMost: 0 }, unit: "" },
      {
        label: "requests that the relay failed at, by its log",
        measured: relay.log.split("a request failed").length - 1,
        bound: { atMost: 0 },
        unit: "",
      },
    ];
  },
};

/** One round. What was found is shown. @throws Error when it did not come to its end */
function fuzz(python: string, url: string, robots: string, seed: number, terms: Terms) {
  const options = `--max-examples ${EXAMPLES} --seed ${seed} --continue-on-failure --generation-database none --warnings off --no-color`;
  const run = ["run", `${url}/openapi.json`, ...options.split(" ")];
  const { stdout, stderr } = spawnSync(python, ["-m", "schemathesis.cli", ...run], {
    cwd: terms.folder,
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
  if (findings > 0) terms.say(stdout);
  terms.say(`seed ${seed}: ${summary[0].replaceAll(/\s+/g, " ")}`);
  return { cases: Number(summary[1]), findings };
}
