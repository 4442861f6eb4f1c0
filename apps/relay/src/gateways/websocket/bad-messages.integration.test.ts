/** Responses to invalid messages of pages and scripts, by WebSocket and long polling. */
import { testEndpoints } from "../../testing/bad-input.cases.ts";
import {
  requesting,
  bodies,
  sending,
  greeting,
  messages,
  openedConnection,
} from "../../testing/endpoints.ts";
import { completed } from "../../platform/testing/messages.ts";

const KIB = 1024;
const STOP = '{"action":"stop"}';
const HELLO = { type: "hello", version: 1 };
const RESUME = { type: "resume", lastApplied: 0, fresh: false, endings: [] };

testEndpoints({
  "a page's WebSocket": {
    attempts: {
      ...messages("page", { type: "ended", epoch: 1, ...completed(40) }),
      "wrong order": sending("page", (page) => page.send(RESUME)),
      "half-closed": sending("page", (page) => page.halfClose()),
      "a key of another robot": greeting(({ other }) => ({
        ...HELLO,
        role: "own",
        key: other.ownerKey,
      })),
    },
    answers: {
      "too large": "1009 | too large",
      deep: "4400 | expected one of",
      "prototype keys": "4400 | no field of this name",
      NaN: "4400 | a JSON document",
      Infinity: "4400 | seq",
      "2^53 + 1": "4400 | seq",
      "1e308": "4400 | seq",
      "wrong UTF-8": "1007 | UTF-8",
      "wrong order": "4400 | expected one of snapshot, started, ended",
      // A closed connection receives no response.
      "half-closed": "1006",
      "a key of another robot": "4401 | Copy the robot's address again",
    },
  },

  "a script's WebSocket": {
    attempts: {
      ...messages("script", { type: "command", command: { action: "move", distance: 40 } }),
      "wrong order": greeting(() => ({ type: "command", command: { action: "stop" } })),
      "half-closed": sending("script", (script) => script.halfClose()),
      "a key of another robot": greeting(({ other }) => ({
        ...HELLO,
        role: "drive",
        key: other.driverKey,
      })),
    },
    answers: {
      "too large": "1009 | too large",
      deep: "400 bad-request | command, seen",
      "prototype keys": "400 bad-request | no field of this name",
      NaN: "400 bad-request | a JSON document",
      Infinity: "400 bad-request | distance",
      "2^53 + 1": "400 bad-request | distance",
      "1e308": "400 bad-request | distance",
      "wrong UTF-8": "1007 | UTF-8",
      "wrong order": '4401 | type: found "command", expected "hello"',
      "half-closed": "1006",
      "a key of another robot": "4401 | Copy the robot's address again",
    },
  },

  "a line by HTTPS": {
    attempts: {
      ...bodies('{"first":40,"messages":[]}', 16 * KIB, (place) =>
        openedConnection(place, place.robot),
      ),
      "wrong order": requesting(async (place) => ({
        ...(await openedConnection(place, place.robot)),
        body: `{"first":9,"messages":[{"type":"command","command":${STOP}}]}`,
      })),
      "a key of another robot": requesting(async (place) => ({
        ...(await openedConnection(place, place.other)),
        path: `/robots/${place.robot.id}/long-poll/messages`,
        body: '{"first":1,"messages":[]}',
      })),
    },
    answers: {
      "too large": "413 too-large | 16 KiB",
      deep: "400 bad-request | an object",
      "prototype keys": "400 bad-request | no field of this name",
      NaN: "400 bad-request | a JSON document",
      Infinity: "400 bad-request | first",
      "2^53 + 1": "400 bad-request | first",
      "1e308": "400 bad-request | first",
      "wrong UTF-8": "400 bad-request | JSON document in UTF-8",
      "wrong order": '200 | {"taken":0}',
      "half-closed": "400 bad-request | incomplete",
      "a key of another robot": "404 no-connection | Open a new one",
    },
  },

  "a hello by HTTPS": {
    attempts: {
      ...bodies(
        '{"type":"hello","version":40,"role":"drive","key":"drv_"}',
        16 * KIB,
        ({ robot }) => ({
          path: `/robots/${robot.id}/long-poll`,
        }),
      ),
      "a key of another robot": requesting(({ robot, other }) => ({
        method: "POST",
        path: `/robots/${robot.id}/long-poll`,
        body: JSON.stringify({ ...HELLO, role: "drive", key: other.driverKey }),
      })),
    },
    answers: {
      "too large": "413 too-large | 16 KiB",
      deep: "400 bad-request | an object",
      "prototype keys": "400 bad-request | no field of this name",
      NaN: "400 bad-request | a JSON document",
      Infinity: "400 bad-request | version",
      "2^53 + 1": "400 bad-request | version",
      "1e308": "400 bad-request | version",
      "wrong UTF-8": "400 bad-request | JSON document in UTF-8",
      "wrong order": null,
      "half-closed": "400 bad-request | incomplete",
      "a key of another robot": "401 not-authorised | after the #",
    },
  },
});
