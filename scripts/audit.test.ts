import { expect, it } from "vitest";
import { parseAuditReport } from "./audit.ts";

const counts = { info: 0, low: 0, moderate: 0, high: 0, critical: 0, total: 0 };
const vulnerability = (severity: string) => ({ severity, via: [], effects: [], range: "<1.2.3" });

it.each([
  ["no vulnerability", {}, "passed"],
  ["low and moderate", { a: vulnerability("low"), b: vulnerability("moderate") }, "passed"],
  ["one rated high", { a: vulnerability("low"), b: vulnerability("high") }, "failed"],
  ["one rated critical", { c: vulnerability("critical") }, "failed"],
])("rates a report by its worst vulnerability: %s", (_, vulnerabilities, verdict) => {
  const report = { auditReportVersion: 2, vulnerabilities, metadata: { vulnerabilities: counts } };
  expect(parseAuditReport(JSON.stringify(report)).verdict).toBe(verdict);
});

it("names the packages that fail the audit", () => {
  const vulnerabilities = { fine: vulnerability("low"), bad: vulnerability("high") };
  const report = { vulnerabilities, metadata: { vulnerabilities: counts } };
  expect(parseAuditReport(JSON.stringify(report)).message).toMatch(/^bad \(high\)/);
});

it.each([
  ["the registry rejects the request", '{"message":"405 Method Not Allowed","statusCode":405}'],
  ["npm reports an error", '{"error":{"code":"ENOLOCK","summary":"no lockfile"}}'],
  ["npm prints nothing", ""],
])("is unknown when %s", (_, report) => {
  expect(parseAuditReport(report).verdict).toBe("unknown");
});

it("fails when npm prints malformed JSON", () => {
  expect(parseAuditReport('{"vulnerabilities":{"bad":').verdict).toBe("failed");
});
