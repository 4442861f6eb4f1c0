/** `npm run conformance -- "ADDRESS"`: whether a robot's host does all that scripts rely on. */
import { groups, runChecks, type Result } from "./run-checks.ts";

const [address] = process.argv.slice(2);
if (address === undefined) {
  fail('Give the robot\'s address: npm run conformance -- "http://HOST/r/ID#KEY"', 2);
}

const count = groups.reduce((sum, { checks }) => sum + checks.length, 0);
let group = "";
process.stdout.write(
  `${count} checks of ${address.split("#")[0]}. The robot will turn and drive: give it room.\n`,
);
try {
  const results = await runChecks(address, tell);
  const of = (kind: string): number =>
    results.filter(({ outcome }) => outcome.kind === kind).length;
  const unseen = of("not seen");
  const more = unseen > 0 ? `, ${unseen} not seen` : "";
  process.stdout.write(`\n${of("passed")} passed, ${of("failed")} failed${more}\n`);
  process.exitCode = of("failed") > 0 ? 1 : 0;
} catch (error) {
  fail(error instanceof Error ? error.message : String(error), 2);
}

function tell(result: Result): void {
  if (result.group !== group) {
    group = result.group;
    process.stdout.write(`\n${group}\n`);
  }
  const { outcome } = result;
  const mark = { passed: "  ok    ", "not seen": "  -     ", failed: "  FAILED" }[outcome.kind];
  process.stdout.write(`${mark} ${result.check}\n`);
  if (outcome.kind === "not seen") process.stdout.write(`         ${outcome.why}\n`);
  if (outcome.kind !== "failed") return;
  process.stdout.write(`         expected: ${outcome.expected}\n`);
  process.stdout.write(`         found:    ${outcome.found}\n`);
}

function fail(sentence: string, code: number): never {
  process.stderr.write(`${sentence}\n`);
  process.exit(code);
}
