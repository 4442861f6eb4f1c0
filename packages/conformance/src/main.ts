/**
 * `npm run conformance -- "ADDRESS"`: checks that the host of a robot implements everything that
 * scripts rely on.
 */
import { linesOf, passes, verdict } from "./report.ts";
import { groups, runChecks, type Result } from "./run-checks.ts";

const [address] = process.argv.slice(2);
if (address === undefined) {
  fail('Give the robot\'s address: npm run conformance -- "http://HOST/r/ID#KEY"', 2);
}

const count = groups.reduce((sum, { checks }) => sum + checks.length, 0);
let group = "";
process.stdout.write(
  `${count} checks of ${address.split("#")[0]}. The robot drives, in the pen of docs/conformance.md.\n`,
);
try {
  const results = await runChecks(address, { onResult: print });
  const date = new Date().toISOString().slice(0, 10);
  process.stdout.write(`\n${verdict(results, date)}\n`);
  process.exitCode = passes(results) ? 0 : 1;
} catch (error) {
  fail(error instanceof Error ? error.message : String(error), 2);
}

function print(result: Result): void {
  if (result.group !== group) {
    group = result.group;
    process.stdout.write(`\n${group}\n`);
  }
  process.stdout.write(`${linesOf(result).join("\n")}\n`);
}

function fail(message: string, code: number): never {
  process.stderr.write(`${message}\n`);
  process.exit(code);
}
