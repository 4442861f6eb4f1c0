import { describe, expect, it } from "vitest";
import { InputError } from "../input-error.ts";
import { bridgeArguments, listenOptions, readListenAddress } from "./bridge-arguments.ts";

const ADDRESS = "https://robots.example.org/r/0123456789abcdefghijkl#drv_0123456789";
const OTHER = ADDRESS.replace("example", "elsewhere");

/** The lines of the InputError that a call throws. */
function problemsOf(call: () => unknown): string {
  try {
    call();
  } catch (error) {
    if (error instanceof InputError) return error.lines.join("\n");
    throw error;
  }
  throw new Error("no InputError");
}

describe("the address of a bridge", () => {
  it.each([
    { from: "the argument", args: [ADDRESS], environment: {} },
    { from: "the variable", args: [], environment: { CORRIDOR_ROBOT: ADDRESS } },
    { from: "the argument first", args: [ADDRESS], environment: { CORRIDOR_ROBOT: OTHER } },
  ])("comes from $from", ({ args, environment }) => {
    expect(bridgeArguments(args, listenOptions, environment).address).toBe(ADDRESS);
  });

  it.each([
    { name: "nothing", args: [], expected: "found nothing" },
    { name: "two addresses", args: [ADDRESS, OTHER], expected: "found 2 arguments" },
    { name: "no key", args: [ADDRESS.split("#")[0] ?? ""], expected: "The key after the #" },
    { name: "another URL", args: [`${ADDRESS}/ros`], expected: "An address looks like" },
    { name: "an unknown option", args: [`--robot=${ADDRESS}`], expected: "'--robot'" },
    { name: "a value of a flag", args: [ADDRESS, `--help=${ADDRESS}`], expected: "'--help'" },
  ])("is missed in $name, and no key is printed", ({ args, expected }) => {
    const problems = problemsOf(() => bridgeArguments(args, listenOptions, {}));
    expect(problems).toContain(expected);
    expect(problems).not.toContain("drv_");
  });
});

describe("the place where a bridge listens", () => {
  const read = (...args: string[]) =>
    readListenAddress(bridgeArguments([ADDRESS, ...args], listenOptions, {}).values, 9090);

  it("is this computer and the default port unless an option says otherwise", () => {
    expect(read()).toEqual({ host: "127.0.0.1", port: 9090 });
    expect(read("--host", "0.0.0.0", "--port", "0")).toEqual({ host: "0.0.0.0", port: 0 });
  });

  it.each(["", "no", "-1", "1.5", "65536"])("refuses the port %j", (port) => {
    expect(problemsOf(() => read(`--port=${port}`))).toContain("expected a number from 0 to 65535");
  });
});
