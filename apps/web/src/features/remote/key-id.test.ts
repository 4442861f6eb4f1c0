import { createHash } from "node:crypto";
import fc from "fast-check";
import { expect, it } from "vitest";
import { keyIdOf } from "./key-id.ts";

const idByNode = (key: string): string =>
  createHash("sha256").update(key).digest("base64url").slice(0, 6);

it("computes the same key id as the service", () => {
  expect(keyIdOf("drv_AAAAAAAAAAAAAAAAAAAAAA")).toBe(idByNode("drv_AAAAAAAAAAAAAAAAAAAAAA"));
  fc.assert(
    fc.property(fc.string({ unit: "binary", maxLength: 300 }), (key) => {
      expect(keyIdOf(key)).toBe(idByNode(key));
    }),
  );
});

it("computes ids of keys of any length around the hash block size", () => {
  for (let length = 0; length < 140; length++) {
    const key = "k".repeat(length);
    expect(keyIdOf(key)).toBe(idByNode(key));
  }
});
