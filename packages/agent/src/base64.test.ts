import { expect, it } from "vitest";
import { base64Of } from "./base64.ts";

it.each([0, 1, 2, 3, 4, 255, 256])("encodes %i bytes as Node.js does", (length) => {
  const bytes = Uint8Array.from({ length }, (_, index) => (index * 37) % 256);
  expect(base64Of(bytes)).toBe(Buffer.from(bytes).toString("base64"));
});
