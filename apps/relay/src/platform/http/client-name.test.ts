import { describe, expect, it } from "vitest";
import { clientName } from "./client-name.ts";

describe("clientName", () => {
  it.each([
    ["Python-urllib/3.11", "Python"],
    ["python-requests/2.32", "Python"],
    ["node", "JavaScript"],
    ["undici", "JavaScript"],
    ["Java-http-client/17.0.15", "Java"],
    ["curl/8.9.1", "curl"],
    ["Mozilla/5.0 (X11; Linux x86_64)", "Browser"],
    ["<img src=x onerror=alert(1)>", "Script"],
    ["", "Script"],
    [undefined, "Script"],
  ])("displays %s as %s", (userAgent, name) => {
    expect(clientName(userAgent)).toBe(name);
  });
});
