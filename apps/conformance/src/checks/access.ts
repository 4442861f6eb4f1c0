/** Access: only the key of the address is accepted. */
import type { CheckGroup } from "../check.ts";
import { must } from "../mismatch.ts";

export const access: CheckGroup = {
  title: "The key",
  checks: [
    {
      promise: "key-address",
      name: "the address and its key reach the robot",
      run: async (host) => {
        const answer = await host.ask("/commands?after=0");
        must(answer.status === 200, "200 for GET /commands with the key", answer.status);
      },
    },
    {
      promise: "key-required",
      name: "without a key there is no answer but 401, which asks for a bearer key",
      run: async (host) => {
        for (const path of ["/sensors", "/commands?after=0", "/events?wait=0"]) {
          const answer = await host.ask(path, { key: null });
          must(answer.status === 401, `401 for ${path} without a key`, answer.status);
          const asks = answer.header("www-authenticate");
          must(/^bearer/i.test(asks), "the header WWW-Authenticate: Bearer", asks || "none");
        }
      },
    },
    {
      promise: "key-wrong",
      name: "a wrong key commands nothing",
      run: async (host) => {
        const options = { method: "POST", body: { action: "stop" }, key: host.wrongKey };
        const answer = await host.ask("/commands", options);
        must([401, 403].includes(answer.status), "401 or 403 for a wrong key", answer.status);
      },
    },
    {
      promise: "key-wrong-reading",
      name: "with a wrong key, sensors, events and the command log are rejected with 401 or 403",
      run: async (host) => {
        for (const path of ["/sensors", "/commands?after=0", "/events?wait=0", "/events"]) {
          const answer = await host.ask(path, { key: host.wrongKey });
          const isRefused = [401, 403].includes(answer.status);
          must(isRefused, `401 or 403 for ${path} with a wrong key`, answer.status);
        }
      },
    },
    {
      promise: "key-secret",
      name: "no answer repeats the key that was sent",
      run: async (host) => {
        const answer = await host.ask("/commands", { key: host.wrongKey });
        must(!answer.text.includes(host.wrongKey), "a problem without the key", answer.text);
      },
    },
    {
      promise: "features",
      name: "the host lists what it does not offer, and only what a host may do without",
      run: async (host) => {
        const { notOffered } = await host.features();
        const names = notOffered.map(({ feature }) => feature);
        must(new Set(names).size === names.length, "each feature once", names);
      },
    },
  ],
};
