import { expect, it } from "vitest";
import { auditOf } from "./audit.ts";

const counts = { info: 0, low: 0, moderate: 0, high: 0, critical: 0, total: 0 };
const hole = (severity: string) => ({ severity, via: [], effects: [], range: "<1.2.3" });

it.each([
  ["nothing is known", {}, "passed"],
  ["what is known is not bad", { a: hole("low"), b: hole("moderate") }, "passed"],
  ["something is rated high", { a: hole("low"), b: hole("high") }, "failed"],
  ["something is rated critical", { c: hole("critical") }, "failed"],
])("where %s", (_, vulnerabilities, verdict) => {
  const report = { auditReportVersion: 2, vulnerabilities, metadata: { vulnerabilities: counts } };
  expect(auditOf(JSON.stringify(report)).verdict).toBe(verdict);
});

it("names what is bad", () => {
  const vulnerabilities = { fine: hole("low"), bad: hole("high") };
  const report = { vulnerabilities, metadata: { vulnerabilities: counts } };
  expect(auditOf(JSON.stringify(report)).words).toMatch(/^bad \(high\)/);
});

it.each([
  ["the registry tells nothing", '{"message":"405 Method Not Allowed","statusCode":405}'],
  ["npm tells nothing", '{"error":{"code":"ENOLOCK","summary":"no lockfile"}}'],
  ["npm printed nothing", ""],
])("does not pass for good where %s", (_, report) => {
  expect(auditOf(report).verdict).toBe("unknown");
});

it("fails where npm printed something else", () => {
  expect(auditOf('{"vulnerabilities":{"bad":').verdict).toBe("failed");
});
