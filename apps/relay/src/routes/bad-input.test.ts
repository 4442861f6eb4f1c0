/** What HTTP requests get that are wrong in their body, headers, path or query. */
import { sendBare } from "../testing/bare-http.ts";
import { testDoors } from "../testing/bad-input.cases.ts";
import { asking, bodies, reading, toldBy, type Knock, type Place } from "../testing/doors.ts";
import { maze } from "../testing/sample-documents.ts";

const KIB = 1024;
const STOP = '{"action":"stop"}';
const LONG = "1".repeat(9 * KIB);

const keyOf = (key: string) => ({ Authorization: `Bearer ${key}` });
const commandsOf = ({ robot }: Place) => ({ path: `/robots/${robot.id}/commands` });

testDoors({
  "a command": {
    knocks: {
      ...bodies('{"action":"move","distance":40}', 16 * KIB, commandsOf),
      "wrong order": async (place) => {
        const headers = { "Idempotency-Key": "the-same-key" };
        const send = (body: string): Knock =>
          asking(() => ({ ...commandsOf(place), method: "POST", headers, body }));
        await send(STOP)(place);
        return send('{"action":"left 90"}')(place);
      },
      "a key of another robot": asking((place) => ({
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
      "half-closed": "400 bad-request | cut off",
      "a key of another robot": "401 not-authorised | after the #",
    },
  },

  "a header": {
    knocks: {
      "too large": reading("/sensors", { "Script-Name": LONG }),
      deep: reading("/events?wait=0", { "Last-Event-ID": "[[[[[[[[]]]]]]]]-1" }),
      "prototype keys": asking((place) => ({
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
        sendBare(relay.origin, "GET / HTTP/1.1\r\nHo", true).then(toldBy),
      "a key of another robot": asking((place) => ({
        path: `/robots/${place.robot.id}/sensors`,
        headers: keyOf(place.other.ownerKey),
      })),
    },
    answers: {
      "too large": "431 headers-too-large | 8 KiB",
      deep: "400 bad-request | STREAM-n",
      // Eight letters or more are a key, whatever they mean elsewhere.
      "prototype keys": '202 | "key":"__proto__"',
      NaN: "400 bad-request | STREAM-n",
      Infinity: "400 bad-request | STREAM-n",
      "2^53 + 1": "400 bad-request | STREAM-n",
      "1e308": "400 bad-request | STREAM-n",
      "wrong UTF-8": "400 bad-request | STREAM-n",
      "wrong order": '200 | "gap":{"n":0',
      "half-closed": "400 bad-request | cut off",
      "a key of another robot": "401 not-authorised | after the #",
    },
  },

  "a path": {
    knocks: {
      "too large": reading(`/commands/${LONG}`),
      deep: reading("/commands".repeat(500)),
      "prototype keys": reading("/commands/__proto__"),
      NaN: reading("/commands/NaN"),
      Infinity: reading("/commands/Infinity"),
      "2^53 + 1": reading("/commands/9007199254740993"),
      "1e308": reading("/commands/1e308"),
      "wrong UTF-8": reading("/commands/%C3%28"),
      "wrong order": reading("/commands/40"),
      "half-closed": asking(({ robot }) => ({ path: `/robots/${robot.id}`, isCutOff: true })),
      "a key of another robot": asking(({ robot, other }) => ({
        path: `/robots/${other.id}/commands/1`,
        headers: keyOf(robot.driverKey),
      })),
    },
    answers: {
      "too large": "431 headers-too-large | 8 KiB",
      deep: "404 not-found | Check the address",
      "prototype keys": "400 bad-request | whole number",
      NaN: "400 bad-request | whole number",
      Infinity: "400 bad-request | whole number",
      "2^53 + 1": "400 bad-request | at most 15 digits",
      "1e308": "400 bad-request | whole number",
      "wrong UTF-8": "400 bad-request | damaged",
      "wrong order": "404 no-command | 40",
      "half-closed": "400 bad-request | cut off",
      "a key of another robot": "401 not-authorised | after the #",
    },
  },

  "a query of events": {
    knocks: {
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
      "a key of another robot": asking(({ robot, other }) => ({
        path: `/robots/${robot.id}/events`,
        headers: keyOf(other.driverKey),
      })),
    },
    answers: {
      "too large": "431 headers-too-large | 8 KiB",
      deep: "400 bad-request | STREAM-n",
      // A name that nobody knows is let through, as by HTTP services everywhere.
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
    knocks: {
      ...bodies(JSON.stringify(maze).replace('"column":1', '"column":40'), 64 * KIB, () => ({
        path: "/mazes",
      })),
      "wrong order": asking(() => ({ method: "DELETE", path: "/mazes/AAAAAAAAAAAA" })),
      // The key of a robot deletes no document.
      "a key of another robot": async (place) => {
        const body = JSON.stringify(maze);
        const stored = await asking(() => ({ method: "POST", path: "/mazes", body }))(place);
        const { id } = JSON.parse(stored.says) as { id: string };
        return asking(() => ({ method: "DELETE", path: `/mazes/${id}` }))(place);
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
      "half-closed": "400 bad-request | cut off",
      "a key of another robot": "401 not-authorised | key",
    },
  },

  "a pairing code": {
    knocks: {
      ...bodies('{"code":40}', 16 * KIB, () => ({ path: "/pairing" })),
      "wrong order": asking(() => ({
        path: "/pairing",
        headers: keyOf("drv_AAAAAAAAAAAAAAAAAAAAAA"),
      })),
      "a key of another robot": asking(({ robot, other }) => ({
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
      "wrong order": "404 no-pairing | Make a new code",
      "half-closed": "400 bad-request | cut off",
      "a key of another robot": "401 not-authorised | after the #",
    },
  },

  "a new key": {
    knocks: {
      ...bodies('{"kind":40}', 16 * KIB, ({ robot }) => ({
        path: `/robots/${robot.id}/keys`,
        headers: keyOf(robot.ownerKey),
      })),
      "a key of another robot": asking(({ robot, other }) => ({
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
      "half-closed": "400 bad-request | cut off",
      "a key of another robot": "401 not-authorised | after the #",
    },
  },
});
