/** Responses to HTTP requests with an invalid body, header, path or query. */
import { sendBare } from "../../platform/testing/bare-http.ts";
import { testEndpoints } from "../../testing/bad-input.cases.ts";
import {
  requesting,
  bodies,
  reading,
  outcomeOf,
  type Attempt,
  type Target,
} from "../../testing/endpoints.ts";
import { maze } from "../../platform/testing/sample-documents.ts";

const KIB = 1024;
const STOP = '{"action":"stop"}';
const LONG = "1".repeat(9 * KIB);

const keyOf = (key: string) => ({ Authorization: `Bearer ${key}` });
const commandsOf = ({ robot }: Target) => ({ path: `/robots/${robot.id}/commands` });

testEndpoints({
  "a command": {
    attempts: {
      ...bodies('{"action":"move","distance":40}', 16 * KIB, commandsOf),
      "wrong order": async (place) => {
        const headers = { "Idempotency-Key": "the-same-key" };
        const send = (body: string): Attempt =>
          requesting(() => ({ ...commandsOf(place), method: "POST", headers, body }));
        await send(STOP)(place);
        return send('{"action":"left 90"}')(place);
      },
      "a key of another robot": requesting((place) => ({
        ...commandsOf(place),
        method: "POST",
        body: STOP,
        headers: keyOf(place.other.driverKey),
      })),
    },
    answers: {
      "too large": "413 too-large | 16 KiB",
      deep: "400 bad-request | one of forward, reverse",
      "prototype keys": "400 bad-request | no field of this name",
      NaN: "400 bad-request | a JSON document",
      Infinity: "400 bad-request | distance",
      "2^53 + 1": "400 bad-request | distance",
      "1e308": "400 bad-request | distance",
      "wrong UTF-8": "400 bad-request | JSON document in UTF-8",
      "wrong order": "409 key-conflict | another command",
      "half-closed": "400 bad-request | incomplete",
      "a key of another robot": "401 not-authorised | after the #",
    },
  },

  "a header": {
    attempts: {
      "too large": reading("/sensors", { "Script-Name": LONG }),
      deep: reading("/events?wait=0", { "Last-Event-ID": "[[[[[[[[]]]]]]]]-1" }),
      "prototype keys": requesting((place) => ({
        ...commandsOf(place),
        method: "DELETE",
        headers: { "Idempotency-Key": "__proto__" },
      })),
      NaN: reading("/events?wait=0", { "Last-Event-ID": "AAAAAAAA-NaN" }),
      Infinity: reading("/events?wait=0", { "Last-Event-ID": "AAAAAAAA-Infinity" }),
      "2^53 + 1": reading("/events?wait=0", { "Last-Event-ID": "AAAAAAAA-9007199254740993" }),
      "1e308": reading("/events?wait=0", { "Last-Event-ID": "AAAAAAAA-1e308" }),
      "wrong UTF-8": reading("/events?wait=0", { "Last-Event-ID": "AAAAAAAA-\xff" }),
      "wrong order": reading("/events?wait=0", { "Last-Event-ID": "AAAAAAAA-999" }),
      "half-closed": ({ relay }) =>
        sendBare(relay.origin, "GET / HTTP/1.1\r\nHo", true).then(outcomeOf),
      "a key of another robot": requesting((place) => ({
        path: `/robots/${place.robot.id}/sensors`,
        headers: keyOf(place.other.ownerKey),
      })),
    },
    answers: {
      "too large": "431 headers-too-large | 8 KiB",
      deep: "400 bad-request | STREAM-n",
      // A key of at least eight characters is valid, whatever it means elsewhere.
      "prototype keys": '202 | "key":"__proto__"',
      NaN: "400 bad-request | STREAM-n",
      Infinity: "400 bad-request | STREAM-n",
      "2^53 + 1": "400 bad-request | STREAM-n",
      "1e308": "400 bad-request | STREAM-n",
      "wrong UTF-8": "400 bad-request | STREAM-n",
      "wrong order": '200 | "gap":{"n":0',
      "half-closed": "400 bad-request | incomplete",
      "a key of another robot": "401 not-authorised | after the #",
    },
  },

  "a path": {
    attempts: {
      "too large": reading(`/commands/${LONG}`),
      deep: reading("/commands".repeat(500)),
      "prototype keys": reading("/commands/__proto__"),
      NaN: reading("/commands/NaN"),
      Infinity: reading("/commands/Infinity"),
      "2^53 + 1": reading("/commands/9007199254740993"),
      "1e308": reading("/commands/1e308"),
      "wrong UTF-8": reading("/commands/%C3%28"),
      "wrong order": reading("/commands/40"),
      "half-closed": requesting(({ robot }) => ({ path: `/robots/${robot.id}`, isCutOff: true })),
      "a key of another robot": requesting(({ robot, other }) => ({
        path: `/robots/${other.id}/commands/1`,
        headers: keyOf(robot.driverKey),
      })),
    },
    answers: {
      "too large": "431 headers-too-large | 8 KiB",
      deep: "404 not-found | Check the path",
      "prototype keys": "400 bad-request | whole number",
      NaN: "400 bad-request | whole number",
      Infinity: "400 bad-request | whole number",
      "2^53 + 1": "400 bad-request | at most 15 digits",
      "1e308": "400 bad-request | whole number",
      "wrong UTF-8": "400 bad-request | malformed",
      "wrong order": "404 no-command | 40",
      "half-closed": "400 bad-request | incomplete",
      "a key of another robot": "401 not-authorised | after the #",
    },
  },

  "a query of events": {
    attempts: {
      "too large": reading(`/events?wait=0&after=${LONG}`),
      deep: reading("/events?wait[a][a][a][a]=1&wait=0&since=[[[[]]]]"),
      "prototype keys": reading("/events?wait=0&__proto__=1&constructor=2"),
      NaN: reading("/events?wait=NaN"),
      Infinity: reading("/events?wait=Infinity"),
      "2^53 + 1": reading("/events?wait=0&after=9007199254740993"),
      "1e308": reading("/events?wait=1e308"),
      "wrong UTF-8": reading("/events?wait=%C3%28"),
      "wrong order": reading("/events?wait=0&since=AAAAAAAA-40&after=40"),
      "half-closed": reading("/events?wait=0&since", { "Content-Length": "40" }),
      "a key of another robot": requesting(({ robot, other }) => ({
        path: `/robots/${robot.id}/events`,
        headers: keyOf(other.driverKey),
      })),
    },
    answers: {
      "too large": "431 headers-too-large | 8 KiB",
      deep: "400 bad-request | STREAM-n",
      // Unknown names are ignored, as is usual in HTTP services.
      "prototype keys": '200 | "states":[]',
      NaN: "400 bad-request | seconds to wait, from 0 to 25",
      Infinity: "400 bad-request | seconds to wait, from 0 to 25",
      "2^53 + 1": "400 bad-request | at most 15 digits",
      "1e308": "400 bad-request | seconds to wait, from 0 to 25",
      "wrong UTF-8": "400 bad-request | seconds to wait, from 0 to 25",
      "wrong order": '200 | "gap":{"n":0',
      "half-closed": "400 bad-request | STREAM-n",
      "a key of another robot": "401 not-authorised | after the #",
    },
  },

  "a short link": {
    attempts: {
      ...bodies(JSON.stringify(maze).replace('"column":1', '"column":40'), 64 * KIB, () => ({
        path: "/mazes",
      })),
      "wrong order": requesting(() => ({ method: "DELETE", path: "/mazes/AAAAAAAAAAAA" })),
      // The key of a robot cannot delete a document.
      "a key of another robot": async (place) => {
        const body = JSON.stringify(maze);
        const stored = await requesting(() => ({ method: "POST", path: "/mazes", body }))(place);
        const { id } = JSON.parse(stored.says) as { id: string };
        return requesting(() => ({ method: "DELETE", path: `/mazes/${id}` }))(place);
      },
    },
    answers: {
      "too large": "413 too-large | 64 KiB",
      deep: "400 bad-request | format",
      "prototype keys": "400 bad-request | no field of this name",
      NaN: "400 bad-request | a JSON document",
      Infinity: "400 bad-request | start.column",
      "2^53 + 1": "400 bad-request | start.column",
      "1e308": "400 bad-request | start.column",
      "wrong UTF-8": "400 bad-request | JSON document in UTF-8",
      "wrong order": "404 no-document | link",
      "half-closed": "400 bad-request | incomplete",
      "a key of another robot": "401 not-authorised | key",
    },
  },

  "a pairing code": {
    attempts: {
      ...bodies('{"code":40}', 16 * KIB, () => ({ path: "/pairing" })),
      "wrong order": requesting(() => ({
        path: "/pairing",
        headers: keyOf("drv_AAAAAAAAAAAAAAAAAAAAAA"),
      })),
      "a key of another robot": requesting(({ robot, other }) => ({
        method: "POST",
        path: `/robots/${robot.id}/pairing`,
        headers: keyOf(other.ownerKey),
      })),
    },
    answers: {
      "too large": "413 too-large | 16 KiB",
      deep: "400 bad-request | an object",
      "prototype keys": "400 bad-request | no field of this name",
      NaN: "400 bad-request | a JSON document",
      Infinity: "400 bad-request | code",
      "2^53 + 1": "400 bad-request | code",
      "1e308": "400 bad-request | code",
      "wrong UTF-8": "400 bad-request | JSON document in UTF-8",
      "wrong order": "404 no-pairing | Create a new code",
      "half-closed": "400 bad-request | incomplete",
      "a key of another robot": "401 not-authorised | after the #",
    },
  },

  "a new key": {
    attempts: {
      ...bodies('{"kind":40}', 16 * KIB, ({ robot }) => ({
        path: `/robots/${robot.id}/keys`,
        headers: keyOf(robot.ownerKey),
      })),
      "a key of another robot": requesting(({ robot, other }) => ({
        method: "POST",
        path: `/robots/${robot.id}/keys`,
        body: '{"kind":"drive"}',
        headers: keyOf(other.ownerKey),
      })),
    },
    answers: {
      "too large": "413 too-large | 16 KiB",
      deep: "400 bad-request | an object",
      "prototype keys": "400 bad-request | no field of this name",
      NaN: "400 bad-request | a JSON document",
      Infinity: "400 bad-request | kind",
      "2^53 + 1": "400 bad-request | kind",
      "1e308": "400 bad-request | kind",
      "wrong UTF-8": "400 bad-request | JSON document in UTF-8",
      "wrong order": null,
      "half-closed": "400 bad-request | incomplete",
      "a key of another robot": "401 not-authorised | after the #",
    },
  },
});
