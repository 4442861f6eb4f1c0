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
    ["corridor-ros/0.1.0", "ROS"],
    ["corridor-mcp/0.1.0", "MCP"],
    ["corridor-mms/1.2.3", "mms"],
    ["corridor-viple/0.1.0", "VIPLE"],
    ["corridor-fly/0.1.0", "Script"],
    ["Mozilla/5.0 (X11; Linux x86_64)", "Browser"],
    ["<img src=x onerror=alert(1)>", "Script"],
    ["", "Script"],
    [undefined, "Script"],
  ])("displays %s as %s", (userAgent, name) => {
    expect(clientName(userAgent)).toBe(name);
  });
});
