/** The gateway for AI agents: tools of the Model Context Protocol. */
import { commandRecordSchema, snapshotSchema } from "@corridor/protocol";
import type { CheckGroup } from "../../check.ts";
import type { Host } from "../../host.ts";
import { must, validate, valueAt } from "../../mismatch.ts";
import { areNear, moved, moveToStart, mustHaveReadings, readings, show } from "../../pen.ts";

const tools = ["sense", "look", "wait", "act", "stop", "reset"];

export const mcp: CheckGroup = {
  title: "MCP gateway",
  gateway: "mcp",
  checks: [
    {
      promise: "mcp-key",
      name: "a missing or wrong key is rejected with 401 and WWW-Authenticate: Bearer",
      run: async (host) => {
        for (const key of [null, host.wrongKey]) {
          const response = await post(host, "tools/list", {}, key);
          const which = key === null ? "without a key" : "for a wrong key";
          must(response.status === 401, `401 ${which}`, response.status);
          const challenge = response.header("www-authenticate");
          must(/^bearer/i.test(challenge), "the header WWW-Authenticate: Bearer", challenge);
        }
      },
    },
    {
      promise: "mcp-post",
      name: "GET and DELETE are rejected with 405",
      run: async (host) => {
        for (const method of ["GET", "DELETE"]) {
          const { status } = await host.requestUrl(host.gatewayUrl("mcp"), { method });
          must(status === 405, `405 for ${method}`, status);
        }
      },
    },
    {
      promise: "mcp-tools",
      name: `a driver's key lists the tools ${tools.join(", ")}, in this order`,
      run: async (host) => {
        const result = await resultOf(host, "tools/list");
        const listed = valueAt(result, "tools");
        must(Array.isArray(listed), "a list of tools", result);
        const names = listed.map((tool: unknown) => valueAt(tool, "name"));
        must(names.join() === tools.join(), tools.join(", "), names);
      },
    },
    {
      promise: "mcp-sense",
      name: "sense answers with text, and the snapshot in `structuredContent`",
      run: async (host) => {
        const result = await call(host, "sense");
        const text = valueAt(result, "content.0.text");
        must(typeof text === "string" && text !== "", "a text", result);
        const content = valueAt(result, "structuredContent.snapshot");
        const { sensors } = validate(snapshotSchema, content, "a snapshot");
        const expected = await readings(host);
        must(areNear(sensors, expected), `about ${show(expected)}`, show(sensors));
      },
    },
    {
      promise: "mcp-act",
      name: "act answers after the end of its command, and a repeated `key` moves the robot once",
      run: async (host) => {
        await moveToStart(host);
        const before = await readings(host);
        const order = { action: "move", distance: 60, key: host.newKey() };
        const first = await act(host, order);
        must(first.state === "completed", "completed", first);
        const second = await act(host, order);
        must(second.seq === first.seq, `the record ${first.seq} again`, second.seq);
        await mustHaveReadings(host, moved(before, 60), "after one move of 60 cm");
      },
    },
    {
      promise: "mcp-refusal",
      name: "a refused command is a result with `isError` and a sentence",
      run: async (host) => {
        const result = await call(host, "act", { action: "fly" });
        must(valueAt(result, "isError") === true, "isError true", result);
        const text = valueAt(result, "content.0.text");
        must(typeof text === "string" && text.includes("fly"), "what was wrong", text ?? result);
      },
    },
  ],
};

async function act(host: Host, order: object) {
  const result = await call(host, "act", order);
  const record = valueAt(result, "structuredContent.record");
  return validate(commandRecordSchema, record, "a command record");
}

async function call(host: Host, name: string, args: object = {}): Promise<unknown> {
  return resultOf(host, "tools/call", { name, arguments: args });
}

async function resultOf(host: Host, method: string, params: object = {}): Promise<unknown> {
  const { status, text, json } = await post(host, method, params);
  const result = valueAt(json, "result");
  must(status === 200 && result !== undefined, `a result of ${method}`, `${status} ${text}`);
  return result;
}

/** Sends one message, as clients of 2025 do. */
async function post(host: Host, method: string, params: object, key?: string | null) {
  return host.requestUrl(host.gatewayUrl("mcp"), {
    method: "POST",
    ...(key !== undefined && { key }),
    headers: {
      Accept: "application/json, text/event-stream",
      "MCP-Protocol-Version": "2025-06-18",
    },
    body: { jsonrpc: "2.0", id: 1, method, params },
  });
}
