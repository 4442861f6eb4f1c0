/** Known vulnerabilities in the project's dependencies, as `npm audit` reports them. */
import { spawnSync } from "node:child_process";

export interface Audit {
  /** unknown: the registry offers no audit, or is unreachable */
  verdict: "passed" | "failed" | "unknown";
  message: string;
}

/** An unreachable registry delays the tests by at most 30 s. */
const AUDIT_OPTIONS = ["--json", "--fetch-timeout=30000", "--fetch-retries=0"];
const MAX_REPORT_BYTES = 64 * 1024 * 1024;

/** Runs `npm audit`. Vulnerabilities rated high or critical fail the audit. */
export function audit(): Audit {
  const { stdout } = spawnSync("npm", ["audit", ...AUDIT_OPTIONS], {
    encoding: "utf8",
    maxBuffer: MAX_REPORT_BYTES,
    shell: process.platform === "win32",
  });
  return parseAuditReport(stdout);
}

/** @param report the output of `npm audit --json` */
export function parseAuditReport(report: string): Audit {
  if (report === "") return { verdict: "unknown", message: "No audit: npm printed nothing." };
  const parsed = parseJson(report);
  if (parsed === null) {
    return { verdict: "failed", message: `npm audit did not print a report:\n${report}` };
  }
  const { metadata, vulnerabilities = {}, message, error } = parsed;
  if (metadata?.vulnerabilities === undefined) {
    const reason = message ?? error?.summary ?? "npm gave no reason.";
    return { verdict: "unknown", message: `No audit: ${reason}` };
  }
  const severe = Object.entries(vulnerabilities)
    .filter(([, { severity }]) => severity === "high" || severity === "critical")
    .map(([name, { severity }]) => `${name} (${severity})`);
  if (severe.length === 0) {
    return { verdict: "passed", message: "No known vulnerability is rated high or critical." };
  }
  return { verdict: "failed", message: `${severe.join(", ")}: run \`npm audit\` for details.` };
}

interface Report {
  metadata?: { vulnerabilities?: object };
  vulnerabilities?: Record<string, { severity: string }>;
  /** The registry's error message; present instead of a report. */
  message?: string;
  error?: { summary?: string };
}

function parseJson(report: string): Report | null {
  try {
    return JSON.parse(report) as Report;
  } catch {
    return null;
  }
}
