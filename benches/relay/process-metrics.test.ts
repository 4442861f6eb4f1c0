import { describe, expect, it } from "vitest";
import { parseProcessorMs, parseResidentKiB, processorMs, residentKiB } from "./process-metrics.ts";

describe("the metrics of a process", () => {
  it("include user and kernel time, even if the program's name contains brackets", () => {
    const text =
      "4711 (a (bad) name) S 1 4711 4711 0 -1 4194304 2563 0 12 0 345 67 0 0 20 0 11 0 99 1 2";
    expect(parseProcessorMs(text)).toBe(4120);
  });

  it("include the resident memory", () => {
    expect(parseResidentKiB("VmPeak:\t  900 kB\nVmRSS:\t   5120 kB\nRssAnon:\t 12 kB\n")).toBe(
      5120,
    );
    expect(parseResidentKiB("")).toBeNaN();
  });

  it.runIf(process.platform === "linux")("are read from a running process", () => {
    expect(processorMs(process.pid)).toBeGreaterThan(0);
    expect(residentKiB(process.pid)).toBeGreaterThan(1000);
  });
});
