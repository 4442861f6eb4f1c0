import { encode } from "uqr";
import { describe, expect, it } from "vitest";
import { qrPath } from "./qr-path.ts";

/** Converts the path back into modules. */
function modulesOf(path: string, size: number): boolean[][] {
  const grid = Array.from({ length: size }, () => Array<boolean>(size).fill(false));
  for (const [, x, y, length] of path.matchAll(/M(\d+) (\d+)h(\d+)v1h-\3z/g)) {
    grid[Number(y)]?.fill(true, Number(x), Number(x) + Number(length));
  }
  return grid;
}

describe("qrPath", () => {
  it.each(["a", "https://corridor.example/#m1.AAAA", "x".repeat(2_000)])(
    "draws exactly the modules of the code of %.40s",
    (text) => {
      const code = qrPath(text);
      const { data, size } = encode(text, { ecc: "L", border: 4 });
      expect(code?.size).toBe(size);
      expect(modulesOf(code?.path ?? "", size)).toEqual(data);
      expect(data.slice(0, 4).flat().includes(true)).toBe(false);
    },
  );

  it("fits 2,953 bytes and reports a longer text", () => {
    expect(qrPath("x".repeat(2_953))).not.toBeNull();
    expect(qrPath("x".repeat(2_954))).toBeNull();
    expect(qrPath("ä".repeat(1_500))).toBeNull();
  });
});
