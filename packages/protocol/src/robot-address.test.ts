import { readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { readRobotAddress } from "./robot-address.ts";
import { robotAddresses } from "./testing/index.ts";

const { good, bad } = robotAddresses;

const EXAMPLES = join(import.meta.dirname, "../../../examples");

describe("readRobotAddress", () => {
  it.each(good)("reads $text", ({ text, ...parts }) => {
    expect(readRobotAddress(text)).toEqual(parts);
  });

  it.each(bad)("finds no address with a key in %j", (text) => {
    expect(readRobotAddress(text)?.key ?? null).toBeNull();
  });

  it.each(["", "#"])("reads an address whose key is missing: it ends with %j", (end) => {
    const address = readRobotAddress(`http://localhost/r/blue-otter-42${end}`);
    expect(address).toEqual({ origin: "http://localhost", id: "blue-otter-42", key: null });
  });

  it("does not read a very long text", () => {
    expect(readRobotAddress(`http://${"x".repeat(400)}/r/1#drv_AAAA`)).toBeNull();
  });
});

describe.each([
  { file: "csharp/Robot.cs", pattern: /@"(\^\(https[^"]+)"/ },
  { file: "curl/right_wall.sh", pattern: /^pattern='(.+)'$/m },
  { file: "go/robot.go", pattern: /MustCompile\(`(\^\(https[^`]+)`/ },
  { file: "java/Robot.java", pattern: /Pattern\.compile\("(\(https[^"]+)"/ },
])("the example $file", ({ file, pattern }) => {
  const [, source = ""] = pattern.exec(readFileSync(join(EXAMPLES, file), "utf8")) ?? [];
  const expression = source.replaceAll("\\\\", "\\").replaceAll("[:space:]", "\\s");
  const address = new RegExp(`^(?:${expression})$`);

  it("accepts the same addresses", () => {
    expect(expression).not.toBe("");
    for (const { text, origin, id, key } of good) {
      expect(address.exec(text)?.slice(1)).toEqual([origin, id, key]);
    }
    for (const text of bad) expect(address.test(text)).toBe(false);
  });
});
