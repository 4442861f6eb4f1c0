import { describe, expect, it } from "vitest";
import { processorMs, processorMsIn, residentKiB, residentKiBIn } from "./process-figures.ts";

describe("what a process has cost", () => {
  it("is its time as a user and in the kernel, whatever the program is called", () => {
    const text =
      "4711 (a (bad) name) S 1 4711 4711 0 -1 4194304 2563 0 12 0 345 67 0 0 20 0 11 0 99 1 2";
    expect(processorMsIn(text)).toBe(4120);
  });

  it("is the memory that it has in use", () => {
    expect(residentKiBIn("VmPeak:\t  900 kB\nVmRSS:\t   5120 kB\nRssAnon:\t 12 kB\n")).toBe(5120);
    expect(residentKiBIn("")).toBeNaN();
  });

  it.runIf(process.platform === "linux")("is read of a process that runs", () => {
    expect(processorMs(process.pid)).toBeGreaterThan(0);
    expect(residentKiB(process.pid)).toBeGreaterThan(1000);
  });
});
