/** Invalid requests result in problem documents. */
import { problemSchema, type ProblemDocument } from "@corridor/protocol";
import type { CheckGroup } from "../check.ts";
import type { HttpResponse } from "../host.ts";
import { must, validate } from "../mismatch.ts";
import { mustHaveReadings, readings } from "../pen.ts";

/** Invalid request bodies, by the name of their error. */
const wrongBodies: Record<string, { body: string | Uint8Array; path?: string }> = {
  "no JSON": { body: '{"action":' },
  nothing: { body: "" },
  null: { body: "null" },
  "a list": { body: "[]" },
  "an unknown action": { body: '{"action":"fly"}', path: "action" },
  "a missing number": { body: '{"action":"move"}', path: "distance" },
  "a text for a number": { body: '{"action":"move","distance":"far"}', path: "distance" },
  "a huge number": { body: '{"action":"move","distance":1e308}', path: "distance" },
  infinity: { body: '{"action":"move","distance":1e999}', path: "distance" },
  "wheels too strong": { body: '{"action":"drive","left":2,"right":0}', path: "left" },
  "a distance beyond the largest maze": {
    body: '{"action":"move","distance":25601}',
    path: "distance",
  },
  "ten turns and more": { body: '{"action":"turn","degrees":-3601}', path: "degrees" },
  "more than a minute": {
    body: '{"action":"drive","left":0,"right":0,"milliseconds":60001}',
    path: "milliseconds",
  },
  "a lease of minutes": {
    body: '{"action":"drive","left":0,"right":0,"lease":60000}',
    path: "lease",
  },
  "a field too many": { body: '{"action":"stop","now":true}', path: "now" },
  "a prototype key": { body: '{"action":"stop","__proto__":{"x":1}}' },
  "bytes that are no UTF-8": { body: Buffer.from('{"action":"\xff"}', "latin1") },
  "deep nesting": { body: `${"[".repeat(5_000)}${"]".repeat(5_000)}` },
};

export const invalidInput: CheckGroup = {
  title: "Invalid input",
  checks: [
    {
      promise: "bad-command",
      name: "an invalid command is rejected with 400, and the errors name the field",
      run: async (host) => {
        for (const [what, { body, path }] of Object.entries(wrongBodies)) {
          const response = await host.request("/commands", { method: "POST", body });
          const problem = problemIn(response, 400, what);
          if (path === undefined) continue;
          const paths = problem.errors.map((error) => error.path);
          must(paths.includes(path), `errors to name ${path} for ${what}`, problem.errors);
        }
      },
    },
    {
      promise: "body-size",
      name: "a body above 16 KiB is rejected with 413",
      run: async (host) => {
        const body = JSON.stringify({ action: "stop", words: "x".repeat(17 * 1024) });
        problemIn(await host.request("/commands", { method: "POST", body }), 413, "a large body");
      },
    },
    {
      promise: "body-type",
      name: "a body whose Content-Type is not JSON is rejected with 415",
      run: async (host) => {
        const headers = { "Content-Type": "text/plain" };
        const options = { method: "POST", body: '{"action":"stop"}', headers };
        problemIn(await host.request("/commands", options), 415, "plain text");
      },
    },
    {
      promise: "bad-query",
      name: "invalid waits and numbers are rejected with 400",
      run: async (host) => {
        for (const path of [
          "/sensors?wait=26",
          "/sensors?wait=-1",
          "/sensors?after=now",
          "/commands?after=-1",
          "/commands/first",
          "/events?wait=soon",
        ]) {
          problemIn(await host.request(path), 400, path);
        }
      },
    },
    {
      promise: "no-command",
      name: "an unknown command is 404",
      run: async (host) => {
        problemIn(await host.request("/commands/900000000000000"), 404, "a number of the future");
      },
    },
    {
      promise: "no-path",
      name: "an unknown path is 404, an unknown method 405",
      run: async (host) => {
        problemIn(await host.request("/wheels"), 404, "/wheels");
        const response = await host.request("/sensors", { method: "DELETE" });
        problemIn(response, 405, "DELETE /sensors");
        const allowed = response.header("allow");
        must(allowed.includes("GET"), "the header Allow with GET", allowed || "none");
      },
    },
    {
      promise: "bad-survived",
      name: "a rejected command does not move the robot, which accepts later commands",
      run: async (host) => {
        const before = await readings(host);
        for (const { body } of Object.values(wrongBodies)) {
          await host.request("/commands", { method: "POST", body });
        }
        const turn = await host.sendAndWait({ action: "left 90" });
        must(turn.state === "completed", "completed", turn);
        await host.sendAndWait({ action: "right 90" });
        await mustHaveReadings(host, before, "at the position before the command");
      },
    },
  ],
};

/**
 * The problem document (RFC 9457) of a response.
 * @throws Mismatch if the status or the document differs
 */
function problemIn(response: HttpResponse, status: number, what: string): ProblemDocument {
  must(response.status === status, `${status} for ${what}`, `${response.status} ${response.text}`);
  const type = response.header("content-type");
  must(type.startsWith("application/problem+json"), "Content-Type: application/problem+json", type);
  const problem = validate(problemSchema, response.json, `a problem document for ${what}`);
  must(problem.status === status, `status ${status} in the document`, problem.status);
  must(problem.detail.length > 10, "a sentence in detail", problem.detail);
  const leak = /\bat \w+.*:\d+:\d+|Traceback|node_modules/.exec(response.text);
  must(leak === null, "a document without a stack trace or a path", leak?.[0]);
  return problem;
}
