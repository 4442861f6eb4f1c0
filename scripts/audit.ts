/** Known holes in what the project depends on, as the registry tells them to `npm audit`. */
import { spawnSync } from "node:child_process";

export interface Audit {
  /** unknown: the registry does not tell, or is not reached */
  verdict: "passed" | "failed" | "unknown";
  words: string;
}

/** Fails on what is rated high or critical. */
export function audit(): Audit {
  const { stdout } = spawnSync("npm", ["audit", "--json"], {
    encoding: "utf8",
    shell: process.platform === "win32",
  });
  return auditOf(stdout);
}

/** @param report what `npm audit --json` printed */
export function auditOf(report: string): Audit {
  const { metadata, vulnerabilities = {}, message } = read(report);
  if (metadata?.vulnerabilities === undefined)
    return { verdict: "unknown", words: `No audit: ${message ?? "npm printed no report"}` };
  const bad = Object.entries(vulnerabilities)
    .filter(([, { severity }]) => severity === "high" || severity === "critical")
    .map(([name, { severity }]) => `${name} (${severity})`);
  if (bad.length === 0) return { verdict: "passed", words: "Nothing rated high is known." };
  return { verdict: "failed", words: `${bad.join(", ")}: \`npm audit\` says what to do.` };
}

interface Report {
  metadata?: { vulnerabilities?: object };
  vulnerabilities?: Record<string, { severity: string }>;
  /** instead of a report */
  message?: string;
}

function read(report: string): Report {
  try {
    return JSON.parse(report) as Report;
  } catch {
    return {};
  }
}
