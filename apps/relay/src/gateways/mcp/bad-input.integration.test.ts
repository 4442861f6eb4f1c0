/** Responses to agents that send invalid messages. */
import { testEndpoints } from "../../testing/bad-input.cases.ts";
import { bodies, requesting, type Attempt, type Target } from "../../testing/endpoints.ts";

const KIB = 1024;
const SITE = "";

const pathOf = ({ robot }: Target) => ({ path: `/r/${robot.id}/mcp` });
const act = (args: object): string =>
  JSON.stringify({
    jsonrpc: "2.0",
    id: 1,
    method: "tools/call",
    params: { name: "act", arguments: args },
  });

testEndpoints({
  "a call of an agent": {
    attempts: {
      ...bodies(act({ action: "move", distance: 40 }), 16 * KIB, pathOf, SITE),
      // A result, although the relay has requested nothing.
      "wrong order": async (place) => {
        const send = (body: string): Attempt =>
          requesting(() => ({ ...pathOf(place), method: "POST", body }), SITE);
        const result = { jsonrpc: "2.0", id: 7, result: {} };
        return send(JSON.stringify(result))(place);
      },
      "a key of another robot": requesting(
        (place) => ({
          ...pathOf(place),
          method: "POST",
          body: act({ action: "stop" }),
          headers: { Authorization: `Bearer ${place.other.driverKey}` },
        }),
        SITE,
      ),
    },
    answers: {
      "too large": "413 too-large | 16 KiB",
      deep: "400 bad-request | one message: an object",
      "prototype keys": "400 bad-request | no field of this name",
      NaN: "400 bad-request | a JSON document",
      Infinity: "200 | distance: found",
      "2^53 + 1": "200 | distance: found",
      "1e308": "200 | distance: found",
      "wrong UTF-8": "400 bad-request | JSON document in UTF-8",
      "wrong order": "400 bad-request | method",
      "half-closed": "400 bad-request | incomplete",
      "a key of another robot": "401 not-authorised | after the #",
    },
  },
});
