/** Access: only the key of the address is accepted. */
import type { CheckGroup } from "../check.ts";
import type { Host, HttpResponse } from "../host.ts";
import { describeError, must, NoAccess, show, valueAt } from "../mismatch.ts";

export const access: CheckGroup = {
  title: "Keys",
  checks: [
    {
      promise: "key-address",
      name: "the key of the address reads and drives the robot",
      run: async (host) => {
        const expected = "200 for GET /commands with the key";
        const { status, json } = await answerOf(host, "/commands?after=0", expected);
        const hasNoRobot = valueAt(json, "type") === "/problems/no-robot";
        if (status === 401 || status === 403 || hasNoRobot) {
          const detail = show(valueAt(json, "detail") ?? "without a detail");
          throw new NoAccess(expected, `${status}: ${detail}`);
        }
        must(status === 200, expected, status);
      },
    },
    {
      promise: "key-required",
      name: "without a key the response is 401 with WWW-Authenticate: Bearer",
      run: async (host) => {
        for (const path of ["/sensors", "/commands?after=0", "/events?wait=0"]) {
          const response = await host.request(path, { key: null });
          must(response.status === 401, `401 for ${path} without a key`, response.status);
          const challenge = response.header("www-authenticate");
          must(
            /^bearer/i.test(challenge),
            "the header WWW-Authenticate: Bearer",
            challenge || "none",
          );
        }
      },
    },
    {
      promise: "key-wrong",
      name: "a command with a wrong key is rejected with 401 or 403",
      run: async (host) => {
        const options = { method: "POST", body: { action: "stop" }, key: host.wrongKey };
        const response = await host.request("/commands", options);
        must([401, 403].includes(response.status), "401 or 403 for a wrong key", response.status);
      },
    },
    {
      promise: "key-wrong-reading",
      name: "with a wrong key, sensors, events and the command log are rejected with 401 or 403",
      run: async (host) => {
        for (const path of ["/sensors", "/commands?after=0", "/events?wait=0", "/events"]) {
          const response = await host.request(path, { key: host.wrongKey });
          const isRejected = [401, 403].includes(response.status);
          must(isRejected, `401 or 403 for ${path} with a wrong key`, response.status);
        }
      },
    },
    {
      promise: "key-secret",
      name: "no response contains the key that was sent",
      run: async (host) => {
        const response = await host.request("/commands", { key: host.wrongKey });
        must(!response.text.includes(host.wrongKey), "a problem without the key", response.text);
      },
    },
    {
      promise: "features",
      name: "the host lists the features that it does not offer, and only optional ones",
      run: async (host) => {
        const { notOffered } = await host.features();
        const names = notOffered.map(({ feature }) => feature);
        must(new Set(names).size === names.length, "each feature once", names);
      },
    },
  ],
};

/** @throws NoAccess if the host cannot be reached */
async function answerOf(host: Host, path: string, expected: string): Promise<HttpResponse> {
  try {
    return await host.request(path);
  } catch (error) {
    throw new NoAccess(expected, describeError(error));
  }
}
