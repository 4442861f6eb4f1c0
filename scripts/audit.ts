/** Known holes in what the project depends on, as the registry tells them to `npm audit`. */
import { spawnSync } from "node:child_process";

export interface Audit {
  /** unknown: the registry does not tell, or is not reached */
  verdict: "passed" | "failed" | "unknown";
  words: string;
}

/** A registry that does not answer holds nobody up for long, and no report is too long. */
const OPTIONS = ["--json", "--fetch-timeout=30000", "--fetch-retries=0"];
const MOST_BYTES = 64 * 1024 * 1024;

/** Fails on what is rated high or critical. */
export function audit(): Audit {
  const { stdout } = spawnSync("npm", ["audit", ...OPTIONS], {
    encoding: "utf8",
    maxBuffer: MOST_BYTES,
    shell: process.platform === "win32",
  });
  return auditOf(stdout);
}

/** @param report what `npm audit --json` printed */
export function auditOf(report: string): Audit {
  if (report === "") return { verdict: "unknown", words: "No audit: npm printed nothing." };
  const read = reportIn(report);
  if (read === null) return { verdict: "failed", words: `This is no report:\n${report}` };
  const { metadata, vulnerabilities = {}, message, error } = read;
  if (metadata?.vulnerabilities === undefined) {
    const why = message ?? error?.summary ?? "npm does not say why.";
    return { verdict: "unknown", words: `No audit: ${why}` };
  }
  const bad = Object.entries(vulnerabilities)
    .filter(([, { severity }]) => severity === "high" || severity === "critical")
    .map(([name, { severity }]) => `${name} (${severity})`);
  if (bad.length === 0) return { verdict: "passed", words: "Nothing rated high is known." };
  return { verdict: "failed", words: `${bad.join(", ")}: \`npm audit\` says what to do.` };
}

interface Report {
  metadata?: { vulnerabilities?: object };
  vulnerabilities?: Record<string, { severity: string }>;
  /** instead of a report: why there is none */
  message?: string;
  error?: { summary?: string };
}

function reportIn(report: string): Report | null {
  try {
    return JSON.parse(report) as Report;
  } catch {
    return null;
  }
}
